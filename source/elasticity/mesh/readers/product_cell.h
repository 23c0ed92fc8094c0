#pragma once

#include <stiction/elasticity/mesh/readers/mesh_data.h>

#include <vector>

namespace stiction
{
  /// All choices of an item of each list, that of the first list changing fastest.
  template<typename Item>
  std::vector<std::vector<Item>> product(const std::vector<std::vector<Item>> &lists)
  {
    std::vector<std::vector<Item>> choices = {{}};
    for (auto list = lists.rbegin(); list != lists.rend(); ++list)
      {
        std::vector<std::vector<Item>> longer;
        for (const auto &choice : choices)
          for (const Item &item : *list)
            {
              longer.push_back({item});
              longer.back().insert(longer.back().end(), choice.begin(), choice.end());
            }
        choices.swap(longer);
      }
    return choices;
  }

  /// A cell or a face as a product of simplices: a tetrahedron is one, a prism a
  /// triangle times a segment, a hexahedron three segments. The first factor counts
  /// fastest in the numbers of vertices, as it does in deal.II.
  class ProductCell
  {
  public:
    /// Some vertices of each factor, as the bits of a number: their product is a
    /// vertex of the cell, an edge, a face or the cell itself.
    using Part = std::vector<unsigned int>;

    /// Of a point: for each factor the weights, with the sum 1, with which it is the
    /// mean of the factor's vertices.
    using Coordinates = std::vector<std::vector<double>>;

    using Vertices = std::vector<unsigned int>;

    /// @param factors how many vertices each factor has.
    ProductCell(std::vector<unsigned int> factors, Vertices vertices)
      : factors_(std::move(factors))
      , vertices_(std::move(vertices))
    {
    }

    explicit ProductCell(const dealii::CellData<3> &cell);

    explicit ProductCell(const dealii::CellData<2> &face);

    /// How many vertices each factor has: 4; 3, 2 or 2, 2, 2.
    const std::vector<unsigned int> &factors() const { return factors_; }

    /// Those with at most so many vertices of each factor: vertices first, then what
    /// has one vertex more, and so on.
    std::vector<Part> parts(unsigned int largest) const;

    /// Those of the mesh in a part, sorted.
    Vertices vertices_of(const Part &part) const;

    /// Of each edge along a factor.
    std::vector<Vertices> edges_along(unsigned int factor) const;

    Coordinates middle_of(const Part &part) const;

    /// Takes the nodes of the mesh, those of second order as well.
    void find_nodes(const MeshData &mesh);

    /// Whether nodes of second order are elsewhere than in a straight cell. After
    /// find_nodes().
    bool is_curved() const { return is_curved_; }

    /// Where a point is, in m: by polynomials of first order in each factor, of
    /// second order if the cell is curved. After find_nodes().
    dealii::Point<3> position(const Coordinates &point) const;

  private:
    struct Node
    {
      Part part; // in the middle of which it is
      dealii::Point<3> position;
    };

    dealii::Point<3> from_its_boundary(const Part &part) const;

    std::vector<unsigned int> factors_;
    Vertices vertices_;
    std::vector<Node> nodes_; // vertices first
    bool is_curved_ = false;
  };
} // namespace stiction
