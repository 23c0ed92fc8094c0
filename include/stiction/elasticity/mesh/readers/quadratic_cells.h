#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <map>
#include <vector>

namespace stiction
{
  /// The shape of coarse cells of second order: each is the image of the unit
  /// cell under the triquadratic map through 27 nodes. Cells that come of a
  /// coarse cell lie in that image.
  class QuadraticCells
  {
  public:
    /// Nodes inside of edges, faces and cells, by the sorted vertices of the
    /// edge, the face or the cell.
    using InnerNodes = std::map<std::vector<unsigned int>, dealii::Point<3>>;

    using Cell = dealii::Triangulation<3>::cell_iterator;

    /// None: a mesh of first order.
    QuadraticCells() = default;

    /// Where an edge has no node it is straight; where a face or a cell has
    /// none it is the serendipity one, that of 8 or 20 nodes.
    QuadraticCells(const dealii::Triangulation<3> &coarse, InnerNodes inner_nodes);

    /// Those of cells with these nodes, x first, then y, z, by the index of the cell.
    using Nodes = std::vector<std::array<dealii::Point<3>, 27>>;
    explicit QuadraticCells(Nodes nodes)
      : nodes_(std::move(nodes))
    {
    }

    const Nodes &nodes() const { return nodes_; }

    bool empty() const { return nodes_.empty(); }

    /// Where a point of a cell is, of any level, in m. The same to the last
    /// digit from all cells around the point, whichever rank asks.
    dealii::Point<3> position(const Cell &cell, const dealii::Point<3> &unit_point) const;

    /// Moves the vertices of all cells of all levels to where they belong.
    void place_vertices(dealii::Triangulation<3> &triangulation) const;

    /// The determinant of the map of a cell of any level, in m³.
    double determinant(const Cell &cell, const dealii::Point<3> &unit_point) const;

  private:
    Nodes nodes_;
  };
} // namespace stiction
