#include <stiction/contact/pairs/climbed_facets.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace stiction
{
  namespace
  {
    // The sine of 3 degrees, root mean square over the nodes: normals of coarse
    // tetrahedra are 2 degrees wrong, and shallower wedges are rarely meant.
    constexpr double smooth_within = 0.05;

    // Of the size of a motion: nodes in a line do not turn about it.
    constexpr double no_motion = 1e-12;
  } // namespace

  double climbed_facets(const Eigen::MatrixX3d &positions,
                        const Eigen::MatrixX3d &normals, const Eigen::MatrixX3d &slip,
                        const Eigen::VectorXd &areas, const Eigen::VectorXd &forces)
  {
    using Matrix = Eigen::Matrix<double, 6, 6>;
    using Vector = Eigen::Matrix<double, 6, 1>;

    // translations and rotations about the centre, which are of size one at the radius
    const Eigen::RowVector3d centre = forces.transpose() * positions / forces.sum();
    const double radius =
      std::sqrt((positions.rowwise() - centre).rowwise().squaredNorm().maxCoeff());
    if (radius == 0.)
      return 0.;
    Eigen::MatrixXd rises(forces.size(), 6);
    Matrix rise = Matrix::Zero(), size = Matrix::Zero();
    Vector along = Vector::Zero();
    for (Eigen::Index i = 0; i < forces.size(); ++i)
      {
        const Eigen::Vector3d x = (positions.row(i) - centre) / radius;
        Eigen::Matrix<double, 3, 6> M;
        M << Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitX().cross(x),
          Eigen::Vector3d::UnitY().cross(x), Eigen::Vector3d::UnitZ().cross(x);
        rises.row(i) = normals.row(i) * M;
        rise += forces(i) * rises.row(i).transpose() * rises.row(i);
        size += forces(i) * M.transpose() * M;
        along += forces(i) * M.transpose() * slip.row(i).transpose();
      }
    size.diagonal().array() += no_motion * size.trace();

    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> eigen(rise, size);
    Vector motion = Vector::Zero();
    for (int k = 0; k < 6; ++k)
      if (eigen.eigenvalues()(k) < smooth_within * smooth_within)
        {
          const Vector v = eigen.eigenvectors().col(k);
          motion += v * v.dot(along);
        }
    const Eigen::VectorXd r = rises * motion;
    return 0.5 * (forces.dot(r) - forces.sum() * areas.dot(r) / areas.sum());
  }
} // namespace stiction
