#pragma once

#include <stiction/contact/pairs/face_overlap.h>

#include <array>
#include <vector>

namespace stiction
{
  /// A point of a slave face that has another face opposite.
  struct CoveredPoint
  {
    OverlapPoint at;
    const SurfaceFace *master;
  };

  /// What one slave face adds to D, M and the gaps of a Mortar: sent to all ranks as it
  /// is.
  struct FaceShare
  {
    dealii::types::global_dof_index slave, master; ///< invalid: to D and to the gap
    double value, overlap, gap, smallest, largest, modulus;
    double cover; ///< of the face, how much has something opposite; 2: twice
    std::array<double, 3> normal; ///< of the master, × area
  };

  /// Those of a face with these points.
  std::vector<FaceShare> shares_of(const SurfaceFace &slave,
                                   const std::vector<CoveredPoint> &points);
} // namespace stiction
