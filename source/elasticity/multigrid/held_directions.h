#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace stiction
{
  /// What holds the nodes of a level, in double precision: prescribed unknowns, and the
  /// supports of the nodes of a list, of which this rank owns some.
  struct HeldDirections
  {
    /// @param is_fixed one at prescribed unknowns. Without supports to begin with.
    HeldDirections(const MeshLevel &mesh, LA::Vector is_fixed,
                   const std::vector<dealii::types::global_dof_index> &first_dofs)
      : fixed(std::move(is_fixed))
      , supports(first_dofs.size())
    {
      for (std::size_t i = 0; i < first_dofs.size(); ++i)
        if (mesh.partitioner()->in_local_range(first_dofs[i]))
          nodes.emplace_back(3 * mesh.local_node(first_dofs[i]), i);
    }

    /// Sets to zero what v has in held directions.
    void project(LA::Vector &v) const
    {
      for (unsigned int k = 0; k < v.locally_owned_size(); ++k)
        if (fixed.local_element(k) != 0.)
          v.local_element(k) = 0.;
      for (const auto &[k, i] : nodes)
        {
          Eigen::Map<Eigen::Vector3d> at_node(v.begin() + k);
          at_node = (supports[i].projection * at_node).eval();
        }
    }

    /// dst += S u with the springs S of the supports.
    void add_springs(LA::Vector &dst, const LA::Vector &u) const
    {
      for (const auto &[k, i] : nodes)
        Eigen::Map<Eigen::Vector3d>(dst.begin() + k) +=
          supports[i].spring * Eigen::Map<const Eigen::Vector3d>(u.begin() + k);
    }

    LA::Vector fixed;
    std::vector<std::pair<unsigned int, std::size_t>> nodes; ///< unknown, place
    NodalSupports supports;
  };
} // namespace stiction
