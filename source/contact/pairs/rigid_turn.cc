#include <stiction/contact/pairs/rigid_turn.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/numerics/rtree.h>

#include <Eigen/QR>

#include <algorithm>

namespace stiction
{
  namespace
  {
    using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    // Of the size of what is opposite: less is rounding.
    constexpr double no_arm = 1e-11;

    // Of the largest moment of inertia: nodes in a line do not say how they turn about
    // it, those of a face that is a million times as long as wide do.
    constexpr double no_inertia = 1e-13;

    // Some hundred nodes in a row.
    constexpr double widest = 4.;

    Eigen::Matrix3d cross(const Eigen::Vector3d &v)
    {
      Eigen::Matrix3d V;
      V << 0., -v(2), v(1), v(2), 0., -v(0), -v(1), v(0), 0.;
      return V;
    }

    using Points = Eigen::Map<const Eigen::MatrixX3d>; // by rows

    // How far what lies opposite is away, in each row at most widest times as far as the
    // overlaps reach along the surface, so that rows stay sparse.
    Eigen::VectorXd reach_of(const Matrix &overlaps, const Eigen::MatrixX3d &facing,
                             const Points &positions, const Points &opposite)
    {
      Eigen::VectorXd reach(facing.rows());
      for (Eigen::Index i = 0; i < facing.rows(); ++i)
        {
          double size = 0.;
          for (Matrix::InnerIterator w(overlaps, i); w; ++w)
            size = std::max(size, (opposite.row(w.col()) - facing.row(i)).norm());
          reach(i) = std::min((positions.row(i) - facing.row(i)).norm(), widest * size);
        }
      return reach;
    }

    // Around each node the overlaps of all of its surface that are nearer than what lies
    // opposite, the less the farther. The couple of a force across a wide gap on the few
    // nodes opposite alone would bend them: systems took 100 iterations across ten cells
    // and take 23.
    Matrix widened(const Matrix &overlaps, const Points &positions,
                   const Eigen::VectorXd &reach,
                   const std::vector<unsigned int> &surfaces)
    {
      const Eigen::Index m = overlaps.rows();
      std::vector<dealii::Point<3>> points;
      for (Eigen::Index i = 0; i < m; ++i)
        points.emplace_back(positions(i, 0), positions(i, 1), positions(i, 2));
      const auto tree = dealii::pack_rtree_of_indices(points);
      std::vector<Eigen::Triplet<double>> shares;
      for (Eigen::Index i = 0; i < m; ++i)
        {
          namespace query = boost::geometry::index;
          dealii::BoundingBox<3> box({points[i], points[i]});
          box.extend(reach(i));
          shares.emplace_back(i, i, 1.);
          for (const auto k : tree | query::adaptors::queried(query::intersects(box)))
            if (const double distance = points[i].distance(points[k]);
                distance > 0. && distance < reach(i) && surfaces[k] == surfaces[i])
              shares.emplace_back(i, k, 1. - distance / reach(i));
        }
      Matrix around(m, m);
      around.setFromTriplets(shares.begin(), shares.end());
      return around * overlaps;
    }
  } // namespace

  Matrix with_rigid_turns(const Matrix &weights, const Matrix &overlaps,
                          const Eigen::VectorXd &positions,
                          const Eigen::VectorXd &opposite,
                          const std::vector<unsigned int> &surfaces)
  {
    const Eigen::Index m = weights.rows(), n = weights.cols();
    const Points x(positions.data(), m, 3), y(opposite.data(), n, 3);
    const Eigen::MatrixX3d facing = weights * y, d = x - facing;
    const Matrix around =
      widened(overlaps, x, reach_of(overlaps, facing, x, y), surfaces);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        for (Matrix::InnerIterator a(weights, i); a; ++a)
          for (Eigen::Index c = 0; c < 3; ++c)
            entries.emplace_back(i + c * m, a.col() + c * n, a.value());
        const double sum = around.row(i).sum();
        if (sum == 0.)
          continue; // a rigid obstacle
        const Eigen::RowVector3d centre = around.row(i) * y / sum;
        Eigen::Matrix3d inertia         = Eigen::Matrix3d::Zero();
        for (Matrix::InnerIterator w(around, i); w; ++w)
          {
            const Eigen::Matrix3d R = cross(y.row(w.col()) - centre);
            inertia -= w.value() / sum * R * R;
          }
        if (d.row(i).squaredNorm() <= no_arm * no_arm * inertia.trace())
          continue;
        Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> inverse;
        inverse.setThreshold(no_inertia);
        inverse.compute(inertia);
        const Eigen::Matrix3d turn = -cross(d.row(i)) * inverse.pseudoInverse();
        for (Matrix::InnerIterator w(around, i); w; ++w)
          {
            const Eigen::Matrix3d C =
              w.value() / sum * turn * cross(y.row(w.col()) - centre);
            for (Eigen::Index r = 0; r < 3; ++r)
              for (Eigen::Index c = 0; c < 3; ++c)
                entries.emplace_back(i + r * m, w.col() + c * n, C(r, c));
          }
      }
    Matrix A(3 * m, 3 * n);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
  }
} // namespace stiction
