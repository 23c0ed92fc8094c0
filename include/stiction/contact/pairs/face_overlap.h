#pragma once

#include <stiction/contact/pairs/surface_face.h>

#include <array>
#include <vector>

namespace stiction
{
  /// Where a face lies opposite to another one: points of quadrature on the part of the
  /// first that the second covers, seen along the normal at the centre of the first, and
  /// with weight 0 the corners of that part.
  struct OverlapPoint
  {
    double weight;                       ///< an area of the first face, m²
    double part;                         ///< of the first face as it is projected
    std::array<double, 2> first, second; ///< where it is in the unit squares
    double gap;                          ///< from the first to the second, m
  };

  /// The first of two faces on its own plane, on which others are projected.
  ///
  /// After Puso and Laursen (2004): the projections are clipped to convex polygons, and
  /// these are cut into triangles, which carry rules of high degree.
  class FaceOverlap
  {
  public:
    explicit FaceOverlap(const SurfaceFace &first);

    /// The points of the part covered by the second face, none if they look in the same
    /// direction. Faces are opposite up to an angle of 84 degrees.
    std::vector<OverlapPoint> with(const SurfaceFace &second) const;

  private:
    using Point2 = std::array<double, 2>;

    /// A face on the plane, and how far its nodes are above it.
    struct Projected
    {
      unsigned int degree;
      std::array<Point2, 9> nodes;
      std::array<double, 9> heights;

      unsigned int n_nodes() const { return (degree + 1) * (degree + 1); }
    };

    Projected project(const SurfaceFace &face) const;

    /// Whether the boxes around them on the plane do not meet.
    static bool are_apart(const Projected &first, const Projected &second);

    /// Convex ones that together are the face.
    static std::vector<std::vector<Point2>> polygons(const Projected &face);

    /// Where a point of the plane is in the unit square of a face.
    static Point2 in_unit_square(const Projected &face, const Point2 &p);

    const SurfaceFace &first_;
    dealii::Point<3> centre_;
    dealii::Tensor<1, 3> normal_, along1_, along2_;
    Projected on_plane_;
    double area_ = 0.; ///< of its polygons
  };
} // namespace stiction
