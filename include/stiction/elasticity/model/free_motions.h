#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  class Body;

  /// A small rigid motion, u(x) = translation + rotation × (x − centre).
  struct RigidMotion
  {
    dealii::Tensor<1, 3> translation; ///< of the centre, m
    dealii::Tensor<1, 3> rotation;    ///< rad
    dealii::Point<3> centre;

    dealii::Tensor<1, 3> at(const dealii::Point<3> &x) const
    {
      return translation + cross_product_3d(rotation, x - centre);
    }
  };

  /// The rigid motions Z of the bodies that their supports leave free, which nothing but
  /// contact can hold: the kernel of the stiffness matrix with prescribed
  /// displacements. A basis of n, at most six a body, each of which moves one body alone
  /// and that by not more than about one a unit.
  class FreeMotions
  {
  public:
    /// Collective.
    ///
    /// @param constraints the prescribed displacements, hanging nodes besides.
    /// @throws InputError if a place is no number.
    FreeMotions(const Body &body, const dealii::AffineConstraints<double> &constraints);

    /// n.
    Eigen::Index n() const { return n_; }

    /// Those of one body: the first, and how many.
    std::pair<Eigen::Index, Eigen::Index> of(unsigned int piece) const
    {
      return {pieces_[piece].begin, pieces_[piece].basis.cols()};
    }

    /// Σ α_j Z_j, by body. @param amounts α, length n, m.
    std::vector<RigidMotion> motions(const Eigen::VectorXd &amounts) const;

    /// The displacements of a point of a body under the motions of the basis, 3 × n.
    Eigen::MatrixXd at(const dealii::Point<3> &x, unsigned int piece) const;

    /// Whether a body may move in a direction, unit, and not turn.
    bool can_move(unsigned int piece, const dealii::Tensor<1, 3> &direction) const;

    /// "move along x and y and turn about z", of several bodies each with its name.
    std::string in_words() const { return in_words(Eigen::MatrixXd::Identity(n(), n())); }

    /// Those of a subspace. @param amounts a basis of it, n × any.
    std::string in_words(const Eigen::MatrixXd &amounts) const;

  private:
    struct OfPiece
    {
      std::string name;
      dealii::Point<3> centre;
      double radius;         ///< m
      Eigen::MatrixXd basis; ///< by columns translations and rotations × radius
      Eigen::Index begin;    ///< of its motions among all
    };

    static RigidMotion motion(const OfPiece &piece, const Eigen::VectorXd &amounts);

    std::vector<OfPiece> pieces_;
    Eigen::Index n_ = 0;
  };
} // namespace stiction
