#pragma once

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace stiction
{
  /// Coarse spaces for a mesh of hexahedra that was refined from nothing: trilinear
  /// functions on grids of cubes behind it, the first twice as wide as its cells, each
  /// further one twice as wide as the one before (semi-geometric multigrid: Dickopf,
  /// Krause; Grasedyck, Wang, Xu, arXiv 1410.2153).
  ///
  /// The parts of the body in one cube that hang together by cells of the mesh alone
  /// have their own trilinear functions, so that the lips of a crack and the arms of a
  /// fork move apart on every grid (Nesme, Kry, Jeřábková, Faure 2009). Where cells
  /// differ by two or more in size, every node has cubes of twice the size of the cells
  /// around it; functions of cubes of all sizes with the same place are one function.
  /// Linear functions are interpolated exactly in any case.
  ///
  /// Row i of the g-th matrix interpolates node i of the mesh (g = 0) or vertex i of the
  /// grid g − 1 from the vertices of grid g. The last grid is as small as a dense
  /// matrix may be, or cannot get smaller.
  ///
  /// @param nodes their places, m.
  /// @param cells the nodes of the cells, in the order of HexahedralCell.
  std::vector<Eigen::SparseMatrix<float, Eigen::RowMajor>> background_grids(
    const std::vector<std::array<double, 3>> &nodes,
    const std::vector<std::array<unsigned int, 8>> &cells);
} // namespace stiction
