#pragma once

#include <Eigen/Core>

#include <functional>

namespace stiction::qp
{
  /// The product with the matrix of a linear system, together with a second
  /// vector that depends linearly on v and is expensive too: @p image. The
  /// methods below hand back the image of the solution without a product.
  using ProductWithImage = std::function<void(
    const Eigen::VectorXd &v, Eigen::VectorXd &Av, Eigen::VectorXd &image)>;

  /// What a Krylov method returns.
  struct KrylovSolution
  {
    Eigen::VectorXd y;
    Eigen::VectorXd image; ///< of y; of length 0 if no product was made
    unsigned int iterations = 0;
  };

  /// v ↦ P⁻¹v, with P near the matrix.
  using Preconditioner = std::function<Eigen::VectorXd(const Eigen::VectorXd &v)>;

  /// A y = b for symmetric positive definite A, from zero, by preconditioned
  /// conjugate gradients, until the residual in the norm of P⁻¹ is
  /// @p reduction times the first one. One product an iteration.
  KrylovSolution conjugate_gradients(const ProductWithImage &A, const Eigen::VectorXd &b,
                                     const Preconditioner &preconditioner,
                                     double reduction, unsigned int max_iterations);

  /// The same for any regular A, by GMRES without restart, preconditioned from
  /// the right: the residual is measured as it is.
  KrylovSolution gmres(const ProductWithImage &A, const Eigen::VectorXd &b,
                       const Preconditioner &preconditioner, double reduction,
                       unsigned int max_iterations);
} // namespace stiction::qp
