#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/point.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

namespace stiction
{
  /// The functions that stand for the volume strain in a cell with 'Volume strain = cell
  /// mean', of a degree less than the displacement: constants, of triquadratic elements
  /// linear functions. ∇·u is projected on them, Π f = argmin ∫ (Πf − f)², so that nearly
  /// incompressible material does not lock (mean dilatation: T. J. R. Hughes, 1980; the
  /// pair Q2/P1: D. Boffi, F. Brezzi, M. Fortin, 2013).
  class DilatationSpace
  {
  public:
    /// @param points Gauss points, m; of no use to degree 1.
    /// @param weights the volumes that they stand for, m³.
    DilatationSpace(unsigned int degree, const Eigen::Matrix3Xd &points,
                    const Eigen::VectorXd &weights);

    /// (Πf)(x) = Σ_q at(x)_q f_q.
    Eigen::RowVectorXd at(const Eigen::Vector3d &x) const;

    /// ∇Πf = gradient() f, 1/m.
    const Eigen::Matrix3Xd &gradient() const { return gradient_; }

  private:
    Eigen::RowVectorXd mean_;
    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
    Eigen::Matrix3Xd gradient_;
  };

  /// Π ∇·u of a displacement in one cell.
  class CellDilatation
  {
  public:
    /// In the cell where the values are, with gradients, places and volumes.
    CellDilatation(const dealii::FEValues<3> &values, const LA::Vector &u);

    double at(const dealii::Point<3> &x) const;

    dealii::Tensor<1, 3> gradient() const;

  private:
    DilatationSpace space_;
    Eigen::VectorXd divergence_;
  };
} // namespace stiction
