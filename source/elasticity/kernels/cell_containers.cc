#include "cell_containers.h"

#include <algorithm>

namespace stiction::cell_kernel
{
  namespace
  {
    // Where number i of the n numbers of an element is.
    std::size_t index(const std::size_t element, const std::size_t i, const std::size_t n,
                      const unsigned int lanes)
    {
      return (element / lanes * n + i) * lanes + element % lanes;
    }

    std::size_t round_up(const std::size_t n, const unsigned int lanes)
    {
      return (n + lanes - 1) / lanes * lanes;
    }

    // Modes of general cells are scaled, see n_general_numbers.
    constexpr double g             = 0.57735026918962576451;
    constexpr double mode_scale[8] = {0., 1., 1., g, 1., g, g, 1. / 3.};

    template<typename Number>
    void add_block(Number *const dst, const std::uint32_t entry,
                   const std::array<double, 9> &block)
    {
      for (unsigned int i = 0; i < 9; ++i)
        dst[3 * std::size_t(entry) + i] += static_cast<Number>(block[i]);
    }
  } // namespace

  // ------------------------------------------------------ CongruentCells
  template<typename Number>
  CongruentCells<Number>::CongruentCells(const CellMap &map, const double lame_lambda,
                                         const double shear_modulus)
    : map_(map)
    , lame_lambda_(lame_lambda)
    , shear_modulus_(shear_modulus)
    , is_box_(map.is_box())
  {
  }

  template<typename Number>
  bool CongruentCells<Number>::contains(const CellMap &map, const double lame_lambda,
                                        const double shear_modulus) const
  {
    return lame_lambda == lame_lambda_ && shear_modulus == shear_modulus_ &&
           map_.is_congruent(map);
  }

  template<typename Number> void CongruentCells<Number>::add(const CellNodes &nodes)
  {
    unfinished_.push_back(nodes);
  }

  template<typename Number>
  void CongruentCells<Number>::finish(const Kernels<Number> &kernels)
  {
    const Patches found = find_patches(unfinished_);
    unfinished_         = std::deque<CellNodes>();
    cells_              = make_elements(found.cells, kernels);
    patches_            = make_elements(found.patches, kernels);
  }

  template<typename Number>
  template<std::size_t n_nodes>
  typename CongruentCells<Number>::Elements CongruentCells<Number>::make_elements(
    const std::vector<std::array<std::uint32_t, n_nodes>> &nodes,
    const Kernels<Number> &kernels) const
  {
    Elements result;
    result.n_elements = nodes.size();
    if (nodes.empty())
      return result;
    const std::size_t n_filled = round_up(nodes.size(), kernels.lanes);
    result.entries.resize(n_filled * n_nodes);
    for (std::size_t i = 0; i < n_filled; ++i)
      for (std::size_t n = 0; n < n_nodes; ++n)
        result.entries[index(i, n, n_nodes, kernels.lanes)] =
          3 * nodes[std::min(i, nodes.size() - 1)][n];

    const unsigned int nodes_of_a_line = n_nodes == 8 ? 2 : 3;
    const std::vector<double> values =
      affine_coefficients(map_, lame_lambda_, shear_modulus_, nodes_of_a_line, is_box_);
    result.coefficients.resize(values.size() * kernels.n_copies);
    Number *place = result.coefficients.data();
    for (const double value : values)
      place = std::fill_n(place, kernels.n_copies, static_cast<Number>(value));
    return result;
  }

  template<typename Number>
  void CongruentCells<Number>::add_product(const Kernels<Number> &kernels,
                                           Number *const dst,
                                           const Number *const src) const
  {
    const auto add = [&](const auto kernel, const Elements &elements) {
      if (elements.n_elements > 0)
        kernel(
          {elements.n_elements, elements.entries.data(), elements.coefficients.data()},
          dst, src);
    };
    add(is_box_ ? kernels.box_patches : kernels.affine_patches, patches_);
    add(is_box_ ? kernels.box_cells : kernels.affine_cells, cells_);
  }

