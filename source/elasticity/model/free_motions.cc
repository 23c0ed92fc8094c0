#include <stiction/base/log.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/free_motions.h>
#include <stiction/elasticity/model/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <array>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of squares of motions of size one: less is rounding.
    constexpr double rounding = 1e-10;

    // An orthonormal basis of the range or of the kernel of a small matrix.
    struct Subspaces
    {
      explicit Subspaces(const Eigen::MatrixXd &A)
      {
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU |
                                                         Eigen::ComputeFullV);
        Eigen::Index rank = 0;
        while (rank < svd.singularValues().size() &&
               svd.singularValues()(rank) > std::sqrt(rounding))
          ++rank;
        range  = svd.matrixU().leftCols(rank);
        kernel = svd.matrixV().rightCols(A.cols() - rank);
      }

      Eigen::MatrixXd range, kernel;
    };

    std::string vector(const Eigen::Vector3d &v)
    {
      Eigen::Index largest;
      v.cwiseAbs().maxCoeff(&largest);
      const Eigen::Vector3d u = v(largest) < 0. ? Eigen::Vector3d(-v) : v;
      return '(' + format_vector("%.3g", {{u(0), u(1), u(2)}}, 1.) + ')';
    }

    // "x and z" for a space of directions, given by an orthonormal basis.
    std::string axes(const Eigen::MatrixXd &directions)
    {
      const Eigen::Matrix3d projection = directions * directions.transpose();
      std::vector<std::string> names;
      for (Eigen::Index c = 0; c < 3; ++c)
        if (projection(c, c) > 1. - rounding)
          names.emplace_back(1, "xyz"[c]);
      if (static_cast<Eigen::Index>(names.size()) < directions.cols())
        return directions.cols() == 1
                 ? vector(directions.col(0))
                 : "all directions across " +
                     vector(Subspaces(directions.transpose()).kernel.col(0));
      std::string text = names.front();
      for (std::size_t k = 1; k < names.size(); ++k)
        text += (k + 1 < names.size() ? ", " : " and ") + names[k];
      return text;
    }
  } // namespace

  FreeMotions::FreeMotions(const Body &body, const AffineConstraints<double> &constraints)
    : centre_(body.bounding_box().center())
  {
    const auto corners = body.bounding_box().get_boundary_points();
    radius_            = corners.first.distance(corners.second) / 2.;
    const auto modes   = rigid_body_modes(body);

    // A motion is free if it vanishes at every prescribed unknown: the null space of the
    // Gram matrix of the modes restricted to them.
    std::array<double, 36> gram{};
    std::size_t k = 0;
    for (const auto dof : body.locally_owned_dofs())
      {
        if (constraints.is_constrained(dof) && !body.is_hanging(dof))
          for (unsigned int a = 0; a < 6; ++a)
            for (unsigned int b = 0; b < 6; ++b)
              gram[6 * a + b] += modes[a][k] * modes[b][k];
        ++k;
      }
    Utilities::MPI::sum(ArrayView<const double>(gram.data(), gram.size()),
                        body.communicator(), ArrayView<double>(gram.data(), gram.size()));
    const Eigen::Map<const Eigen::Matrix<double, 6, 6>> matrix(gram.data());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(matrix);
    const double scale = eigen.eigenvalues()(5);
    Eigen::Index n     = 0;
    while (n < 6 && eigen.eigenvalues()(n) <= rounding * scale)
      ++n;
    basis_ = scale > 0. ? Eigen::MatrixXd(eigen.eigenvectors().leftCols(n))
                        : Eigen::MatrixXd(Eigen::MatrixXd::Identity(6, 6));
  }

  RigidMotion FreeMotions::motion(const Eigen::VectorXd &amounts) const
  {
    const Eigen::VectorXd v = basis_ * amounts;
    RigidMotion motion;
    for (unsigned int c = 0; c < 3; ++c)
      {
        motion.translation[c] = v(c);
        motion.rotation[c]    = v(3 + c) / radius_;
      }
    motion.centre = centre_;
    return motion;
  }

  Eigen::MatrixXd FreeMotions::at(const Point<3> &x) const
  {
    Eigen::MatrixXd displacements(3, n());
    for (Eigen::Index j = 0; j < n(); ++j)
      {
        const Tensor<1, 3> u = motion(Eigen::VectorXd::Unit(n(), j)).at(x);
        for (unsigned int c = 0; c < 3; ++c)
          displacements(c, j) = u[c];
      }
    return displacements;
  }

  std::string FreeMotions::in_words() const
  {
    return in_words(Eigen::MatrixXd::Identity(n(), n()));
  }

  std::string FreeMotions::in_words(const Eigen::MatrixXd &amounts) const
  {
    if (amounts.cols() == 0)
      return "";
    const Eigen::MatrixXd space    = Subspaces(basis_ * amounts).range;
    const Subspaces rotations      = Subspaces(space.bottomRows(3));
    const Eigen::MatrixXd no_turns = space.topRows(3) * rotations.kernel;
    std::string text;
    if (no_turns.cols() > 0)
      text = "move along " + axes(Subspaces(no_turns).range);
    if (rotations.range.cols() > 0)
      text += (text.empty() ? "turn about " : " and turn about ") + axes(rotations.range);
    return text;
  }
} // namespace stiction
