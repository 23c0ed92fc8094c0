#include <stiction/elasticity/mesh/mesh_pieces.h>

#include <deal.II/base/mpi.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the size of all: nodes this near to one another are at the same place.
    constexpr double same_place = 1e-8;

    // One label a piece in place of several or none.
    std::vector<std::string> names_of(const std::vector<std::set<std::string>> &labels)
    {
      std::map<std::string, unsigned int> n_of, i_of;
      std::vector<std::string> names;
      for (const auto &of_piece : labels)
        names.push_back(of_piece.size() == 1 && !of_piece.begin()->empty()
                          ? *of_piece.begin()
                          : "body");
      for (const std::string &name : names)
        ++n_of[name];
      for (std::string &name : names)
        if (n_of[name] > 1)
          name += ' ' + std::to_string(++i_of[name]);
      return names;
    }
  } // namespace

  MeshPieces::MeshPieces(
    const Triangulation<3> &triangulation,
    const std::function<std::string(const Triangulation<3>::cell_iterator &)> &name)
    : piece_of_coarse_cell_(triangulation.n_cells(0))
  {
    boost::disjoint_sets_with_storage<> connected(triangulation.n_vertices());
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        connected.union_set(cell->vertex_index(0), cell->vertex_index(v));
    std::map<std::size_t, unsigned int> number;
    std::vector<std::set<std::string>> labels;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      {
        const auto place = number.emplace(connected.find_set(cell->vertex_index(0)),
                                          static_cast<unsigned int>(labels.size()));
        if (place.second)
          labels.emplace_back();
        const unsigned int piece             = place.first->second;
        piece_of_coarse_cell_[cell->index()] = piece;
        labels[piece].insert(name(cell));
      }
    pieces_.clear();
    for (const std::string &name : names_of(labels))
      pieces_.push_back({name, {}});
  }

  unsigned int MeshPieces::of(Triangulation<3>::cell_iterator cell) const
  {
    if (pieces_.size() == 1)
      return 0;
    while (cell->level() > 0)
      cell = cell->parent();
    return piece_of_coarse_cell_[cell->index()];
  }

  std::vector<std::pair<unsigned int, unsigned int>> MeshPieces::touching(
    const Triangulation<3> &triangulation) const
  {
    if (pieces_.size() == 1)
      return {};
    BoundingBox<3> all = pieces_.front().box;
    for (const Piece &piece : pieces_)
      all.merge_with(piece.box);
    const Point<3> &corner = all.get_boundary_points().first;
    const double unit      = same_place * diameter(all);
    std::map<std::array<long long, 3>, std::set<unsigned int>> at;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        {
          std::array<long long, 3> place;
          for (unsigned int c = 0; c < 3; ++c)
            place[c] = std::llround((cell->vertex(v)[c] - corner[c]) / unit);
          at[place].insert(of(cell));
        }
    std::set<std::pair<unsigned int, unsigned int>> pairs;
    for (const auto &[place, pieces] : at)
      for (auto p = pieces.begin(); p != pieces.end(); ++p)
        for (auto q = std::next(p); q != pieces.end(); ++q)
          pairs.emplace(*p, *q);
    return {pairs.begin(), pairs.end()};
  }

  std::set<unsigned int> MeshPieces::at_boundary(const Triangulation<3> &triangulation,
                                                 const types::boundary_id id) const
  {
    std::set<unsigned int> pieces;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && face->boundary_id() == id)
          pieces.insert(of(cell));
    return pieces;
  }

  void MeshPieces::find_boxes(const Triangulation<3> &triangulation,
                              const std::vector<std::vector<Point<3>>> &points)
  {
    // of the coarse cells, which every rank knows, and of those at hand: a
    // curved body grows when it is refined
    const double far = std::numeric_limits<double>::max();
    std::vector<std::array<double, 6>> ends(pieces_.size(),
                                            {{far, far, far, far, far, far}});
    const auto add = [&](const unsigned int piece, const Point<3> &p) {
      for (unsigned int d = 0; d < 3; ++d)
        {
          ends[piece][d]     = std::min(ends[piece][d], p[d]);
          ends[piece][3 + d] = std::min(ends[piece][3 + d], -p[d]);
        }
    };
    for (const auto &cell : triangulation.cell_iterators())
      if (cell->level() == 0 || cell->is_active())
        for (const unsigned int v : cell->vertex_indices())
          add(of(cell), cell->vertex(v));
    for (unsigned int piece = 0; piece < points.size(); ++piece)
      for (const Point<3> &p : points[piece])
        add(piece, p);
    for (unsigned int piece = 0; piece < pieces_.size(); ++piece)
      {
        std::pair<Point<3>, Point<3>> corners;
        for (unsigned int d = 0; d < 3; ++d)
          {
            corners.first[d] =
              Utilities::MPI::min(ends[piece][d], triangulation.get_communicator());
            corners.second[d] =
              -Utilities::MPI::min(ends[piece][3 + d], triangulation.get_communicator());
          }
        pieces_[piece].box = BoundingBox<3>(corners);
      }
  }
} // namespace stiction
