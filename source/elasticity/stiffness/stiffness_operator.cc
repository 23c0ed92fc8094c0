#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <unordered_map>

namespace stiction
{
  template<typename Number>
  StiffnessOperator<Number>::StiffnessOperator(const MeshLevel &level,
                                               const Materials &materials,
                                               const double unit)
    : level_(level)
    , hanging_(level)
  {
    if (level.is_trilinear() && materials.are_simple())
      level.for_each_cell([&](HexahedralCell cell) {
        materials.assign(cell, unit);
        cells_.add_cell(cell);
      });
    else
      for_each_element(level, materials, unit, [&](const auto &nodes, const auto &K) {
        elements_.add(nodes, K);
      });
    cells_.finish();
    if (!hanging_.empty())
      find_hanging_blocks(materials, unit);
  }

  template<typename Number>
  void StiffnessOperator<Number>::add_product(Number *dst, const Number *src) const
  {
    cells_.add_product(dst, src);
    elements_.add_product(dst, src);
  }

  template<typename Number>
  void StiffnessOperator<Number>::vmult(Vector &dst, const Vector &src) const
  {
    src.update_ghost_values();
    dst = Number(0.);
    if (hanging_.empty())
      add_product(dst.begin(), src.begin());
    else
      {
        interpolated_.assign(src.begin(),
                             src.begin() + 3 * std::size_t(level_.n_local_nodes()));
        hanging_.interpolate(interpolated_.data());
        add_product(dst.begin(), interpolated_.data());
        hanging_.distribute(dst.begin());
      }
    src.zero_out_ghost_values();
    dst.compress(dealii::VectorOperation::add);
  }

  template<typename Number>
  void StiffnessOperator<Number>::find_hanging_blocks(const Materials &materials,
                                                      const double unit)
  {
    std::unordered_map<unsigned int, const MeshLevel::HangingNode *> is_hanging;
    for (const MeshLevel::HangingNode &hanging : hanging_)
      is_hanging[hanging.node] = &hanging;
    std::unordered_map<unsigned int, Eigen::Matrix3d> blocks;
    for_each_element(level_, materials, unit, [&](const auto &of_cell, const auto &K) {
      std::vector<std::vector<std::pair<unsigned int, double>>> nodes(of_cell.size());
      unsigned int n_hanging = 0;
      for (std::size_t v = 0; v < nodes.size(); ++v)
        {
          const auto hanging = is_hanging.find(of_cell[v]);
          n_hanging += hanging != is_hanging.end() ? 1 : 0;
          nodes[v] = hanging != is_hanging.end()
                       ? hanging->second->others
                       : decltype(hanging->second->others){{of_cell[v], 1.}};
        }
      if (n_hanging == 0)
        return;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j)
          for (const auto &[a, weight_a] : nodes[i])
            for (const auto &[b, weight_b] : nodes[j])
              if (a == b && !(i == j && a == of_cell[i])) // which the cells add
                {
                  auto &block =
                    blocks.try_emplace(a, Eigen::Matrix3d::Zero()).first->second;
                  for (unsigned int r = 0; r < 3; ++r)
                    for (unsigned int c = 0; c < 3; ++c)
                      block(r, c) += weight_a * weight_b * K(3 * i + r, 3 * j + c);
                }
    });
    hanging_blocks_.assign(blocks.begin(), blocks.end());
    std::sort(hanging_blocks_.begin(), hanging_blocks_.end(),
              [](const auto &a, const auto &b) { return a.first < b.first; });
  }

  template<typename Number>
  std::vector<Number> StiffnessOperator<Number>::diagonal_blocks() const
  {
    std::vector<Number> local(9 * static_cast<std::size_t>(level_.n_local_nodes()));
    cells_.add_diagonal_blocks(local.data());
    elements_.add_diagonal_blocks(local.data());
    for (const MeshLevel::HangingNode &hanging : hanging_)
      std::fill_n(&local[9 * std::size_t(hanging.node)], 9, Number(0.));
    for (const auto &[node, block] : hanging_blocks_)
      for (unsigned int k = 0; k < 9; ++k)
        local[9 * std::size_t(node) + k] += static_cast<Number>(block(k / 3, k % 3));

    // row by row through vectors, which know how to add up shares
    const std::size_t n_owned = level_.n_owned_nodes();
    Vector row                = level_.zero_vector<Number>();
    for (unsigned int a = 0; a < 3; ++a)
      {
        row = Number(0.);
        for (std::size_t i = 0; i < level_.n_local_nodes(); ++i)
          for (unsigned int b = 0; b < 3; ++b)
            row.begin()[3 * i + b] = local[9 * i + 3 * a + b];
        row.compress(dealii::VectorOperation::add);
        for (std::size_t i = 0; i < n_owned; ++i)
          for (unsigned int b = 0; b < 3; ++b)
            local[9 * i + 3 * a + b] = row.begin()[3 * i + b];
      }
    local.resize(9 * n_owned);
    return local;
  }

  template class StiffnessOperator<float>;
  template class StiffnessOperator<double>;
} // namespace stiction
