#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <array>
#include <functional>
#include <tuple>
#include <vector>

namespace stiction
{
  class Body;
  class MeshLevel;

  /// Trilinear interpolation from a level of the mesh to the next finer one, or
  /// from its vertices to the nodes of elements of degree 2, and its transpose.
  ///
  /// A fine node lies on a coarse vertex, or in the middle of an edge, a face
  /// or a cell: its value is the mean of one, two, four or eight coarse ones.
  /// For trilinear elements on cells cut into eight the coarse functions are
  /// fine functions, so this is the natural embedding on any hexahedra.
  class LevelTransfer
  {
  public:
    /// @param fine_level the number of the finer level. All arguments must
    ///   outlive the object. Collective.
    LevelTransfer(const Body &body, unsigned int fine_level, const MeshLevel &coarse,
                  const MeshLevel &fine);

    /// fine = P coarse. Collective.
    void prolongate(LA::Vector &fine, const LA::Vector &coarse) const;

    /// fine += P coarse. Collective.
    template<typename Number>
    void prolongate_add(LA::VectorOf<Number> &fine,
                        const LA::VectorOf<Number> &coarse) const;

    /// coarse = Pᵀ fine. Collective.
    template<typename Number>
    void restrict_to(LA::VectorOf<Number> &coarse,
                     const LA::VectorOf<Number> &fine) const;

    /// The values of the fine vector at the coarse vertices. Collective.
    void inject(LA::Vector &coarse, const LA::Vector &fine) const;

    /// Calls back with every fine node this rank interpolates to, its coarse
    /// nodes and their number; each fine node is somebody's. Local numbers.
    void for_each_row(
      const std::function<void(unsigned int fine_node, const unsigned int *coarse_nodes,
                               unsigned int n_coarse_nodes)> &callback) const;

  private:
    /// Fine nodes with the same number n of coarse ones: n + 1 numbers each,
    /// the fine node first.
    template<unsigned int n> using Rows = std::vector<std::array<unsigned int, n + 1>>;

    std::tuple<Rows<1>, Rows<2>, Rows<4>, Rows<8>> rows_;
  };
} // namespace stiction
