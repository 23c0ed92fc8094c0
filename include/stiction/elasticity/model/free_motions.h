#ifndef stiction_elasticity_model_free_motions_h
#define stiction_elasticity_model_free_motions_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Core>

#include <string>

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

  /// The rigid motions Z of the body that its supports leave free, which nothing but
  /// contact can hold: the kernel of the stiffness matrix with prescribed
  /// displacements. A basis of n ≤ 6, none of whose motions moves the body by more than
  /// about one a unit.
  class FreeMotions
  {
  public:
    /// Collective.
    ///
    /// @param constraints the prescribed displacements, hanging nodes besides.
    FreeMotions(const Body &body, const dealii::AffineConstraints<double> &constraints);

    /// n.
    Eigen::Index n() const { return basis_.cols(); }

    /// Σ α_j Z_j. @param amounts α, length n, m.
    RigidMotion motion(const Eigen::VectorXd &amounts) const;

    /// The displacements of a point under the motions of the basis, 3 × n.
    Eigen::MatrixXd at(const dealii::Point<3> &x) const;

    /// "move along x and y and turn about z".
    std::string in_words() const;

    /// Those of a subspace. @param amounts a basis of it, n × any.
    std::string in_words(const Eigen::MatrixXd &amounts) const;

  private:
    dealii::Point<3> centre_;
    double radius_;
    /// By columns translations and rotations, these times the radius.
    Eigen::MatrixXd basis_;
  };
} // namespace stiction

#endif
