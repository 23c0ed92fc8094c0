#include <stiction/contact/pairs/face_overlap.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Point2  = std::array<double, 2>;
    using Polygon = std::vector<Point2>;

    // Of the face: a smaller overlap is rounding.
    constexpr double no_area = 1e-12;

    // Twice the area of a triangle, positive if its corners go round counterclockwise.
    double cross(const Point2 &a, const Point2 &b, const Point2 &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    double area(const Polygon &polygon)
    {
      double sum = 0.;
      for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += cross(polygon[0], polygon[i - 1], polygon[i]) / 2.;
      return sum;
    }

    // The part of a polygon inside of a convex one (Sutherland and Hodgman, 1974), both
    // counterclockwise.
    Polygon clip(Polygon polygon, const Polygon &window)
    {
      for (std::size_t k = 0; k < window.size() && !polygon.empty(); ++k)
        {
          const Point2 &from = window[k], &to = window[(k + 1) % window.size()];
          Polygon inside;
          for (std::size_t i = 0; i < polygon.size(); ++i)
            {
              const Point2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
              const double at_p = cross(from, to, p), at_q = cross(from, to, q);
              if (at_p >= 0.)
                inside.push_back(p);
              if (at_p * at_q < 0.)
                {
                  const double s = at_p / (at_p - at_q);
                  inside.push_back(
                    {{p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])}});
                }
            }
          polygon = std::move(inside);
        }
      return polygon;
    }

    // Of the products of shape functions of both faces.
    const Quadrature<2> &rule(const unsigned int degree)
    {
      static const QGaussSimplex<2> linear(3), quadratic(4);
      return degree == 1 ? linear : quadratic;
    }
  } // namespace

  bool FaceOverlap::are_apart(const Projected &first, const Projected &second)
  {
    const auto range = [](const Projected &face, const unsigned int d) {
      const auto ends = std::minmax_element(
        face.nodes.begin(), face.nodes.begin() + face.n_nodes(),
        [d](const Point2 &p, const Point2 &q) { return p[d] < q[d]; });
      return std::make_pair((*ends.first)[d], (*ends.second)[d]);
    };
    for (unsigned int d = 0; d < 2; ++d)
      {
        const auto one = range(first, d), other = range(second, d);
        if (one.second < other.first || other.second < one.first)
          return true;
      }
    return false;
  }

  FaceOverlap::FaceOverlap(const SurfaceFace &first)
    : first_(first)
    , centre_(first.centre())
    , normal_(first.normal())
  {
    const auto corners = first.corners();
    along1_            = corners[1] - corners[0];
    along1_ -= (along1_ * normal_) * normal_;
    along1_ /= along1_.norm();
    along2_   = cross_product_3d(normal_, along1_);
    on_plane_ = project(first);
    for (const Polygon &polygon : polygons(on_plane_))
      area_ += area(polygon);
  }

  FaceOverlap::Projected FaceOverlap::project(const SurfaceFace &face) const
  {
    Projected projected{};
    projected.degree = face.degree;
    for (unsigned int i = 0; i < face.n_nodes(); ++i)
      {
        const Tensor<1, 3> x = face.node(i) - centre_;
        projected.nodes[i]   = {{x * along1_, x * along2_}};
        projected.heights[i] = x * normal_;
      }
    return projected;
  }

  std::vector<std::vector<Point2>> FaceOverlap::polygons(const Projected &face)
  {
    const auto &at = face.nodes;
    std::vector<Polygon> all;
    if (face.degree == 1)
      all = {{at[0], at[1], at[3], at[2]}};
    else // triangles around the centre, since edges may be curved inwards
      for (const auto &[a, b] :
           {std::make_pair(0, 1), std::make_pair(1, 2), std::make_pair(2, 5),
            std::make_pair(5, 8), std::make_pair(8, 7), std::make_pair(7, 6),
            std::make_pair(6, 3), std::make_pair(3, 0)})
        all.push_back({at[4], at[a], at[b]});
    for (Polygon &polygon : all)
      if (area(polygon) < 0.)
        std::reverse(polygon.begin(), polygon.end());
    return all;
  }

  FaceOverlap::Point2 FaceOverlap::in_unit_square(const Projected &face, const Point2 &p)
  {
    Point2 at{{0.5, 0.5}};
    for (unsigned int step = 0; step < 20; ++step)
      {
        const FaceShape shape(face.degree, at);
        double r[2] = {p[0], p[1]}, J[2][2] = {{0., 0.}, {0., 0.}};
        for (unsigned int i = 0; i < face.n_nodes(); ++i)
          for (unsigned int c = 0; c < 2; ++c)
            {
              r[c] -= shape.value[i] * face.nodes[i][c];
              for (unsigned int d = 0; d < 2; ++d)
                J[c][d] += shape.gradient[i][d] * face.nodes[i][c];
            }
        const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
        const double dx  = (J[1][1] * r[0] - J[0][1] * r[1]) / det;
        const double dy  = (J[0][0] * r[1] - J[1][0] * r[0]) / det;
        at[0] += dx;
        at[1] += dy;
        if (std::abs(dx) + std::abs(dy) < 1e-14)
          break;
      }
    return at;
  }

  std::vector<OverlapPoint> FaceOverlap::with(const SurfaceFace &second) const
  {
    std::vector<OverlapPoint> points;
    if (-(second.normal() * normal_) < facing_cosine)
      return points;
    const Projected other = project(second);
    if (are_apart(on_plane_, other))
      return points;
    const auto &quadrature = rule(first_.degree);
    const auto add_point   = [&](const Point2 &p, const double weight) {
      OverlapPoint point{weight, weight / area_, in_unit_square(on_plane_, p),
                         in_unit_square(other, p), 0.};
      const FaceShape own(first_.degree, point.first),
        of_other(second.degree, point.second);
      Tensor<1, 3> edge1, edge2; // of the face as it is, not on its plane
      for (unsigned int i = 0; i < first_.n_nodes(); ++i)
        {
          point.gap +=
            of_other.value[i] * other.heights[i] - own.value[i] * on_plane_.heights[i];
          edge1 += own.gradient[i][0] * Tensor<1, 3>(first_.node(i));
          edge2 += own.gradient[i][1] * Tensor<1, 3>(first_.node(i));
        }
      const Tensor<1, 3> across = cross_product_3d(edge1, edge2);
      point.weight *= across.norm() / std::abs(across * normal_);
      points.push_back(point);
    };
    const auto add_triangle = [&](const Point2 &a, const Point2 &b, const Point2 &c) {
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const Point<2> &at = quadrature.point(q);
          Point2 p;
          for (unsigned int d = 0; d < 2; ++d)
            p[d] = a[d] + at[0] * (b[d] - a[d]) + at[1] * (c[d] - a[d]);
          add_point(p, quadrature.weight(q) * cross(a, b, c));
        }
    };
    for (const Polygon &window : polygons(other))
      for (const Polygon &own : polygons(on_plane_))
        {
          const Polygon common = clip(own, window);
          if (common.size() < 3 || area(common) < no_area * area_)
            continue;
          for (const Point2 &corner : common)
            add_point(corner, 0.);
          for (std::size_t i = 2; i < common.size(); ++i)
            if (cross(common[0], common[i - 1], common[i]) > 0.)
              add_triangle(common[0], common[i - 1], common[i]);
        }
    return points;
  }
} // namespace stiction
