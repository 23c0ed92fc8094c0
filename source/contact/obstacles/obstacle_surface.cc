#include <stiction/contact/obstacles/obstacle_surface.h>
#include <stiction/contact/obstacles/stl_file.h>
#include <stiction/qp/sets/nonnegative_amounts.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace stiction
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    // How many triangles are looked at first.
    constexpr unsigned int few = 4;

    // Of the size of the surface: what is closer is on it but for rounding, or but for
    // the single precision of binary files.
    constexpr double rounding = 1e-10, same_place = 1e-6;

    // Directions are chosen one by one, three of which are enough.
    constexpr Eigen::Index most_steps = 30;

    // A cosine: what lies farther aside is not on the way.
    constexpr double on_the_way = 0.1;

    // The point of a triangle nearest to another point, and the feature it lies
    // on: 0 the triangle, 1...3 the edge that begins at that vertex, 4...6 the
    // vertex.
    struct Nearest
    {
      Point<3> point;
      unsigned int feature;
    };

    Nearest nearest_on_triangle(const std::array<Point<3>, 3> &v, const Point<3> &p)
    {
      const Tensor<1, 3> n = cross_product_3d(v[1] - v[0], v[2] - v[0]);
      const Tensor<1, 3> h = p - v[0];
      bool is_above        = true;
      for (unsigned int k = 0; k < 3; ++k)
        is_above =
          is_above && cross_product_3d(n, v[(k + 1) % 3] - v[k]) * (p - v[k]) >= 0.;
      if (is_above)
        return {p - (h * n) / n.norm_square() * n, 0};

      Nearest nearest{v[0], 4};
      double smallest = std::numeric_limits<double>::infinity();
      for (unsigned int k = 0; k < 3; ++k)
        {
          const Tensor<1, 3> edge = v[(k + 1) % 3] - v[k];
          const double s          = (p - v[k]) * edge / edge.norm_square();
          const Nearest here      = s <= 0.   ? Nearest{v[k], 4 + k}
                                    : s >= 1. ? Nearest{v[(k + 1) % 3], 4 + (k + 1) % 3}
                                              : Nearest{v[k] + s * edge, 1 + k};
          const double distance   = here.point.distance(p);
          if (distance < smallest)
            {
              smallest = distance;
              nearest  = here;
            }
        }
      return nearest;
    }

    // Of the directions between some others, Σ_k c_k n_k with c_k ≥ 0, that closest to a
    // given one. Zero if it is across all of them or farther.
    Eigen::Vector3d closest_between(const Eigen::Matrix3Xd &n,
                                    const Eigen::Vector3d &given)
    {
      Eigen::MatrixXd used(3, 0);
      Eigen::VectorXd amounts(0);
      Eigen::Vector3d left = given;
      Eigen::Index next    = 0;
      while (used.cols() < most_steps && (amounts.array() > 0.).count() < 3 &&
             (n.transpose() * left).maxCoeff(&next) > rounding)
        {
          used.conservativeResize(Eigen::NoChange, used.cols() + 1);
          used.rightCols<1>() = n.col(next);
          amounts.conservativeResize(used.cols());
          amounts.tail<1>().setZero();
          qp::find_amounts(used, given, amounts);
          left = given - used * amounts;
        }
      return given - left;
    }
  } // namespace

  struct ObstacleSurface::Data
  {
    using Box = std::pair<dealii::BoundingBox<3>, unsigned int>;

    TriangulatedSurface surface;
    std::vector<Tensor<1, 3>> normals;        // of triangles, unit
    std::vector<Tensor<1, 3>> vertex_normals; // angle-weighted
    std::map<std::pair<unsigned int, unsigned int>, Tensor<1, 3>> edge_normals;
    dealii::RTree<Box> tree;
    double size = 0.;

    std::array<Point<3>, 3> corners(const unsigned int triangle) const
    {
      const auto &t = surface.triangles[triangle];
      return {{surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]}};
    }

    std::pair<unsigned int, unsigned int> edge(const unsigned int triangle,
                                               const unsigned int k) const
    {
      const auto &t = surface.triangles[triangle];
      return std::minmax({t[k], t[(k + 1) % 3]});
    }

    const Tensor<1, 3> &normal(const unsigned int triangle,
                               const unsigned int feature) const
    {
      return feature == 0  ? normals[triangle]
             : feature < 4 ? edge_normals.at(edge(triangle, feature - 1))
                           : vertex_normals[surface.triangles[triangle][feature - 4]];
    }

    // Calls back with all triangles whose boxes are within a distance.
    template<typename Callback>
    void within(const double distance, const Point<3> &p, const Callback &callback) const
    {
      dealii::BoundingBox<3> around(std::make_pair(p, p));
      around.extend(distance);
      for (auto box = tree.qbegin(boost::geometry::index::intersects(around));
           box != tree.qend(); ++box)
        if (boost::geometry::distance(p, box->first) <= distance)
          callback(*box);
    }
  };

  ObstacleSurface::ObstacleSurface(TriangulatedSurface surface)
    : data_(std::make_unique<Data>())
  {
    data_->surface = std::move(surface);
    data_->vertex_normals.resize(data_->surface.vertices.size());
    std::vector<Data::Box> boxes;
    for (unsigned int i = 0; i < data_->surface.triangles.size(); ++i)
      {
        const auto v   = data_->corners(i);
        Tensor<1, 3> n = cross_product_3d(v[1] - v[0], v[2] - v[0]);
        n /= n.norm();
        data_->normals.push_back(n);
        for (unsigned int k = 0; k < 3; ++k)
          {
            const Tensor<1, 3> a = v[(k + 1) % 3] - v[k], b = v[(k + 2) % 3] - v[k];
            const double angle = std::atan2(cross_product_3d(a, b).norm(), a * b);
            data_->vertex_normals[data_->surface.triangles[i][k]] += angle * n;
            data_->edge_normals[data_->edge(i, k)] += n;
          }
        boxes.emplace_back(
          dealii::BoundingBox<3>(std::vector<Point<3>>(v.begin(), v.end())), i);
      }
    data_->tree = dealii::pack_rtree(boxes);
    const auto corners =
      dealii::BoundingBox<3>(data_->surface.vertices).get_boundary_points();
    data_->size = corners.first.distance(corners.second);
  }

  ObstacleSurface::~ObstacleSurface() = default;

  const TriangulatedSurface *ObstacleSurface::triangles() const
  {
    return &data_->surface;
  }

  Obstacle::Value ObstacleSurface::at(const Point<3> &p) const
  {
    double distance = std::numeric_limits<double>::infinity();
    Nearest nearest{};
    unsigned int triangle = 0;
    const auto look_at    = [&](const Data::Box &box) {
      if (boost::geometry::distance(p, box.first) > distance)
        return;
      const Nearest here         = nearest_on_triangle(data_->corners(box.second), p);
      const double here_distance = here.point.distance(p);
      if (here_distance < distance)
        {
          distance = here_distance;
          nearest  = here;
          triangle = box.second;
        }
    };
    // a few tell how far away others may be at most
    for (auto box = data_->tree.qbegin(boost::geometry::index::nearest(p, few));
         box != data_->tree.qend(); ++box)
      look_at(*box);
    data_->within(distance, p, look_at);

    const Tensor<1, 3> &normal = data_->normal(triangle, nearest.feature);
    const Tensor<1, 3> away    = p - nearest.point;
    const double sign          = away * normal < 0. ? -1. : 1.;
    Value value;
    value.psi = sign * distance;
    // on the surface the direction of the difference is rounding
    if (nearest.feature == 0 || distance <= rounding * data_->size)
      value.gradient = normal.norm() > 0. ? normal / normal.norm() : normal;
    else
      value.gradient = away / value.psi;
    return value;
  }

  Obstacle::Value ObstacleSurface::facing(const Point<3> &p,
                                          const Tensor<1, 3> &normal) const
  {
    Value value        = at(p);
    const double close = same_place * data_->size, distance = std::abs(value.psi);
    std::vector<Eigen::Vector3d> gradients;
    data_->within(distance + close, p, [&](const Data::Box &box) {
      const Point<3> nearest = nearest_on_triangle(data_->corners(box.second), p).point;
      if (nearest.distance(p) > distance + close)
        return;
      const Tensor<1, 3> gradient =
        distance <= close ? data_->normals[box.second]
                          : (p - nearest) / std::copysign(nearest.distance(p), value.psi);
      gradients.emplace_back(gradient[0], gradient[1], gradient[2]);
    });
    if (std::all_of(gradients.begin(), gradients.end(), [&](const Eigen::Vector3d &g) {
          return g.dot(gradients.front()) > 1. - rounding;
        }))
      return value;
    Eigen::Matrix3Xd all(3, gradients.size());
    for (std::size_t k = 0; k < gradients.size(); ++k)
      all.col(static_cast<Eigen::Index>(k)) = gradients[k];
    const Eigen::Vector3d along = closest_between(
      all, -Eigen::Vector3d(normal[0], normal[1], normal[2]).normalized());
    // the nearest side is as far away along it as it approaches slowly
    const double approach =
      along.norm() > 0. ? (all.transpose() * along.normalized()).maxCoeff() : 0.;
    if (approach > on_the_way)
      for (unsigned int c = 0; c < 3; ++c)
        value.gradient[c] = approach * along.normalized()(c);
    return value;
  }
} // namespace stiction
