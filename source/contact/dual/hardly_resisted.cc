#include <stiction/contact/dual/hardly_resisted.h>
#include <stiction/contact/dual/rigid_balance.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/unbalanced_load.h>

#include <Eigen/Eigenvalues>

namespace stiction
{
  namespace
  {
    // Of the squares of how nodes move against what is opposite, what presses or rubs:
    // with less, normals within 2 degrees of being across, a motion is hardly resisted.
    constexpr double hardly = 1e-3;

    // A smaller coefficient of friction resists as little.
    constexpr double no_friction = 0.01;
  } // namespace

  Eigen::MatrixXd hardly_resisted_motions(const LinearElasticity &elasticity,
                                          const ContactSurface &surface)
  {
    const Eigen::Index n = elasticity.free_motions().n(), m = surface.n_nodes();
    if (n == 0 || m == 0 || surface.has_friction_of_state())
      return Eigen::MatrixXd::Zero(n, 0);
    const Eigen::MatrixXd G = rigid_balance(elasticity, surface).G.rightCols(n);
    const Eigen::MatrixXd resisted =
      qp::resisted_and_others(G, surface.slip_bound()).first;
    if (resisted.cols() == 0)
      return resisted;
    const Eigen::MatrixXd moved =
      surface.areas().replicate(3, 1).cwiseSqrt().asDiagonal() * (G * resisted);
    const qp::SlipBound &bound = surface.slip_bound();
    Eigen::MatrixXd felt = moved, all = moved.transpose() * moved;
    all.diagonal().array() += 1e-12 * all.trace();
    for (Eigen::Index i = 0; i < m; ++i)
      if (bound.constant()(i) == 0. &&
          !(bound.is_coulomb() && bound.coefficient()(i) > no_friction))
        felt.row(i + m) = felt.row(i + 2 * m) = Eigen::RowVectorXd::Zero(felt.cols());
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      felt.transpose() * felt, all);
    return resisted *
           eigen.eigenvectors().leftCols((eigen.eigenvalues().array() < hardly).count());
  }
} // namespace stiction
