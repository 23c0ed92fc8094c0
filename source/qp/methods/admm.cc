#include <stiction/qp/methods/admm.h>

#include <stdexcept>

namespace stiction
{
  namespace
  {
    const Eigen::MatrixXd &matrix_of(const DualOperator &Q)
    {
      if (Q.matrix() == nullptr)
        throw std::invalid_argument("this method needs Q as a matrix");
      return *Q.matrix();
    }
  } // namespace

  Admm::Admm(const DualOperator &Q)
    : block_(Q, DualBlock::all)
    , solver_(matrix_of(Q), block_, Q.nodal_compliance())
  {
  }

  DualMethodResult Admm::solve(DualIterate &iterate, const qp::SlipBound &slip_bound,
                               const qp::Scaling &scaling, const StoppingRule &rule,
                               const Observer &observer)
  {
    Eigen::VectorXd before = iterate.lambda;
    DualMethodResult result;
    const qp::SolverRun run =
      solver_.solve(iterate.lambda, iterate.gradient, slip_bound, scaling, rule.residual,
                    rule.max_iterations, [&](const double residual) {
                      result.change = relative_change(iterate.lambda, before);
                      before        = iterate.lambda;
                      observer({1, residual, result.change});
                    });
    statistics_ += run;
    result.iterations = run.admm_iterations;
    result.residual   = run.residual;
    result.converged  = run.converged;
    return result;
  }
} // namespace stiction
