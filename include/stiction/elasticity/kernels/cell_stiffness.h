#pragma once

#include <stiction/elasticity/kernels/instruction_set.h>

#include <array>
#include <cstddef>
#include <vector>

namespace stiction
{
  namespace cell_kernel
  {
    struct CellMap;
    template<typename Number> struct Kernels;
    template<typename Number> class CongruentCells;
    template<typename Number> class GeneralCellBlock;
  } // namespace cell_kernel

  struct Material;

  /// A hexahedron with trilinear map (Q1) and linear elasticity.
  struct HexahedralCell
  {
    /// Local numbers of its nodes: node k is at (k & 1, k >> 1 & 1, k >> 2 & 1)
    /// of the unit cell, which is deal.II's order of vertices.
    std::array<unsigned int, 8> nodes;

    /// Where they are. Unit: m.
    std::array<std::array<double, 3>, 8> vertices;

    /// Lamé's λ and G = μ if it is isotropic. Unit: unit × Pa.
    double lame_lambda, shear_modulus;

    /// What it is made of: the number, and what is behind it.
    unsigned int material_id;
    const Material *material;
    double unit;
  };

  /// The stiffness matrix K of linear elasticity as a sum over its cells, which
  /// is never formed: one is for products with vectors, and fast.
  ///
  /// Vectors are arrays of three numbers a node, entry 3·node + component.
  ///
  /// Cells are integrated with 2×2×2 Gauss points. For parallelepipeds, for
  /// which this is exact, that is done once for all that are translations of
  /// each other and of the same material: they form a class. Where eight cells
  /// of a class make up a 2×2×2 patch, as after a refinement, the product is
  /// that of the patch, for about half of the work and of the memory: 14 bytes
  /// a cell; other parallelepipeds take 32, other hexahedra 32 and 23 numbers.
  /// More than max_classes shapes are treated as general.
  ///
  /// @tparam Number float or double
  template<typename Number> class CellStiffness
  {
  public:
    static constexpr unsigned int max_classes = 64;

    /// No cells yet: add_cell() them and finish(), which takes less memory
    /// than a vector of cells. Throws std::invalid_argument if the instruction
    /// set is not supported.
    explicit CellStiffness(InstructionSet instruction_set = best_instruction_set());

    /// All of these cells. Throws std::invalid_argument as above, and for a
    /// cell like add_cell().
    explicit CellStiffness(const std::vector<HexahedralCell> &cells,
                           InstructionSet instruction_set = best_instruction_set());

    CellStiffness(CellStiffness &&) noexcept;
    CellStiffness &operator=(CellStiffness &&) noexcept;
    ~CellStiffness();

    /// Best in an order in which the eight children of a cell follow each
    /// other, as in deal.II's loops. Throws std::invalid_argument for a cell
    /// whose map has a determinant that is not positive at a Gauss point, and
    /// for a node above 1.4·10⁹.
    void add_cell(const HexahedralCell &cell);

    /// To be called once, after the last cell and before any product.
    void finish();

    /// dst += K src. The arrays must not overlap.
    void add_product(Number *dst, const Number *src) const;

    /// Adds the 3×3 block of each node on the diagonal of K:
    /// dst[9·node + 3·row + column] += K(3·node + row, 3·node + column).
    void add_diagonal_blocks(Number *dst) const;

    std::size_t n_cells() const { return n_cells_; }

    /// Cells in patches of eight.
    std::size_t n_patched_cells() const;

    /// Cells that are integrated in every product.
    std::size_t n_general_cells() const;

  private:
    // The class of a parallelepiped, nullptr if there are too many.
    cell_kernel::CongruentCells<Number> *find_class(const HexahedralCell &cell,
                                                    const cell_kernel::CellMap &map);

    InstructionSet instruction_set_;
    const cell_kernel::Kernels<Number> *kernels_;
    std::size_t n_cells_    = 0;
    std::size_t last_class_ = 0;
    std::vector<cell_kernel::CongruentCells<Number>> classes_;
    std::vector<cell_kernel::GeneralCellBlock<Number>> general_;
  };
} // namespace stiction
