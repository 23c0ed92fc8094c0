#include <stiction/elasticity/stiffness/cell_dilatation.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Cholesky>

#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    Eigen::Vector3d to_eigen(const Point<3> &x) { return {x[0], x[1], x[2]}; }

    Eigen::Matrix3Xd places_of(const FEValues<3> &values)
    {
      Eigen::Matrix3Xd places(3, values.n_quadrature_points);
      for (const unsigned int q : values.quadrature_point_indices())
        places.col(q) = to_eigen(values.quadrature_point(q));
      return places;
    }
  } // namespace

  DilatationSpace::DilatationSpace(const unsigned int degree,
                                   const Eigen::Matrix3Xd &points,
                                   const Eigen::VectorXd &weights)
    : mean_(weights.transpose() / weights.sum())
    , gradient_(Eigen::Matrix3Xd::Zero(3, weights.size()))
  {
    if (degree == 1)
      return;
    centre_                         = points * mean_.transpose();
    const Eigen::Matrix3Xd from     = points.colwise() - centre_;
    const Eigen::Matrix3Xd weighted = from * weights.asDiagonal();
    gradient_ = Eigen::Matrix3d(weighted * from.transpose()).ldlt().solve(weighted);
  }

  Eigen::RowVectorXd DilatationSpace::at(const Eigen::Vector3d &x) const
  {
    return mean_ + (x - centre_).transpose() * gradient_;
  }

  CellDilatation::CellDilatation(const FEValues<3> &values, const LA::Vector &u)
    : space_(values.get_fe().degree, places_of(values),
             Eigen::Map<const Eigen::VectorXd>(
               values.get_JxW_values().data(),
               static_cast<Eigen::Index>(values.get_JxW_values().size())))
  {
    std::vector<double> divergence(values.n_quadrature_points);
    values[FEValuesExtractors::Vector(0)].get_function_divergences(u, divergence);
    divergence_ = Eigen::Map<const Eigen::VectorXd>(
      divergence.data(), static_cast<Eigen::Index>(divergence.size()));
  }

  double CellDilatation::at(const Point<3> &x) const
  {
    return space_.at(to_eigen(x)) * divergence_;
  }

  Tensor<1, 3> CellDilatation::gradient() const
  {
    const Eigen::Vector3d gradient = space_.gradient() * divergence_;
    return Tensor<1, 3>({gradient(0), gradient(1), gradient(2)});
  }
} // namespace stiction