  template<typename Number>
  void CongruentCells<Number>::add_diagonal_blocks(const Kernels<Number> &kernels,
                                                   Number *const dst) const
  {
    const auto of_cell = diagonal_blocks(map_, lame_lambda_, shear_modulus_);
    std::array<std::array<double, 9>, 27> of_patch = {};
    for (unsigned int child = 0; child < 8; ++child)
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int i = 0; i < 9; ++i)
          of_patch[node_in_patch(child, v)][i] += of_cell[v][i];

    const auto add = [&](const Elements &elements, const auto &blocks) {
      for (std::size_t i = 0; i < elements.n_elements; ++i)
        for (std::size_t n = 0; n < blocks.size(); ++n)
          add_block(dst, elements.entries[index(i, n, blocks.size(), kernels.lanes)],
                    blocks[n]);
    };
    add(patches_, of_patch);
    add(cells_, of_cell);
  }

  // ---------------------------------------------------- GeneralCellBlock
  namespace
  {
    constexpr std::size_t block_size = 4096;
  }

  template<typename Number>
  GeneralCellBlock<Number>::GeneralCellBlock(const unsigned int lanes)
    : lanes_(lanes)
  {
    resize(block_size);
  }

  template<typename Number> bool GeneralCellBlock<Number>::is_full() const
  {
    return n_cells_ == block_size;
  }

  template<typename Number>
  void GeneralCellBlock<Number>::resize(const std::size_t n_cells)
  {
    entries_.resize(8 * n_cells);
    entries_.shrink_to_fit();
    numbers_.resize(n_general_numbers * n_cells);
  }

  template<typename Number>
  std::uint32_t &GeneralCellBlock<Number>::entry(const std::size_t cell,
                                                 const unsigned int node)
  {
    return entries_[index(cell, node, 8, lanes_)];
  }

  template<typename Number>
  Number &GeneralCellBlock<Number>::number(const std::size_t cell, const unsigned int i)
  {
    return numbers_.data()[index(cell, i, n_general_numbers, lanes_)];
  }

  template<typename Number>
  void GeneralCellBlock<Number>::add(const CellNodes &nodes, const CellMap &map,
                                     const double lame_lambda, const double shear_modulus)
  {
    for (unsigned int node = 0; node < 8; ++node)
      entry(n_cells_, node) = 3 * nodes[node];
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int mode = 1; mode < 8; ++mode)
        number(n_cells_, 7 * c + mode - 1) = mode_scale[mode] * map.modes[c][mode];
    number(n_cells_, 21) = lame_lambda / 64.;
    number(n_cells_, 22) = shear_modulus / 64.;
    ++n_cells_;
  }

  template<typename Number> void GeneralCellBlock<Number>::finish()
  {
    const std::size_t end = round_up(n_cells_, lanes_);
    for (std::size_t cell = n_cells_; cell < end; ++cell)
      {
        for (unsigned int node = 0; node < 8; ++node)
          entry(cell, node) = entry(n_cells_ - 1, node);
        for (unsigned int i = 0; i < n_general_numbers; ++i)
          number(cell, i) = number(n_cells_ - 1, i);
      }
    resize(end);
  }

  template<typename Number>
  void GeneralCellBlock<Number>::add_product(const Kernels<Number> &kernels,
                                             Number *const dst,
                                             const Number *const src) const
  {
    kernels.general_cells({n_cells_, entries_.data(), numbers_.data()}, dst, src);
  }

  template<typename Number>
  void GeneralCellBlock<Number>::add_diagonal_blocks(Number *const dst) const
  {
    for (std::size_t cell = 0; cell < n_cells_; ++cell)
      {
        const auto number = [&](const unsigned int i) -> double {
          return numbers_.data()[index(cell, i, n_general_numbers, lanes_)];
        };
        CellMap map;
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int mode = 1; mode < 8; ++mode)
            map.modes[c][mode] = number(7 * c + mode - 1) / mode_scale[mode];
        const auto blocks = diagonal_blocks(map, 64. * number(21), 64. * number(22));
        for (unsigned int node = 0; node < 8; ++node)
          add_block(dst, entries_[index(cell, node, 8, lanes_)], blocks[node]);
      }
  }

  template class CongruentCells<float>;
  template class CongruentCells<double>;
  template class GeneralCellBlock<float>;
  template class GeneralCellBlock<double>;
} // namespace stiction::cell_kernel
