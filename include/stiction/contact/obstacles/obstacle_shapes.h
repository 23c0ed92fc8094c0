#pragma once

#include <stiction/contact/obstacles/obstacle.h>

namespace stiction
{
  /// A plane, sphere, cylinder or paraboloid given by numbers, with exact
  /// gradients:
  ///
  ///   plane       point p, normal n     ψ = (x − p)·n/‖n‖
  ///   sphere      centre c, radius R    ψ = ‖x − c‖ − R
  ///   cylinder    point p, axis a, R    ψ = r − R
  ///   paraboloid  apex p, axis a, R     ψ = s + r²/(2R)
  ///
  /// with s the coordinate along the axis from p and r the distance from it.
  /// R < 0 makes sphere and cylinder a cavity, ψ = −R − ‖x − c‖ and so on, and
  /// the paraboloid a cup.
  ///
  /// @param numbers the text after the shape's name: formulas separated by ';'
  ///   that do not depend on the place.
  /// @param location as for Obstacle::read().
  /// @return nothing if there is no shape of that name.
  ///
  /// Throws InputError for a wrong count of numbers, for directions without a
  /// length and for R = 0.
  std::unique_ptr<Obstacle> make_obstacle_shape(const std::string &name,
                                                const std::string &numbers,
                                                const std::string &location, double time);
} // namespace stiction
