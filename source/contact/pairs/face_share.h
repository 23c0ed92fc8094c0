#pragma once

#include <stiction/contact/pairs/face_overlap.h>

#include <algorithm>
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
    double value, overlap, gap, modulus;
    double smallest, largest; ///< gap of the face
    double diameter;          ///< of the face
    double cover;             ///< of the face, how much has something opposite; 2: twice
    std::array<double, 3> normal; ///< of the master, × area

    bool is_own() const { return master == dealii::numbers::invalid_dof_index; }

    /// How far away what the face sees is, on either side.
    double nearest() const { return std::max({smallest, -largest, 0.}); }
    double farthest() const { return std::max(largest, -smallest); }
  };

  /// Those of a face with these points.
  std::vector<FaceShare> shares_of(const SurfaceFace &slave,
                                   const std::vector<CoveredPoint> &points);
} // namespace stiction
