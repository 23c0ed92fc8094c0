#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  /// The diagonal of a box, m.
  inline double diameter(const dealii::BoundingBox<3> &box)
  {
    return box.get_boundary_points().first.distance(box.get_boundary_points().second);
  }

  /// A part of a mesh that shares no vertex with others: an elastic body of its own,
  /// which meets others in contact alone.
  struct Piece
  {
    std::string name;           ///< what the user calls it
    dealii::BoundingBox<3> box; ///< the smallest around it, in m

    /// Half the diagonal of the box, m.
    double radius() const { return diameter(box) / 2.; }
  };

  /// The pieces of a mesh, in the order of their first coarse cells.
  class MeshPieces
  {
  public:
    /// One.
    MeshPieces() = default;

    /// Finds them.
    ///
    /// @param triangulation with coarse cells that all ranks know.
    /// @param name of the body of a coarse cell. A piece of which it says nothing, or
    ///   several names, is called "body 2", as the second one; several of one name are
    ///   told apart by numbers.
    MeshPieces(
      const dealii::Triangulation<3> &triangulation,
      const std::function<std::string(const dealii::Triangulation<3>::cell_iterator &)>
        &name);

    const std::vector<Piece> &list() const { return pieces_; }

    /// The place in list() of a cell of any level.
    unsigned int of(dealii::Triangulation<3>::cell_iterator cell) const;

    /// Pieces that touch or overlap from the start, or that were meant to be one there,
    /// each pair once: of one of them a coarse face has its middle, or a place beside a
    /// corner, in the other. Not those that meet at an edge alone.
    std::vector<std::pair<unsigned int, unsigned int>> touching(
      const dealii::Triangulation<3> &triangulation) const;

    /// The pieces with coarse cells at a boundary.
    std::set<unsigned int> at_boundary(dealii::types::boundary_id id) const;

    /// Makes the boxes hold the cells that this rank knows and these points, of all
    /// ranks. Collective.
    ///
    /// @param points by piece.
    void find_boxes(const dealii::Triangulation<3> &triangulation,
                    const std::vector<std::vector<dealii::Point<3>>> &points);

  private:
    std::vector<Piece> pieces_ = {{"body", {}}};
    std::vector<unsigned int> piece_of_coarse_cell_; // by index()
    std::map<dealii::types::boundary_id, std::set<unsigned int>> at_boundary_;
  };
} // namespace stiction
