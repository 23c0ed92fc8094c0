#pragma once

#include <cstddef>
#include <cstdint>

// What CellStiffness and the kernels agree on. The kernels are compiled once
// for each instruction set. Nothing here or in the other cell_kernel_*.h may
// be an inline function with external linkage, nor may they include a header
// that has some: the linker would keep one copy of it, perhaps the one with
// instructions that the CPU does not have.

namespace stiction::cell_kernel
{
  /// Cells, or patches of 2×2×2 cells, that all have the same coefficients.
  ///
  /// They are in batches of as many as a kernel has lanes. With N nodes of an
  /// element, N = 8 or 27, lexicographic, node n of element b·lanes + l has
  /// its first vector entry at entries[(b·N + n)·lanes + l]. The last batch is
  /// filled up with any valid entries.
  template<typename Number> struct AffineElements
  {
    std::size_t n_elements;
    const std::uint32_t *entries;

    /// affine_coefficients(), each one repeated n_copies times.
    const Number *coefficients;
  };

  /// Numbers that describe a general cell: its map's modes, 7·c + S − 1 with
  /// S = 1, ..., 7 the set of reference coordinates in it as bits, each scaled
  /// by √(1/3) to the power of |S| − 1 and 1/8; then Lamé's λ and μ, over 64.
  constexpr unsigned int n_general_numbers = 23;

  /// General cells, in batches as above; number i of cell b·lanes + l is
  /// geometry[(b·n_general_numbers + i)·lanes + l].
  template<typename Number> struct GeneralCells
  {
    std::size_t n_elements;
    const std::uint32_t *entries;
    const Number *geometry;
  };

  /// The kernels for one instruction set: all add K src to dst.
  template<typename Number> struct Kernels
  {
    using Affine  = void (*)(const AffineElements<Number> &, Number *, const Number *);
    using General = void (*)(const GeneralCells<Number> &, Number *, const Number *);

    unsigned int lanes;
    unsigned int n_copies;
    Affine affine_cells, affine_patches, box_cells, box_patches;
    General general_cells;
  };

  /// Those of float and double.
  struct KernelPair
  {
    Kernels<float> of_float;
    Kernels<double> of_double;
  };

  extern const KernelPair baseline, avx2, avx512;
} // namespace stiction::cell_kernel
