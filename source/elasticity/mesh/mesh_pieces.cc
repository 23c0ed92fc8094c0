#include <stiction/elasticity/mesh/mesh_pieces.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/numerics/rtree.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the size of a cell: what is this near to it is on its surface.
    constexpr double same_place = 1e-6;

    // Of the way from a corner of a face to its middle.
    constexpr double beside = 0.01;

    // Whether a point is in a coarse cell or on its surface.
    bool is_in(const Triangulation<3>::cell_iterator &cell, const Point<3> &p)
    {
      try
        {
          return GeometryInfo<3>::is_inside_unit_cell(
            StaticMappingQ1<3>::mapping.transform_real_to_unit_cell(cell, p), same_place);
        }
      catch (const Mapping<3>::ExcTransformationFailed &)
        {
          return false;
        }
    }

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
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            at_boundary_[face->boundary_id()].insert(piece);
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
    using Cell = Triangulation<3>::cell_iterator;
    std::set<std::pair<unsigned int, unsigned int>> pairs;
    if (pieces_.size() == 1)
      return {};
    std::vector<std::pair<BoundingBox<3>, Cell>> boxes;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      boxes.emplace_back(cell->bounding_box(), cell);
    const auto tree     = pack_rtree(boxes);
    const auto find_one = [&](const Cell &cell, const Point<3> &p) {
      const unsigned int piece = of(cell);
      BoundingBox<3> at(std::make_pair(p, p));
      at.extend(same_place * cell->diameter());
      for (unsigned int other = 0; other < pieces_.size(); ++other)
        {
          const auto pair = std::minmax(piece, other);
          if (other == piece || pairs.count(pair) > 0 ||
              !pieces_[other].box.point_inside(p, same_place))
            continue;
          namespace bgi = boost::geometry::index;
          for (auto found = tree.qbegin(bgi::intersects(at)); found != tree.qend();
               ++found)
            if (of(found->second) == other && is_in(found->second, p))
              pairs.insert(pair);
        }
    };
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            // bodies that meet at an edge or a corner alone do not touch
            const Point<3> center = face->center();
            find_one(cell, center);
            for (const unsigned int v : face->vertex_indices())
              find_one(cell, face->vertex(v) + beside * (center - face->vertex(v)));
          }
    return {pairs.begin(), pairs.end()};
  }

  std::set<unsigned int> MeshPieces::at_boundary(const types::boundary_id id) const
  {
    if (pieces_.size() == 1)
      return {0};
    const auto found = at_boundary_.find(id);
    return found != at_boundary_.end() ? found->second : std::set<unsigned int>();
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
