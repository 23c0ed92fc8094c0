#pragma once

#include "face_share.h"

#include <vector>

namespace stiction
{
  /// Leaves of the points of a slave face those that see the nearest sheet of what is
  /// opposite, and others that are not farther than it by more than the diameter of the
  /// face and not behind it on the same body. Faces joined by nodes are one sheet, as the
  /// flank of one turn of a thread is: the next turn is another one.
  void keep_nearest_sheets(double diameter, std::vector<CoveredPoint> &points);

  /// The same of the shares of each slave node: at the end of a tooth one face may see
  /// it, and the next one the tooth behind.
  void keep_nearest_sheets(std::vector<FaceShare> &shares);
} // namespace stiction
