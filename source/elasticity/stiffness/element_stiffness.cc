#include <stiction/elasticity/stiffness/element_stiffness.h>

#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace stiction
{
  using dealii::Tensor;

  namespace
  {
    using Gradients = std::array<Tensor<1, 3>, 8>;

    // The gradients of the trilinear functions on the unit cube at Gauss point
    // q.
    Gradients reference_gradients(const unsigned int q)
    {
      const double half_distance = 0.5 / std::sqrt(3.);
      Gradients gradients;
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int d = 0; d < 3; ++d)
          {
            gradients[v][d] = 1.;
            for (unsigned int e = 0; e < 3; ++e)
              {
                const bool is_far = v >> e & 1;
                const double x    = 0.5 + ((q >> e & 1) ? half_distance : -half_distance);
                gradients[v][d] *= e == d ? (is_far ? 1. : -1.) : (is_far ? x : 1. - x);
              }
          }
      return gradients;
    }
  } // namespace

  const dealii::FullMatrix<double> &ElementStiffness::operator()(
    const HexahedralCell &cell)
  {
    if (!is_translation(cell))
      integrate(cell);
    last_     = cell;
    has_last_ = true;
    return matrix_;
  }

  bool ElementStiffness::is_translation(const HexahedralCell &cell) const
  {
    if (!has_last_ || cell.lame_lambda != last_.lame_lambda ||
        cell.shear_modulus != last_.shear_modulus)
      return false;
    double size = 0., change = 0.;
    for (unsigned int v = 1; v < 8; ++v)
      for (unsigned int d = 0; d < 3; ++d)
        {
          const double edge      = cell.vertices[v][d] - cell.vertices[0][d];
          const double last_edge = last_.vertices[v][d] - last_.vertices[0][d];
          size                   = std::max(size, std::abs(edge));
          change                 = std::max(change, std::abs(edge - last_edge));
        }
    return change <= 1e-12 * size;
  }

  void ElementStiffness::integrate(const HexahedralCell &cell)
  {
    static const std::array<Gradients, 8> reference = []() {
      std::array<Gradients, 8> all;
      for (unsigned int q = 0; q < 8; ++q)
        all[q] = reference_gradients(q);
      return all;
    }();

    Eigen::Matrix<double, 24, 24> products = Eigen::Matrix<double, 24, 24>::Zero();
    for (const Gradients &gradients : reference)
      {
        Tensor<2, 3> jacobian;
        for (unsigned int v = 0; v < 8; ++v)
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int d = 0; d < 3; ++d)
              jacobian[a][d] += cell.vertices[v][a] * gradients[v][d];
        const Tensor<2, 3> inverse = invert(jacobian);
        const double weight        = determinant(jacobian) / 8.;
        Eigen::Matrix<double, 24, 1> g;
        for (unsigned int v = 0; v < 8; ++v)
          {
            const Tensor<1, 3> gradient = gradients[v] * inverse;
            for (unsigned int a = 0; a < 3; ++a)
              g(3 * v + a) = gradient[a];
          }
        products += (weight * g) * g.transpose();
      }

    // a(φ_i e_a, φ_j e_b) = ∫ λ ∂aφ_i ∂bφ_j + G (∂bφ_i ∂aφ_j + δ_ab ∇φ_i·∇φ_j)
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int j = 0; j < 8; ++j)
        {
          const Eigen::Matrix3d product = products.block<3, 3>(3 * i, 3 * j);
          const Eigen::Matrix3d block =
            cell.lame_lambda * product +
            cell.shear_modulus *
              (product.transpose() + product.trace() * Eigen::Matrix3d::Identity());
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              matrix_(3 * i + a, 3 * j + b) = block(a, b);
        }
  }
} // namespace stiction
