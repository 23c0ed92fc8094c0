#include <stiction/elasticity/kernels/cell_stiffness.h>

#include "cell_containers.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace stiction
{
  using namespace cell_kernel;

  namespace
  {
    const Kernels<float> &choose(const KernelPair &pair, float) { return pair.of_float; }

    const Kernels<double> &choose(const KernelPair &pair, double)
    {
      return pair.of_double;
    }

    const KernelPair &kernels_for(const InstructionSet instruction_set)
    {
      if (!is_supported(instruction_set))
        throw std::invalid_argument(
          std::string("this CPU, or this build, has no kernels for ") +
          name(instruction_set));
      switch (instruction_set)
        {
#ifdef STICTION_WITH_AVX2_KERNELS
          case InstructionSet::avx2:
            return avx2;
#endif
#ifdef STICTION_WITH_AVX512_KERNELS
          case InstructionSet::avx512:
            return avx512;
#endif
          default:
            return baseline;
        }
    }
  } // namespace

  template<typename Number>
  CellStiffness<Number>::CellStiffness(const InstructionSet instruction_set)
    : instruction_set_(instruction_set)
    , kernels_(&choose(kernels_for(instruction_set), Number()))
  {
  }

  template<typename Number>
  CellStiffness<Number>::CellStiffness(const std::vector<HexahedralCell> &cells,
                                       const InstructionSet instruction_set)
    : CellStiffness(instruction_set)
  {
    for (const HexahedralCell &cell : cells)
      add_cell(cell);
    finish();
  }

  template<typename Number>
  CellStiffness<Number>::CellStiffness(CellStiffness &&) noexcept = default;

  template<typename Number>
  CellStiffness<Number> &CellStiffness<Number>::operator=(CellStiffness &&) noexcept =
    default;

  template<typename Number> CellStiffness<Number>::~CellStiffness() = default;

  template<typename Number>
  void CellStiffness<Number>::add_cell(const HexahedralCell &cell)
  {
    CellNodes nodes;
    for (unsigned int v = 0; v < 8; ++v)
      {
        nodes[v] = cell.nodes[v];
        if (nodes[v] > std::numeric_limits<std::uint32_t>::max() / 3 - 1)
          throw std::invalid_argument("too many nodes for one process");
      }
    const CellMap map(cell.vertices);
    if (!map.is_valid())
      throw std::invalid_argument(
        "the map of a cell has a determinant that is not positive");

    CongruentCells<Number> *const of_class =
      map.is_affine() ? find_class(cell, map) : nullptr;
    if (of_class)
      of_class->add(nodes);
    else
      {
        if (general_.empty() || general_.back().is_full())
          general_.emplace_back(kernels_->lanes);
        general_.back().add(nodes, map, cell.lame_lambda, cell.shear_modulus);
      }
    ++n_cells_;
  }

  template<typename Number>
  CongruentCells<Number> *CellStiffness<Number>::find_class(const HexahedralCell &cell,
                                                            const CellMap &map)
  {
    // most often it is that of the cell before
    for (std::size_t i = 0; i < classes_.size(); ++i)
      {
        const std::size_t candidate = (last_class_ + i) % classes_.size();
        if (classes_[candidate].contains(map, cell.lame_lambda, cell.shear_modulus))
          {
            last_class_ = candidate;
            return &classes_[candidate];
          }
      }
    if (classes_.size() == max_classes)
      return nullptr;
    last_class_ = classes_.size();
    classes_.emplace_back(map, cell.lame_lambda, cell.shear_modulus);
    return &classes_.back();
  }

  template<typename Number> void CellStiffness<Number>::finish()
  {
    for (CongruentCells<Number> &of_class : classes_)
      of_class.finish(*kernels_);
    if (!general_.empty())
      general_.back().finish();
  }

  template<typename Number>
  void CellStiffness<Number>::add_product(Number *const dst,
                                          const Number *const src) const
  {
    for (const CongruentCells<Number> &of_class : classes_)
      of_class.add_product(*kernels_, dst, src);
    for (const GeneralCellBlock<Number> &block : general_)
      block.add_product(*kernels_, dst, src);
  }

  template<typename Number>
  void CellStiffness<Number>::add_diagonal_blocks(Number *const dst) const
  {
    for (const CongruentCells<Number> &of_class : classes_)
      of_class.add_diagonal_blocks(*kernels_, dst);
    for (const GeneralCellBlock<Number> &block : general_)
      block.add_diagonal_blocks(dst);
  }

  template<typename Number> std::size_t CellStiffness<Number>::n_patched_cells() const
  {
    std::size_t n = 0;
    for (const CongruentCells<Number> &of_class : classes_)
      n += 8 * of_class.n_patches();
    return n;
  }

  template<typename Number> std::size_t CellStiffness<Number>::n_general_cells() const
  {
    std::size_t n = 0;
    for (const GeneralCellBlock<Number> &block : general_)
      n += block.n_cells();
    return n;
  }

  template class CellStiffness<float>;
  template class CellStiffness<double>;
} // namespace stiction
