#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/base/text/in_words.h>
#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/free_motions.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

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
      return '(' + format_vector("%.3g", u, 1.) + ')';
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
      return listed(names);
    }

    // Of a space of motions, by columns translations and rotations × radius.
    std::string words_of(const Eigen::MatrixXd &motions)
    {
      if (motions.size() == 0 || motions.isZero(rounding))
        return "";
      const Eigen::MatrixXd space    = Subspaces(motions).range;
      const Subspaces rotations      = Subspaces(space.bottomRows(3));
      const Eigen::MatrixXd no_turns = space.topRows(3) * rotations.kernel;
      std::string text;
      if (no_turns.cols() > 0)
        text = "move along " + axes(Subspaces(no_turns).range);
      if (rotations.range.cols() > 0)
        text +=
          (text.empty() ? "turn about " : " and turn about ") + axes(rotations.range);
      return text;
    }
  } // namespace

  FreeMotions::FreeMotions(const Body &body, const AffineConstraints<double> &constraints)
  {
    for (const Piece &piece : body.pieces())
      pieces_.push_back({piece.name, piece.box.center(), piece.radius(), {}, 0});

    // A motion is free if it vanishes at every prescribed unknown: the null space of the
    // Gram matrix of the modes restricted to them.
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    std::vector<Matrix6> grams(pieces_.size(), Matrix6::Zero());
    for (const Body::Node &node : body.locally_owned_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        if (constraints.is_constrained(node.dofs[c]) && !body.is_hanging(node.dofs[c]))
          {
            const OfPiece &piece = pieces_[node.piece];
            const Tensor<1, 3> x = (node.position - piece.centre) / piece.radius;
            // component c of e_a and of e_a × x
            Eigen::Matrix<double, 6, 1> modes = Eigen::Matrix<double, 6, 1>::Zero();
            modes(c)                          = 1.;
            modes(3 + (c + 1) % 3)            = x[(c + 2) % 3];
            modes(3 + (c + 2) % 3)            = -x[(c + 1) % 3];
            grams[node.piece] += modes * modes.transpose();
          }
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      {
        sum_over_ranks(grams[p], body.communicator());
        if (!grams[p].allFinite())
          throw InputError("places in " + pieces_[p].name +
                           " are no numbers, which a fault in memory leads to.");
        const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(grams[p]);
        const double scale = eigen.eigenvalues()(5);
        Eigen::Index n     = 0;
        while (n < 6 && eigen.eigenvalues()(n) <= rounding * scale)
          ++n;
        pieces_[p].basis = scale > 0. ? Eigen::MatrixXd(eigen.eigenvectors().leftCols(n))
                                      : Eigen::MatrixXd(Eigen::MatrixXd::Identity(6, 6));
        pieces_[p].begin = n_;
        n_ += pieces_[p].basis.cols();
      }
  }

  RigidMotion FreeMotions::motion(const OfPiece &piece, const Eigen::VectorXd &amounts)
  {
    const Eigen::VectorXd v =
      piece.basis * amounts.segment(piece.begin, piece.basis.cols());
    RigidMotion motion;
    for (unsigned int c = 0; c < 3; ++c)
      {
        motion.translation[c] = v(c);
        motion.rotation[c]    = v(3 + c) / piece.radius;
      }
    motion.centre = piece.centre;
    return motion;
  }

  std::vector<RigidMotion> FreeMotions::motions(const Eigen::VectorXd &amounts) const
  {
    std::vector<RigidMotion> all;
    for (const OfPiece &piece : pieces_)
      all.push_back(motion(piece, amounts));
    return all;
  }

  Eigen::MatrixXd FreeMotions::at(const Point<3> &x, const unsigned int piece) const
  {
    const OfPiece &of             = pieces_[piece];
    Eigen::MatrixXd displacements = Eigen::MatrixXd::Zero(3, n());
    for (Eigen::Index j = of.begin; j < of.begin + of.basis.cols(); ++j)
      {
        const Tensor<1, 3> u = motion(of, Eigen::VectorXd::Unit(n(), j)).at(x);
        for (unsigned int c = 0; c < 3; ++c)
          displacements(c, j) = u[c];
      }
    return displacements;
  }

  bool FreeMotions::can_move(const unsigned int piece,
                             const Tensor<1, 3> &direction) const
  {
    const Eigen::Vector3d along(direction[0], direction[1], direction[2]);
    return (pieces_[piece].basis.topRows(3).transpose() * along).squaredNorm() >
           1. - rounding;
  }

  std::string FreeMotions::in_words(const Eigen::MatrixXd &amounts) const
  {
    std::string text;
    for (const OfPiece &piece : pieces_)
      {
        const std::string words =
          words_of(piece.basis * amounts.middleRows(piece.begin, piece.basis.cols()));
        if (!words.empty())
          text += (text.empty() ? "" : "; ") + words +
                  (pieces_.size() > 1 ? " (" + piece.name + ")" : "");
      }
    return text;
  }
} // namespace stiction
