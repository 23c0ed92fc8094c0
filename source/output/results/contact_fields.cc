// contact.pvtu: the contact boundaries.

#include "field_output.h"

#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/output_parameters.h>
#include <stiction/output/results/vtu.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/feasible_set.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>
#include <utility>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // One patch a face.
    class ContactOutput : public FieldOutput<2>
    {
    public:
      ContactOutput(const Body &body, const LA::Vector &u, const ContactSurface &surface,
                    const Certificate &certificate,
                    const std::vector<NodeStatus> &statuses,
                    const Eigen::VectorXd &slip_path, Units units)
        : FieldOutput<2>(body)
        , surface_(surface)
        , certificate_(certificate)
        , statuses_(statuses)
        , slip_path_(slip_path)
        , units_(std::move(units))
      {
        const FiniteElement<3> &fe = body_.dof_handler().get_fe();
        // points of a patch are in the order of a table, unknowns first those
        // of the vertices, then those of the edges
        const auto order = FETools::lexicographic_to_hierarchic_numbering<2>(fe.degree);
        std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());
        FEFaceValues<3> places(body_.mapping(), fe,
                               QIterated<2>(QTrapezoid<1>(), fe.degree),
                               update_quadrature_points);
        for (const auto &cell : body_.locally_owned_cells())
          for (const unsigned int f : cell->face_indices())
            if (const auto face = cell->face(f);
                face->at_boundary() &&
                (surface.is_contact_boundary(face->boundary_id()) ||
                 surface.is_other_side(face->boundary_id())))
              {
                face->get_dof_indices(dofs);
                places.reinit(cell, f);
                const unsigned int part = surface_.parts().of(face);
                Patch &patch            = add_patch(face, true); // it may be curved
                for (unsigned int p = 0; p < order.size(); ++p)
                  {
                    const auto dof      = dofs[3 * order[p]];
                    const Values values = values_at(dof, face->boundary_id(), part);
                    for (unsigned int k = 0; k < values.size(); ++k)
                      set(patch, k, p, values[k]);
                    set(patch, boundary_, p, face->boundary_id());
                    if (body_.pieces().size() > 1)
                      set(patch, piece_, p, body_.piece_of(cell));
                    for (unsigned int c = 0; c < 3; ++c)
                      set(patch, displacement_ + c, p, u(dof + c));
                    set(patch, values.size(), p, places.quadrature_point(p));
                  }
              }
      }

    private:
      using Values = std::vector<double>; // of all rows

      // At a node of the boundary, interpolated if it hangs; its status is
      // then that of the first node it follows. A boundary may bear the forces of one
      // contact and lie opposite in another; a node may bear those of an earlier one.
      Values values_at(const types::global_dof_index first_dof,
                       const types::boundary_id boundary, const unsigned int part) const
      {
        const bool is_contact  = surface_.is_contact_boundary(boundary),
                   is_opposite = surface_.is_other_side(boundary);
        const auto at          = [&](const types::global_dof_index dof) {
          const Eigen::Index node = surface_.node_of(dof);
          if (is_opposite && !(is_contact && node >= 0))
            return values_opposite(surface_.opposite_node_of(dof));
          const auto bearers = surface_.bearers_at(dof, boundary, part);
          return !bearers.empty() && bearers.front().first == node ? values_at_node(node)
                                                                            : mean_of(bearers);
        };
        const auto masters = body_.followed_by(first_dof);
        // itself, or the node of degree 2 of a larger cell that is where it hangs
        if (masters.size() == 1)
          return at(masters.front().first);
        Values sum(row_names_.size());
        for (auto master = masters.rbegin(); master != masters.rend(); ++master)
          {
            const Values values = at(master->first);
            for (unsigned int k = 0; k < sum.size(); ++k)
              sum[k] += master->second * values[k];
            for (const auto row : {normal_status_, tangential_status_})
              sum[row] = values[row];
          }
        sum[area_] = 0.; // it has none of its own
        const double length =
          std::hypot(sum[normal_], sum[normal_ + 1], sum[normal_ + 2]);
        for (unsigned int c = 0; c < 3 && length > 0.; ++c)
          sum[normal_ + c] /= length;
        return sum;
      }

      Values values_at_node(const Eigen::Index i) const
      {
        Values values(row_names_.size());
        if (i < 0) // clamped or facing away: not a contact node
          {
            values[normal_status_] = values[tangential_status_] = -1.;
            return values;
          }
        const Eigen::Index m    = surface_.n_nodes();
        const ContactNode &node = surface_.nodes()[i];
        const auto &lambda      = certificate_.lambda();
        const auto &r           = certificate_.gradient();

        const Eigen::Vector3d force    = node.force_to_cartesian(at_node(lambda, i)),
                              friction = node.force_to_cartesian(
                                {0., lambda(i + m), lambda(i + 2 * m)});
        const Eigen::Vector3d slip_vector =
          node.displacement_to_cartesian({0., -r(i + m), -r(i + 2 * m)});

        values[pressure_]          = lambda(i) / node.area;
        values[gap_]               = r(i);
        values[area_]              = node.area;
        const double bound         = certificate_.slip_bound()(i);
        values[slip_bound_]        = qp::is_tied(bound) ? 0. : bound / node.area;
        values[normal_status_]     = static_cast<double>(statuses_[i].normal);
        values[tangential_status_] = static_cast<double>(statuses_[i].tangential);
        if (slip_path_.size() > 0)
          values[path_] = slip_path_(i);
        for (unsigned int c = 0; c < 3; ++c)
          {
            values[traction_ + c]            = -force[c] / node.area;
            values[slip_ + c]                = slip_vector[c];
            values[normal_ + c]              = node.normal[c];
            values[tangential_traction_ + c] = -friction[c] / node.area;
          }
        return values;
      }

      // The mean of contact nodes, and the status of the one with most of it.
      Values mean_of(const std::vector<std::pair<Eigen::Index, double>> &nodes) const
      {
        Values values     = values_at_node(-1);
        double largest    = 0.;
        const auto status = {normal_status_, tangential_status_};
        for (const auto &[i, weight] : nodes)
          {
            const Values at = values_at_node(i);
            for (unsigned int k = 0; k < values.size(); ++k)
              if (std::count(status.begin(), status.end(), k) == 0)
                values[k] += weight * at[k];
              else if (weight > largest)
                values[k] = at[k];
            largest = std::max(largest, weight);
          }
        values[area_] = 0.; // forces are those of the contact nodes
        const double length =
          std::hypot(values[normal_], values[normal_ + 1], values[normal_ + 2]);
        for (unsigned int c = 0; c < 3 && length > 0.; ++c)
          values[normal_ + c] /= length;
        return values;
      }

      // At a node of the other side of a pair, from the contact nodes that it faces.
      Values values_opposite(const Eigen::Index j) const
      {
        std::vector<std::pair<Eigen::Index, double>> facing;
        if (j >= 0)
          for (std::decay_t<decltype(surface_.to_other_side())>::InnerIterator weight(
                 surface_.to_other_side(), j);
               weight; ++weight)
            facing.emplace_back(weight.col(), weight.value());
        Values values = mean_of(facing);
        for (unsigned int c = 0; c < 3; ++c)
          for (const auto row : {normal_, traction_, tangential_traction_, slip_})
            values[row + c] = -values[row + c];
        return values;
      }

      const ContactSurface &surface_;
      const Certificate &certificate_;
      const std::vector<NodeStatus> &statuses_;
      const Eigen::VectorXd &slip_path_; // of no nodes: not wanted
      const Units units_;

      const unsigned int pressure_          = add_field("pressure", 1, units_.stress),
                         traction_          = add_field("traction", 3, units_.stress),
                         slip_              = add_field("slip", 3, units_.length),
                         gap_               = add_field("gap", 1, units_.length),
                         normal_status_     = add_field("normal_status", 1),
                         tangential_status_ = add_field("tangential_status", 1),
                         area_              = add_field("area", 1, units_.area),
                         slip_bound_        = add_field("slip_bound", 1, units_.stress),
                         boundary_          = add_field("boundary", 1),
                         displacement_      = add_field("displacement", 3, units_.length),
                         normal_            = add_field("normal", 3),
                         tangential_traction_ = add_field("tangential_traction", 3,
                                                          units_.stress),
                         piece_ = body_.pieces().size() > 1 ? add_field("body", 1) : 0,
                         path_  = slip_path_.size() > 0
                                    ? add_field("slip_path", 1, units_.length)
                                    : 0;
    };
  } // namespace

  void write_contact(const LinearElasticity &elasticity, const LA::Vector &u,
                     const ContactSurface &surface, const Certificate &certificate,
                     const std::vector<NodeStatus> &statuses,
                     const OutputParameters &parameters, const std::string &tag,
                     const Eigen::VectorXd &slip_path)
  {
    const Body &body = elasticity.body();
    ContactOutput(body, body.with_ghosts(u), surface, certificate, statuses, slip_path,
                  Units::named(parameters.units))
      .write(parameters.directory, "contact", tag);
  }
} // namespace stiction
