#pragma once

#include "face_share.h"

#include <stiction/contact/pairs/face_overlap.h>

#include <vector>

namespace stiction
{
  /// Leaves of the points of a slave face those that see the nearest sheet of what is
  /// opposite. Faces joined by nodes are one sheet, as the flank of one turn of a thread.
  /// Others count where they lie beside it, at a distance that differs by less than the
  /// diameter of the face: not behind it, as the next turn does.
  void keep_nearest_sheets(const FaceOverlap &overlap, double diameter,
                           std::vector<CoveredPoint> &points);

  /// Leaves of the shares of each slave node those of faces that see the nearest sheet:
  /// at the end of a tooth one face may see it, and the next one the tooth behind.
  void keep_nearest_sheets(std::vector<FaceShare> &shares);
} // namespace stiction
