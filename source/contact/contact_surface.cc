#include <stiction/contact/contact_surface.h>
#include <stiction/contact/friction_data.h>
#include <stiction/contact/nodal_blocks.h>
#include <stiction/elasticity/body.h>
#include <stiction/elasticity/boundary_functions.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stiction
{
  using namespace dealii;

  ContactSurface::ContactSurface(const LinearElasticity &elasticity,
                                 const Parameters &parameters)
    : law_(parameters.friction.law())
  {
    const std::string entry = "Boundary conditions/Contact boundary";
    boundary_id_            = elasticity.body().boundary_names().id(
      dealii::Utilities::trim(parameters.boundary.contact_boundary),
      parameters.source.locate(entry));
    collect_nodes(elasticity);
    if (nodes_.empty())
      throw InputError(parameters.source.describe(entry) +
                       ", the displacement is prescribed at every node of "
                       "this boundary, must be a boundary with free nodes.");
    evaluate_data(parameters);
  }



  void
  ContactSurface::collect_nodes(const LinearElasticity &elasticity)
  {
    const Body &body = elasticity.body();

    // What the owners of the faces around a node each know of it.
    // dofs, position, area × n, area, prescribed components as bits
    using Share = std::array<double, 11>;
    std::map<types::global_dof_index, Share> shares;

    const QGauss<2> quadrature(2);
    const FiniteElement<3> &fe = body.dof_handler().get_fe();
    FEFaceValues<3> values(body.mapping(),
                           fe,
                           quadrature,
                           update_values | update_normal_vectors |
                             update_JxW_values);

    for (const auto &cell : body.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == boundary_id_)
            {
              const auto face = cell->face(f);
              values.reinit(cell, f);
              for (const unsigned int v : face->vertex_indices())
                {
                  const auto first = face->vertex_dof_index(v, 0);
                  Tensor<1, 3> normal;
                  double area = 0.;
                  // vertices come first among the unknowns of a face
                  const unsigned int i = fe.face_to_cell_index(3 * v, f);
                  for (const unsigned int q : values.quadrature_point_indices())
                    {
                      const double w = values.shape_value(i, q) * values.JxW(q);
                      area += w;
                      normal += w * values.normal_vector(q);
                    }
                  boundary_area_ += area;
                  unsigned int prescribed = 0;
                  for (unsigned int c = 0; c < 3; ++c)
                    if (elasticity.constraints().is_constrained(
                          face->vertex_dof_index(v, c)))
                      prescribed |= 1u << c;
                  if (prescribed == 7)
                    continue;

                  Share &share = shares.emplace(first, Share{}).first->second;
                  for (unsigned int c = 0; c < 3; ++c)
                    {
                      share[c] =
                        static_cast<double>(face->vertex_dof_index(v, c));
                      share[3 + c] = face->vertex(v)[c];
                      share[6 + c] += normal[c];
                    }
                  share[9] += area;
                  share[10] = prescribed;
                }
            }
    boundary_area_ = Utilities::MPI::sum(boundary_area_, body.communicator());

    std::vector<Share> mine;
    for (const auto &share : shares)
      mine.push_back(share.second);
    shares.clear();
    for (const auto &theirs :
         Utilities::MPI::all_gather(body.communicator(), mine))
      for (const Share &share : theirs)
        {
          Share &sum =
            shares
              .emplace(static_cast<types::global_dof_index>(share[0]), Share{})
              .first->second;
          std::copy(share.begin(), share.begin() + 6, sum.begin());
          for (unsigned int k = 6; k < 10; ++k)
            sum[k] += share[k];
          sum[10] = share[10];
        }

    // The unknowns' numbers depend on the partition, places do not. Rounded,
    // because a vertex may have been computed along different edges.
    std::vector<Share> sorted;
    for (const auto &share : shares)
      sorted.push_back(share.second);
    const auto corners = body.bounding_box().get_boundary_points();
    const double unit  = 1e-9 * corners.first.distance(corners.second);
    const auto key     = [&](const Share &share) {
      std::array<long long, 3> k;
      for (unsigned int c = 0; c < 3; ++c)
        k[c] = std::llround((share[3 + c] - corners.first[c]) / unit);
      return k;
    };
    std::sort(sorted.begin(),
              sorted.end(),
              [&](const Share &a, const Share &b) { return key(a) < key(b); });

    std::array<std::vector<types::global_dof_index>, 3> dofs;
    for (const Share &share : sorted)
      {
        ContactNode node;
        for (unsigned int c = 0; c < 3; ++c)
          {
            node.position[c] = share[3 + c];
            node.normal[c]   = share[6 + c];
            node.prescribed[c] =
              (static_cast<unsigned int>(share[10]) >> c & 1u) != 0;
          }
        node.normal /= node.normal.norm();
        node.area = share[9];
        if (!set_tangents(node))
          continue;
        for (unsigned int c = 0; c < 3; ++c)
          dofs[c].push_back(static_cast<types::global_dof_index>(share[c]));
        node_of_dof_[dofs[0].back()] = n_nodes();
        nodes_.push_back(node);
      }
    for (unsigned int c = 1; c < 3; ++c)
      dofs[0].insert(dofs[0].end(), dofs[c].begin(), dofs[c].end());
    trace_ = Trace(std::move(dofs[0]));
  }



  void
  ContactSurface::evaluate_data(const Parameters &parameters)
  {
    const ParsedFunction gap(
      parameters.boundary.initial_gap,
      1,
      parameters.source.locate("Boundary conditions/Initial gap"));
    const FrictionData friction(parameters);

    gaps_.resize(n_nodes());
    areas_.resize(n_nodes());
    Eigen::VectorXd bound = Eigen::VectorXd::Zero(n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        ContactNode &node = nodes_[i];
        node.gap          = gap.value(node.position);
        friction.set(node);
        gaps_(i)  = node.gap;
        areas_(i) = node.area;
        bound(i)  = law_ == FrictionLaw::coulomb ? node.coefficient
                                                 : node.area * node.slip_stress;
      }
    slip_bound_ = law_ == FrictionLaw::coulomb
                    ? qp::SlipBound::coulomb(std::move(bound))
                    : qp::SlipBound::given(std::move(bound));
  }



  Eigen::Index
  ContactSurface::node_of(const types::global_dof_index first_dof) const
  {
    const auto node = node_of_dof_.find(first_dof);
    return node == node_of_dof_.end() ? -1 : node->second;
  }



  Eigen::VectorXd
  ContactSurface::apply_B(const LA::Vector &u) const
  {
    Eigen::VectorXd w = trace_.restriction(u);
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      set_at_node(w, i, nodes_[i].displacement_to_local(at_node(w, i)));
    return w;
  }



  void
  ContactSurface::add_transpose_B(const double factor,
                                  const Eigen::VectorXd &lambda,
                                  LA::Vector &dst) const
  {
    trace_.add_extension(factor * force_to_cartesian(lambda), dst);
  }



  void
  ContactSurface::add_displacement(const double factor,
                                   const Eigen::VectorXd &w,
                                   LA::Vector &u) const
  {
    Eigen::VectorXd cartesian(w.size());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      set_at_node(cartesian,
                  i,
                  factor * nodes_[i].displacement_to_cartesian(at_node(w, i)));
    trace_.add_extension(cartesian, u);
  }



  void
  ContactSurface::rotate_to_local(Eigen::MatrixXd &C) const
  {
    const Eigen::Index m = n_nodes();
    std::vector<Eigen::Matrix3d> M;
    for (const ContactNode &node : nodes_)
      M.push_back(node.scales().asDiagonal() * node.axes());
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index i = 0; i < m; ++i)
        {
          Eigen::Matrix3d block;
          for (Eigen::Index b = 0; b < 3; ++b)
            for (Eigen::Index a = 0; a < 3; ++a)
              block(a, b) = C(i + a * m, j + b * m);
          block = (M[i] * block * M[j].transpose()).eval();
          for (Eigen::Index b = 0; b < 3; ++b)
            for (Eigen::Index a = 0; a < 3; ++a)
              C(i + a * m, j + b * m) = block(a, b);
        }
  }



  Eigen::VectorXd
  ContactSurface::force_to_cartesian(const Eigen::VectorXd &lambda) const
  {
    Eigen::VectorXd force(lambda.size());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      set_at_node(force, i, nodes_[i].force_to_cartesian(at_node(lambda, i)));
    return force;
  }



  Eigen::VectorXd
  ContactSurface::held() const
  {
    Eigen::VectorXd held(3 * n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      set_at_node(
        held, i, (nodes_[i].scales().array() == 0.).matrix().cast<double>());
    return held;
  }



  bool
  ContactSurface::is_plane() const
  {
    return std::all_of(nodes_.begin(), nodes_.end(), [&](const auto &node) {
      return (node.normal - nodes_[0].normal).norm() < 1e-10;
    });
  }
} // namespace stiction
