#pragma once

#include <stiction/contact/obstacles/obstacle.h>

#include <memory>

namespace stiction
{
  /// The signed distance from a surface of triangles, open or closed.
  ///
  /// The sign follows from the angle-weighted normals at vertices and edges
  /// (Bærentzen, Aanæs: Signed distance computation using the angle weighted
  /// pseudonormal, 2005), which is right for any closed surface; an open one
  /// has the side from which its triangles run counterclockwise as its outside.
  /// The gradient is the normal of the nearest triangle, or points away from
  /// the nearest edge or vertex.
  class ObstacleSurface : public Obstacle
  {
  public:
    /// The triangles, none of them without an area.
    explicit ObstacleSurface(TriangulatedSurface surface);
    ~ObstacleSurface() override;

    Value at(const dealii::Point<3> &p) const override;

    Value facing(const dealii::Point<3> &p,
                 const dealii::Tensor<1, 3> &normal) const override;

    const TriangulatedSurface *triangles() const override;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
  };
} // namespace stiction
