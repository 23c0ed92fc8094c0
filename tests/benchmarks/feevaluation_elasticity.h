#pragma once

#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <cstdlib>
#include <utility>

/// A number of the command line, -1 if it is none.
inline int whole_number(const char *const text)
{
  char *end;
  const long number = std::strtol(text, &end, 10);
  return end != text && *end == '\0' && number < 1000000 ? number : -1;
}

/// The reference brick (0,4)×(0,3)×(0,1) of its material, in m and Pa.
namespace reference_brick
{
  constexpr double youngs_modulus = 2.119e11, poisson_ratio = 0.277;
  constexpr double lame_lambda =
    youngs_modulus * poisson_ratio / ((1. + poisson_ratio) * (1. - 2. * poisson_ratio));
  constexpr double shear_modulus = youngs_modulus / (2. * (1. + poisson_ratio));
} // namespace reference_brick

/// Elasticity as deal.II's tutorials would write it: what stiction's own
/// product is compared with.
namespace feevaluation
{
  template<typename Number>
  using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

  template<typename Number> using Displacement = dealii::FEEvaluation<3, 1, 2, 3, Number>;

  /// Gradients in, stress out, in the quadrature points of a batch of cells.
  template<typename Number>
  inline void integrate_stress(Displacement<Number> &displacement)
  {
    const dealii::VectorizedArray<Number> lambda(
      static_cast<Number>(reference_brick::lame_lambda)),
      two_mu(static_cast<Number>(2. * reference_brick::shear_modulus));
    displacement.evaluate(dealii::EvaluationFlags::gradients);
    for (unsigned int q = 0; q < displacement.n_q_points; ++q)
      {
        const auto strain   = displacement.get_symmetric_gradient(q);
        const auto pressure = lambda * trace(strain);
        auto stress         = two_mu * strain;
        for (unsigned int d = 0; d < 3; ++d)
          stress[d][d] += pressure;
        displacement.submit_symmetric_gradient(stress, q);
      }
    displacement.integrate(dealii::EvaluationFlags::gradients);
  }

  /// dst += K src on some cells, for MatrixFree::cell_loop().
  template<typename Number>
  inline void add_product(const dealii::MatrixFree<3, Number> &matrix_free,
                          Vector<Number> &dst, const Vector<Number> &src,
                          const std::pair<unsigned int, unsigned int> &cells)
  {
    Displacement<Number> displacement(matrix_free);
    for (unsigned int cell = cells.first; cell < cells.second; ++cell)
      {
        displacement.reinit(cell);
        displacement.read_dof_values(src);
        integrate_stress(displacement);
        displacement.distribute_local_to_global(dst);
      }
  }
} // namespace feevaluation
