#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/output/results/nodal_values.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/feasible_set.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <fstream>
#include <functional>
#include <vector>

namespace stiction
{
  namespace
  {
    // One rank after the other adds its rows below the header, beside the file's place
    // until the last one has.
    void write_rows(const std::string &name, const std::string &header,
                    MPI_Comm communicator,
                    const std::function<void(std::ostream &)> &write)
    {
      const unsigned int n    = dealii::Utilities::MPI::n_mpi_processes(communicator),
                         rank = dealii::Utilities::MPI::this_mpi_process(communicator);
      const std::string unfinished = name + ".new";
      for (unsigned int r = 0; r < n; ++r)
        throw_on_all_ranks(communicator, [&]() {
          if (rank != r)
            return;
          std::ofstream out(unfinished, r == 0 ? std::ios::trunc : std::ios::app);
          out.precision(17);
          if (r == 0)
            out << header << '\n';
          write(out);
          out.close();
          if (r + 1 == n || !out)
            finish_file(unfinished, name, out.good());
        });
    }

    template<typename Vector> void write_three(std::ostream &out, const Vector &v)
    {
      out << v[0] << ',' << v[1] << ',' << v[2] << ',';
    }
  } // namespace

  void write_nodal_displacement(const std::string &directory, const Body &body,
                                const LA::Vector &u, const LA::Vector &reaction,
                                const std::string &tag)
  {
    write_rows(directory + "/displacement" + tag + ".csv",
               "x,y,z,u_x,u_y,u_z,reaction_x,reaction_y,reaction_z", body.communicator(),
               [&](std::ostream &out) {
                 for (const Body::Node &node : body.locally_owned_nodes())
                   {
                     write_three(out, node.position);
                     for (const auto dof : node.dofs)
                       out << u(dof) << ',';
                     out << reaction(node.dofs[0]) << ',' << reaction(node.dofs[1]) << ','
                         << reaction(node.dofs[2]) << '\n';
                   }
               });
  }

  void write_contact_nodes(const std::string &directory, const ContactSurface &surface,
                           const Certificate &certificate,
                           const std::vector<NodeStatus> &statuses, MPI_Comm communicator,
                           const std::string &tag)
  {
    // every rank knows all nodes
    const bool is_first = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    write_rows(
      directory + "/contact" + tag + ".csv",
      "x,y,z,normal_x,normal_y,normal_z,area,boundary,force_x,force_y,force_z,normal_"
      "force,slip_bound,gap,slip_x,slip_y,slip_z,normal_status,tangential_status",
      communicator, [&](std::ostream &out) {
        const Eigen::Index m     = surface.n_nodes();
        const Eigen::VectorXd &r = certificate.gradient();
        for (Eigen::Index i = 0; i < m && is_first; ++i)
          {
            const ContactNode &node = surface.nodes()[i];
            write_three(out, node.position);
            write_three(out, node.normal);
            out << node.area << ',' << surface.boundaries()[node.boundary].id() << ',';
            write_three(out, (Eigen::Vector3d::Zero() -
                              node.force_to_cartesian(at_node(certificate.lambda(), i)))
                               .eval());
            const double bound = certificate.slip_bound()(i);
            out << certificate.lambda()(i) << ',' << (qp::is_tied(bound) ? 0. : bound)
                << ',' << r(i) << ',';
            write_three(out, node.displacement_to_cartesian(
                               {0., 0. - r(i + m), 0. - r(i + 2 * m)}));
            out << static_cast<int>(statuses[i].normal) << ','
                << static_cast<int>(statuses[i].tangential) << '\n';
          }
      });
  }

  Eigen::VectorXd pressure_around(const Body &body, const ContactSurface &surface,
                                  const Eigen::VectorXd &normal_force)
  {
    using dealii::types::global_dof_index;
    Eigen::MatrixX2d sums = Eigen::MatrixX2d::Zero(surface.n_nodes(), 2);
    std::vector<global_dof_index> dofs(body.dof_handler().get_fe().n_dofs_per_face());
    for (const auto &cell : body.locally_owned_cells())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && surface.is_contact_boundary(face->boundary_id()))
          {
            face->get_dof_indices(dofs);
            const unsigned int part = surface.parts().of(face);
            std::vector<Eigen::Index> nodes;
            for (std::size_t k = 0; k < dofs.size(); k += 3)
              for (const auto &[dof, weight] : body.followed_by(dofs[k]))
                for (const auto &[i, share] :
                     surface.bearers_at(dof, face->boundary_id(), part))
                  nodes.push_back(i);
            sort_once(nodes);
            Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
            for (const Eigen::Index i : nodes)
              sum += Eigen::RowVector2d(normal_force(i), surface.areas()(i));
            for (const Eigen::Index i : nodes)
              sums.row(i) += sum;
          }
    sum_over_ranks(sums, body.communicator());
    return (sums.col(1).array() > 0.)
      .select(sums.col(0).cwiseQuotient(sums.col(1)),
              normal_force.cwiseQuotient(surface.areas()));
  }
} // namespace stiction
