#include "product_cell.h"

#include <algorithm>
#include <bitset>

namespace stiction
{
  using dealii::Point;

  namespace
  {
    unsigned int n_bits(const unsigned int bits) { return std::bitset<8>(bits).count(); }

    bool has(const unsigned int bits, const unsigned int i)
    {
      return (bits >> i & 1) == 1;
    }

    // Of vertices that go around a face.
    std::vector<unsigned int> in_rows(std::vector<unsigned int> vertices)
    {
      if (vertices.size() == 4)
        std::swap(vertices[2], vertices[3]);
      return vertices;
    }

    // The polynomial in the weights of a factor's vertices that is 1 in the middle of
    // one or two of them and 0 in the middle of all others.
    double quadratic(const std::vector<double> &weights, const unsigned int bits)
    {
      double value = n_bits(bits) == 1 ? 1. : 4.;
      for (unsigned int i = 0; i < weights.size(); ++i)
        if (has(bits, i))
          value *= n_bits(bits) == 1 ? weights[i] * (2. * weights[i] - 1.) : weights[i];
      return value;
    }

    double linear(const std::vector<double> &weights, const unsigned int bits)
    {
      for (unsigned int i = 0; i < weights.size(); ++i)
        if (has(bits, i))
          return weights[i];
      return 0.;
    }
  } // namespace

  ProductCell::ProductCell(const dealii::CellData<3> &cell)
    : ProductCell(cell.vertices.size() == 4   ? std::vector<unsigned int>{4}
                  : cell.vertices.size() == 6 ? std::vector<unsigned int>{3, 2}
                                              : std::vector<unsigned int>{2, 2, 2},
                  cell.vertices)
  {
  }

  ProductCell::ProductCell(const dealii::CellData<2> &face)
    : ProductCell(face.vertices.size() == 3 ? std::vector<unsigned int>{3}
                                            : std::vector<unsigned int>{2, 2},
                  in_rows(face.vertices))
  {
  }

  std::vector<ProductCell::Part> ProductCell::parts(const unsigned int largest) const
  {
    std::vector<std::vector<unsigned int>> of_factors;
    for (const unsigned int n : factors_)
      {
        of_factors.emplace_back();
        for (unsigned int bits = 1; bits < 1U << n; ++bits)
          if (n_bits(bits) <= largest)
            of_factors.back().push_back(bits);
      }
    const auto size = [](const Part &part) {
      unsigned int sum = 0;
      for (const unsigned int bits : part)
        sum += n_bits(bits);
      return sum;
    };
    std::vector<Part> parts = product(of_factors);
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const Part &a, const Part &b) { return size(a) < size(b); });
    return parts;
  }

  ProductCell::Vertices ProductCell::vertices_of(const Part &part) const
  {
    Vertices chosen;
    for (unsigned int v = 0; v < vertices_.size(); ++v)
      {
        bool is_in        = true;
        unsigned int rest = v;
        for (unsigned int f = 0; f < factors_.size(); rest /= factors_[f++])
          is_in = is_in && has(part[f], rest % factors_[f]);
        if (is_in)
          chosen.push_back(vertices_[v]);
      }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  }

  std::vector<ProductCell::Vertices> ProductCell::edges_along(
    const unsigned int factor) const
  {
    std::vector<Vertices> edges;
    for (const Part &part : parts(2))
      {
        bool is_along = n_bits(part[factor]) == 2;
        for (unsigned int f = 0; f < factors_.size(); ++f)
          is_along = is_along && (f == factor || n_bits(part[f]) == 1);
        if (is_along)
          edges.push_back(vertices_of(part));
      }
    return edges;
  }

  ProductCell::Coordinates ProductCell::middle_of(const Part &part) const
  {
    Coordinates point;
    for (unsigned int f = 0; f < factors_.size(); ++f)
      {
        point.emplace_back(factors_[f], 0.);
        for (unsigned int i = 0; i < factors_[f]; ++i)
          if (has(part[f], i))
            point[f][i] = 1. / n_bits(part[f]);
      }
    return point;
  }

  void ProductCell::find_nodes(const MeshData &mesh)
  {
    double size = 0.;
    for (const unsigned int v : vertices_)
      size = std::max(size, mesh.vertices[v].distance(mesh.vertices[vertices_[0]]));
    for (const Part &part : parts(mesh.inner_nodes.empty() ? 1 : 2))
      {
        const Vertices vertices = vertices_of(part);
        if (vertices.size() == 1)
          {
            nodes_.push_back({part, mesh.vertices[vertices[0]]});
            continue;
          }
        const auto known = mesh.inner_nodes.find(vertices);
        const Point<3> at =
          known != mesh.inner_nodes.end() ? known->second : from_its_boundary(part);
        Point<3> straight;
        for (const unsigned int v : vertices)
          straight += mesh.vertices[v] / static_cast<double>(vertices.size());
        // files have some 16 digits
        is_curved_ = is_curved_ || at.distance(straight) > 1e-10 * size;
        nodes_.push_back({part, at});
      }
  }

  // That of the serendipity elements; for an edge, the mean of its ends.
  Point<3> ProductCell::from_its_boundary(const Part &part) const
  {
    Point<3> sum;
    for (const Node &node : nodes_)
      {
        bool is_in              = true;
        unsigned int difference = 0;
        for (unsigned int f = 0; f < factors_.size(); ++f)
          {
            is_in = is_in && (node.part[f] & ~part[f]) == 0;
            difference += n_bits(part[f]) - n_bits(node.part[f]);
          }
        if (is_in && difference > 0)
          sum += (difference % 2 == 1 ? 1. : -1.) / (1 << difference) * node.position;
      }
    return sum;
  }

  Point<3> ProductCell::position(const Coordinates &point) const
  {
    const std::size_t n_nodes = is_curved_ ? nodes_.size() : vertices_.size();
    Point<3> sum;
    for (std::size_t i = 0; i < n_nodes; ++i)
      {
        double weight = 1.;
        for (unsigned int f = 0; f < factors_.size(); ++f)
          weight *= (is_curved_ ? quadratic : linear)(point[f], nodes_[i].part[f]);
        sum += weight * nodes_[i].position;
      }
    return sum;
  }
} // namespace stiction
