#include <stiction/elasticity/mesh/readers/quadratic_cells.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // 0 at the beginning of an edge, 1 in the middle, 2 at the end
    using Place = std::array<unsigned int, 3>;

    Place place(const unsigned int node) { return {{node % 3, node / 3 % 3, node / 9}}; }

    // Of what a node is the middle: 0 a vertex, 1 an edge, 2 a face, 3 a cell.
    unsigned int dimension(const Place &node)
    {
      return std::count(node.begin(), node.end(), 1);
    }

    bool is_in(const Place &node, const Place &part)
    {
      for (unsigned int d = 0; d < 3; ++d)
        if (part[d] != 1 && part[d] != node[d])
          return false;
      return true;
    }

    // The quadratic polynomials that are 1 at 0, 1/2 or 1 and 0 at the others.
    std::array<double, 3> values(const double x)
    {
      return {{(1. - x) * (1. - 2. * x), 4. * x * (1. - x), x * (2. * x - 1.)}};
    }

    // The index of the coarse cell that a cell comes of, and where the point is
    // there. (The number of the coarse cell in a CellId is that of p4est.)
    std::pair<unsigned int, Point<3>> in_coarse_cell(QuadraticCells::Cell cell,
                                                     Point<3> unit_point)
    {
      const CellId id     = cell->id();
      const auto children = id.get_child_indices();
      for (auto child = children.end(); child != children.begin();)
        {
          unit_point = GeometryInfo<3>::child_to_cell_coordinates(unit_point, *--child);
          cell       = cell->parent();
        }
      return {cell->index(), unit_point};
    }

    std::array<double, 3> slopes(const double x)
    {
      return {{4. * x - 3., 4. - 8. * x, 4. * x - 1.}};
    }
  } // namespace

  QuadraticCells::QuadraticCells(const Triangulation<3> &coarse, InnerNodes inner_nodes)
  {
    if (inner_nodes.empty())
      return;
    std::array<unsigned int, 27> vertices_first;
    for (unsigned int i = 0; i < 27; ++i)
      vertices_first[i] = i;
    std::stable_sort(vertices_first.begin(), vertices_first.end(),
                     [](const unsigned int a, const unsigned int b) {
                       return dimension(place(a)) < dimension(place(b));
                     });
    nodes_.resize(coarse.n_cells(0));
    for (const auto &cell : coarse.cell_iterators_on_level(0))
      for (const unsigned int i : vertices_first)
        {
          auto &nodes            = nodes_[cell->index()];
          const Place part       = place(i);
          const unsigned int dim = dimension(part);
          std::vector<unsigned int> vertices;
          for (const unsigned int v : GeometryInfo<3>::vertex_indices())
            if (is_in({{2 * (v & 1), v & 2, (v & 4) / 2}}, part))
              vertices.push_back(cell->vertex_index(v));
          if (dim == 0)
            {
              nodes[i] = coarse.get_vertices()[vertices.front()];
              continue;
            }
          std::sort(vertices.begin(), vertices.end());
          const auto known = inner_nodes.find(vertices);
          if (known != inner_nodes.end())
            {
              nodes[i] = known->second;
              continue;
            }
          // from the nodes on its boundary
          for (unsigned int j = 0; j < 27; ++j)
            if (j != i && is_in(place(j), part))
              {
                const unsigned int difference = dim - dimension(place(j));
                nodes[i] +=
                  (difference % 2 == 1 ? 1. : -1.) / (1 << difference) * nodes[j];
              }
          // the same for the neighbours, whatever the order of their nodes
          inner_nodes.emplace(vertices, nodes[i]);
        }
  }

  Point<3> QuadraticCells::position(const Cell &cell, const Point<3> &unit_point) const
  {
    const auto [coarse_cell, p] = in_coarse_cell(cell, unit_point);

    const auto x = values(p[0]), y = values(p[1]), z = values(p[2]);
    std::array<std::array<double, 3>, 27> terms;
    unsigned int n = 0;
    for (unsigned int i = 0; i < 27; ++i)
      {
        const Place node    = place(i);
        const double weight = x[node[0]] * y[node[1]] * z[node[2]];
        if (weight == 0.)
          continue;
        const Point<3> &at = nodes_[coarse_cell][i];
        terms[n++]         = {{weight * at[0], weight * at[1], weight * at[2]}};
      }
    // Neighbours have them in another order.
    std::sort(terms.begin(), terms.begin() + n);
    Point<3> sum;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += terms[i][d];
    return sum;
  }

  void QuadraticCells::place_vertices(Triangulation<3> &triangulation) const
  {
    std::vector<bool> is_placed(triangulation.n_vertices());
    for (const auto &cell : triangulation.cell_iterators())
      for (const unsigned int v : GeometryInfo<3>::vertex_indices())
        if (!is_placed[cell->vertex_index(v)])
          {
            is_placed[cell->vertex_index(v)] = true;
            cell->vertex(v) = position(cell, GeometryInfo<3>::unit_cell_vertex(v));
          }
  }

  double QuadraticCells::determinant(const Cell &cell, const Point<3> &unit_point) const
  {
    const auto [coarse_cell, p] = in_coarse_cell(cell, unit_point);
    std::array<std::array<double, 3>, 3> value, slope;
    for (unsigned int d = 0; d < 3; ++d)
      {
        value[d] = values(p[d]);
        slope[d] = slopes(p[d]);
      }
    Tensor<2, 3> jacobian;
    for (unsigned int i = 0; i < 27; ++i)
      {
        const Place node = place(i);
        Tensor<1, 3> gradient;
        for (unsigned int d = 0; d < 3; ++d)
          {
            gradient[d] = 1.;
            for (unsigned int e = 0; e < 3; ++e)
              gradient[d] *= (d == e ? slope : value)[e][node[e]];
          }
        jacobian += outer_product(Tensor<1, 3>(nodes_[coarse_cell][i]), gradient);
      }
    const double n_cells = std::pow(8., cell->level());
    return dealii::determinant(jacobian) / n_cells;
  }
} // namespace stiction
