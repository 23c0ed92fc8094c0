#pragma once

#include <stiction/contact/obstacles/stl_file.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <functional>
#include <optional>

namespace stiction
{
  /// The surface in a box on which a function is zero, by marching cubes of
  /// which the longest side of the box has 41 at most.
  ///
  /// @param distance the function, or nothing where it has no value: cubes with
  ///   such a corner are left out.
  TriangulatedSurface zero_set(
    const std::function<std::optional<double>(const dealii::Point<3> &)> &distance,
    const dealii::BoundingBox<3> &box);
} // namespace stiction
