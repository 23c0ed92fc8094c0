#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/operators/symmetric_operator.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

namespace stiction::qp
{
  namespace
  {
    // A fixed vector with components along every mode: mostly constant (the
    // stiffest modes of a contact dual operator are the smooth ones), with an
    // irregular part that no symmetry of the mesh makes orthogonal to a mode.
    Eigen::VectorXd start_vector(const Eigen::Index n)
    {
      Eigen::VectorXd v(n);
      for (Eigen::Index i = 0; i < n; ++i)
        v(i) = 1. + std::sin(1. + 12.9898 * static_cast<double>(i));
      return v.normalized();
    }
  } // namespace

  double spectral_norm(const SymmetricOperator &A, const double accuracy,
                       const unsigned int max_multiplications)
  {
    const Eigen::Index n = A.size();
    if (n == 0)
      return 0.;

    constexpr unsigned int min_steps = 12;
    std::vector<Eigen::VectorXd> basis{start_vector(n)};
    std::vector<double> diagonal, off_diagonal;
    double bound = 0.;

    for (unsigned int k = 0; k < max_multiplications; ++k)
      {
        Eigen::VectorXd w;
        A.vmult(w, basis.back());
        diagonal.push_back(w.dot(basis.back()));
        for (const auto &v : basis) // full orthogonalisation: k is small
          w -= w.dot(v) * v;
        const double beta = w.norm();

        const Eigen::Map<const Eigen::VectorXd> d(diagonal.data(), k + 1);
        const Eigen::Map<const Eigen::VectorXd> e(off_diagonal.data(), k);
        // Eigen's solver compares with absolute numbers: without this unit a
        // change of units would change the result.
        const double unit = diagonal[0] > 0. ? diagonal[0] : 1.;
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz;
        ritz.computeFromTridiagonal(d / unit, e / unit);
        const double theta    = unit * ritz.eigenvalues()(k);
        const double residual = beta * std::abs(ritz.eigenvectors()(k, k));

        bound = theta + residual;
        // a residual that is small early may be that of a smaller eigenvalue
        const bool exhausted = basis.size() == std::size_t(n) || beta <= 1e-10 * theta;
        if (exhausted || (k + 1 >= min_steps && residual <= accuracy * theta))
          break;
        off_diagonal.push_back(beta);
        basis.emplace_back(w / beta);
      }
    return bound;
  }
} // namespace stiction::qp
