#include <stiction/elasticity/mesh/body.h>
#include <stiction/simulation/checkpoint/mesh_history.h>

#include <cstring>

namespace stiction
{
  namespace
  {
    constexpr std::size_t words_of_cell = 3; // the refinement and the cell's id
    constexpr std::size_t bytes_of_id   = sizeof(dealii::CellId::binary_type);
    static_assert(bytes_of_id == 2 * sizeof(std::uint64_t));
  } // namespace

  MeshHistory::MeshHistory(const std::vector<std::uint64_t> &words)
  {
    for (std::size_t k = 0; k + words_of_cell <= words.size(); k += words_of_cell)
      {
        dealii::CellId::binary_type id;
        std::memcpy(id.data(), &words[k + 1], bytes_of_id);
        if (words[k] >= cut_.size())
          cut_.resize(words[k] + 1);
        cut_[words[k]].insert(dealii::CellId(id));
      }
  }

  std::vector<std::uint64_t> MeshHistory::words() const
  {
    std::vector<std::uint64_t> words;
    for (std::size_t k = 0; k < cut_.size(); ++k)
      for (const dealii::CellId &cell : cut_[k])
        {
          const auto id = cell.to_binary<3>();
          words.resize(words.size() + words_of_cell, k);
          std::memcpy(&words[words.size() - 2], id.data(), bytes_of_id);
        }
    return words;
  }

  void MeshHistory::add(const std::vector<bool> &is_cut, const Body &body)
  {
    cut_.emplace_back();
    for (const auto &cell : body.triangulation().active_cell_iterators())
      if (cell->is_locally_owned() && is_cut[cell->active_cell_index()])
        cut_.back().insert(cell->id());
  }

  void MeshHistory::repeat_on(Body &body) const
  {
    for (const Cells &cells : cut_)
      {
        std::vector<bool> is_cut(body.triangulation().n_active_cells(), false);
        for (const auto &cell : body.triangulation().active_cell_iterators())
          if (cell->is_locally_owned())
            is_cut[cell->active_cell_index()] = cells.count(cell->id()) > 0;
        body.refine(is_cut);
      }
  }
} // namespace stiction
