#pragma once

#include "aligned_array.h"
#include "cell_geometry.h"
#include "loops/cell_kernel.h"
#include "cell_patches.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

// What CellStiffness keeps its cells in, in the layout of the kernels.

namespace stiction::cell_kernel
{
  /// The parallelepipeds of a class: cells of one material that are
  /// translations of each other.
  template<typename Number> class CongruentCells
  {
  public:
    /// The class of this cell, still empty.
    CongruentCells(const CellMap &map, double lame_lambda, double shear_modulus);

    /// Whether a cell with an affine map belongs to it.
    bool contains(const CellMap &map, double lame_lambda, double shear_modulus) const;

    void add(const CellNodes &nodes);

    /// Arranges the cells in patches; after the last one.
    void finish(const Kernels<Number> &kernels);

    /// dst += K src.
    void add_product(const Kernels<Number> &kernels, Number *dst,
                     const Number *src) const;

    /// As CellStiffness::add_diagonal_blocks().
    void add_diagonal_blocks(const Kernels<Number> &kernels, Number *dst) const;

    std::size_t n_patches() const { return patches_.n_elements; }

  private:
    // Cells or patches.
    struct Elements
    {
      std::size_t n_elements = 0;
      std::vector<std::uint32_t> entries;
      AlignedArray<Number> coefficients;
    };

    template<std::size_t n_nodes>
    Elements make_elements(const std::vector<std::array<std::uint32_t, n_nodes>> &nodes,
                           const Kernels<Number> &kernels) const;

    CellMap map_;
    double lame_lambda_, shear_modulus_;
    bool is_box_;
    std::deque<CellNodes> unfinished_;
    Elements cells_, patches_;
  };

  /// Some of the cells that are neither parallelepipeds nor of few shapes. In
  /// blocks, since a single array would have to be copied to grow.
  template<typename Number> class GeneralCellBlock
  {
  public:
    explicit GeneralCellBlock(unsigned int lanes);

    bool is_full() const;

    void add(const CellNodes &nodes, const CellMap &map, double lame_lambda,
             double shear_modulus);

    /// Makes the last batch complete and gives back memory.
    void finish();

    /// dst += K src.
    void add_product(const Kernels<Number> &kernels, Number *dst,
                     const Number *src) const;

    /// As CellStiffness::add_diagonal_blocks().
    void add_diagonal_blocks(Number *dst) const;

    std::size_t n_cells() const { return n_cells_; }

  private:
    void resize(std::size_t n_cells);

    std::uint32_t &entry(std::size_t cell, unsigned int node);

    Number &number(std::size_t cell, unsigned int i);

    unsigned int lanes_;
    std::size_t n_cells_ = 0;
    std::vector<std::uint32_t> entries_;
    AlignedArray<Number> numbers_;
  };
} // namespace stiction::cell_kernel
