#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <type_traits>

namespace stiction
{
  /// The entries (ν; t1; t2) of a node in a vector over the contact nodes,
  /// which is stored by blocks.
  inline Eigen::Vector3d at_node(const Eigen::VectorXd &v, const Eigen::Index node)
  {
    const Eigen::Index m = v.size() / 3;
    return {v(node), v(node + m), v(node + 2 * m)};
  }

  /// Sets them.
  inline void set_at_node(Eigen::VectorXd &v, const Eigen::Index node,
                          const Eigen::Vector3d &entries)
  {
    const Eigen::Index m = v.size() / 3;
    v(node)              = entries(0);
    v(node + m)          = entries(1);
    v(node + 2 * m)      = entries(2);
  }

  /// The vector that has these entries at each of m nodes.
  template<typename Entries>
  Eigen::VectorXd by_nodes(const Eigen::Index m, const Entries &entries)
  {
    static_assert(std::is_same_v<decltype(entries(m)), Eigen::Vector3d>,
                  "the parts of an expression would be gone");
    Eigen::VectorXd v(3 * m);
    for (Eigen::Index i = 0; i < m; ++i)
      set_at_node(v, i, entries(i));
    return v;
  }

  /// max_i ‖v_i‖/scale_i over the nodes.
  inline double largest_at_nodes(const Eigen::VectorXd &v, const Eigen::VectorXd &scale)
  {
    double largest = 0.;
    for (Eigen::Index i = 0; i < scale.size(); ++i)
      largest = std::max(largest, at_node(v, i).norm() / scale(i));
    return largest;
  }
} // namespace stiction
