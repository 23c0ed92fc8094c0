#include <stiction/contact/pairs/held_slaves.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // Of what is opposite to a slave node: with more of it free, no node of the other
    // side is held there. One of much finer cells at the edge counts for little.
    constexpr double no_hold = 0.99;

  } // namespace

  Eigen::VectorXd prescribed_of(const LinearElasticity &elasticity, const DofSubset &dofs)
  {
    LA::Vector held = elasticity.zero_vector();
    for (const auto dof : dofs.dofs())
      if (held.in_local_range(dof) && elasticity.is_prescribed(dof))
        held(dof) = 1.;
    return dofs.restriction(held);
  }

  bool is_held(const LinearElasticity &elasticity, const std::vector<SurfaceFace> &faces,
               const std::vector<SurfaceFace> &opposite)
  {
    std::vector<dealii::types::global_dof_index> nodes;
    for (const SurfaceFace &face : faces)
      nodes.insert(nodes.end(), face.dofs.begin(), face.dofs.begin() + face.n_nodes());
    sort_once(nodes);
    const Eigen::MatrixXd held = prescribed_of(elasticity, DofSubset::of_nodes(nodes))
                                   .reshaped(static_cast<Eigen::Index>(nodes.size()), 3);
    const auto is_held_node = [&](const dealii::types::global_dof_index dof) {
      const auto place = std::lower_bound(nodes.begin(), nodes.end(), dof);
      return held.row(place - nodes.begin()).maxCoeff() > 0.;
    };
    Eigen::AlignedBox3d other;
    for (const SurfaceFace &face : opposite)
      for (unsigned int i = 0; i < face.n_nodes(); ++i)
        other.extend(Eigen::Vector3d(face.nodes[i].data()));
    for (const SurfaceFace &face : faces)
      {
        Eigen::AlignedBox3d box; // of its held nodes
        for (unsigned int i = 0; i < face.n_nodes(); ++i)
          if (is_held_node(face.dofs[i]))
            box.extend(Eigen::Vector3d(face.nodes[i].data()));
        if (!box.isEmpty() && box.exteriorDistance(other) <= face.coarse_diameter)
          return true;
      }
    return false;
  }

  unsigned int n_held_alone(const LinearElasticity &elasticity, const Mortar &mortar)
  {
    const Eigen::VectorXd slaves =
      prescribed_of(elasticity, DofSubset::of_nodes(mortar.slaves));
    const Eigen::VectorXd masters =
      prescribed_of(elasticity, DofSubset::of_nodes(mortar.masters));
    const Eigen::Index m = mortar.weights.rows(), n = mortar.weights.cols();
    unsigned int n_nodes = 0;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        bool is_alone = false;
        for (Eigen::Index c = 0; c < 3; ++c)
          if (slaves(i + c * m) > 0.)
            {
              double all = 0., free = 0.;
              for (decltype(mortar.weights)::InnerIterator a(mortar.weights, i); a; ++a)
                {
                  all += std::abs(a.value());
                  free += std::abs(a.value()) * (1. - masters(a.col() + c * n));
                }
              is_alone = is_alone || free > no_hold * all;
            }
        n_nodes += is_alone ? 1 : 0;
      }
    return n_nodes;
  }
} // namespace stiction
