#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sensitivity.h>
#include <stiction/qp/sets/contact_linearization.h>
#include <stiction/qp/solvers/krylov_methods.h>
#include <stiction/qp/solvers/nystrom_preconditioner.h>

namespace stiction::qp
{
  namespace
  {
    // Of the right-hand sides.
    constexpr double reduction = 1e-4;

    constexpr unsigned int max_krylov_iterations = 200;
  } // namespace

  Eigen::MatrixXd sensitivity(const SymmetricOperator &Q, const Eigen::MatrixXd &G,
                              const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                              const Eigen::VectorXd &nodal_compliance,
                              const SlipBound &slip_bound)
  {
    const ContactLinearization conditions(x, gradient, nodal_compliance.cwiseInverse(),
                                          slip_bound);
    NystromPreconditioner preconditioner;
    const auto product = [&](const Eigen::VectorXd &v, Eigen::VectorXd &Av,
                             Eigen::VectorXd &image) {
      const Eigen::VectorXd d = conditions.embed(v);
      Q.vmult(image, d);
      Av = conditions.test(image) + conditions.curvature().cwiseProduct(v);
      preconditioner.add(d, image); // for the columns to come
    };
    Eigen::MatrixXd columns(x.size(), G.cols());
    for (Eigen::Index j = 0; j < G.cols(); ++j)
      {
        preconditioner.set_up(conditions, nodal_compliance);
        const KrylovSolution solution = gmres(
          product, -conditions.test(G.col(j)),
          [&](const Eigen::VectorXd &v) { return preconditioner.apply(v); }, reduction,
          max_krylov_iterations);
        columns.col(j) = conditions.embed(solution.y);
      }
    return columns;
  }
} // namespace stiction::qp
