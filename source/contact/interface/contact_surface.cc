#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The place of a boundary in the list, the list's size if it is not there.
    std::size_t
    index_of(const std::vector<ContactBoundary> &boundaries,
             const types::boundary_id id)
    {
      std::size_t b = 0;
      while (b < boundaries.size() && boundaries[b].id() != id)
        ++b;
      return b;
    }
  } // namespace



  ContactSurface::~ContactSurface() = default;



  const ContactBoundary &
  ContactSurface::boundary(const types::boundary_id id) const
  {
    return boundaries_.at(index_of(boundaries_, id));
  }



  bool
  ContactSurface::is_contact_boundary(const types::boundary_id id) const
  {
    return index_of(boundaries_, id) < boundaries_.size();
  }



  double
  ContactSurface::penetration_of_facing_away(const LA::Vector &u) const
  {
    const Eigen::VectorXd moved = facing_away_trace_.restriction(u);
    const std::size_t m         = facing_away_.size();
    double depth                = 0.;
    for (std::size_t i = 0; i < m; ++i)
      {
        Point<3> p = facing_away_[i].position;
        for (unsigned int c = 0; c < 3; ++c)
          p[c] += moved(static_cast<Eigen::Index>(i + c * m));
        p -= obstacle_displacement(boundaries_[facing_away_[i].boundary].id());
        depth =
          std::max(depth, boundaries_[facing_away_[i].boundary].penetration(p));
      }
    return depth;
  }



  Tensor<1, 3>
  ContactSurface::obstacle_displacement(const types::boundary_id id) const
  {
    Eigen::Index column = 0;
    for (const ContactBoundary &boundary : boundaries_)
      {
        const double force = boundary.force().norm();
        if (boundary.id() == id)
          return force > 0.
                   ? boundary.displacement() +
                       motion_.distances()(column) / force * boundary.force()
                   : boundary.displacement();
        column += force > 0. ? 1 : 0;
      }
    return Tensor<1, 3>();
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

} // namespace stiction
