#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <type_traits>
#include <utility>

namespace stiction
{
  namespace
  {
    template<typename Number>
    CellStiffness<Number> make_cells(const MeshLevel &level, const Materials &materials,
                                     const double unit)
    {
      CellStiffness<Number> cells;
      level.for_each_cell([&](HexahedralCell cell) {
        materials.assign(cell, unit);
        cells.add_cell(cell);
      });
      cells.finish();
      return cells;
    }

    template<typename Number>
    std::vector<Number> blocks_of_matrix(const LA::SparseMatrix &matrix)
    {
      const auto owned = matrix.local_range();
      std::vector<Number> blocks;
      for (auto i = owned.first; i < owned.second; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          blocks.push_back(static_cast<Number>(matrix.el(i, i / 3 * 3 + c)));
      return blocks;
    }
  } // namespace

  template<typename Number>
  StiffnessOperator<Number>::StiffnessOperator(const MeshLevel &level,
                                               const Materials &materials,
                                               const double unit)
    : level_(level)
    , cells_(make_cells<Number>(level, materials, unit))
  {
  }

  template<typename Number>
  StiffnessOperator<Number>::StiffnessOperator(
    const MeshLevel &level, std::unique_ptr<const LA::SparseMatrix> matrix)
    : level_(level)
    , matrix_(std::move(matrix))
  {
  }

  template<typename Number>
  StiffnessOperator<Number>::~StiffnessOperator() = default;

  template<typename Number>
  void StiffnessOperator<Number>::vmult(Vector &dst, const Vector &src) const
  {
    if constexpr (std::is_same_v<Number, double>)
      if (matrix_)
        {
          matrix_->vmult(dst, src);
          return;
        }
    src.update_ghost_values();
    dst = Number(0.);
    cells_.add_product(dst.begin(), src.begin());
    src.zero_out_ghost_values();
    dst.compress(dealii::VectorOperation::add);
  }

  template<typename Number>
  std::vector<Number> StiffnessOperator<Number>::diagonal_blocks() const
  {
    if (matrix_)
      return blocks_of_matrix<Number>(*matrix_);
    std::vector<Number> local(9 * static_cast<std::size_t>(level_.n_local_nodes()));
    cells_.add_diagonal_blocks(local.data());

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
