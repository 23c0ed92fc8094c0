#include <stiction/contact/pairs/rigid_turn.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <Eigen/QR>

#include <vector>

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

    Eigen::Matrix3d cross(const Eigen::Vector3d &v)
    {
      Eigen::Matrix3d V;
      V << 0., -v(2), v(1), v(2), 0., -v(0), -v(1), v(0), 0.;
      return V;
    }
  } // namespace

  Matrix with_rigid_turns(const Matrix &weights, const Matrix &overlaps,
                          const Eigen::VectorXd &positions,
                          const Eigen::VectorXd &opposite)
  {
    const Eigen::Index m = weights.rows(), n = weights.cols();
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        Eigen::Vector3d d = at_node(positions, i);
        for (Matrix::InnerIterator a(weights, i); a; ++a)
          {
            d -= a.value() * at_node(opposite, a.col());
            for (Eigen::Index c = 0; c < 3; ++c)
              entries.emplace_back(i + c * m, a.col() + c * n, a.value());
          }
        const double sum = overlaps.row(i).sum();
        if (sum == 0.)
          continue; // a rigid obstacle
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        for (Matrix::InnerIterator w(overlaps, i); w; ++w)
          centre += w.value() / sum * at_node(opposite, w.col());
        Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
        for (Matrix::InnerIterator w(overlaps, i); w; ++w)
          {
            const Eigen::Matrix3d R = cross(at_node(opposite, w.col()) - centre);
            inertia -= w.value() / sum * R * R;
          }
        if (d.squaredNorm() <= no_arm * no_arm * inertia.trace())
          continue;
        Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> inverse;
        inverse.setThreshold(no_inertia);
        inverse.compute(inertia);
        const Eigen::Matrix3d turn = -cross(d) * inverse.pseudoInverse();
        for (Matrix::InnerIterator w(overlaps, i); w; ++w)
          {
            const Eigen::Matrix3d C =
              w.value() / sum * turn * cross(at_node(opposite, w.col()) - centre);
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
