#include <stiction/qp/methods/active_set_run.h>
#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/methods/squares.h>
#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/rotated_squares.h>
#include <stiction/qp/solvers/proportioning.h>

namespace stiction
{
  Squares::Squares(const DualOperator &Q, const unsigned int r)
    : block_(Q.diagonal_block(DualBlock::all))
    , r_(r)
  {
  }

  DualMethodResult Squares::solve(DualIterate &iterate, const Task &task)
  {
    const qp::RotatedSquares squares(r_, task.slip_bound.at(iterate.lambda));
    // CᵀQC; for more than one square it is singular
    const qp::SymmetricOperator A(
      squares.n_unknowns(), [&](Eigen::VectorXd &dst, const Eigen::VectorXd &unknowns) {
        Eigen::VectorXd Q_forces;
        block_.vmult(Q_forces, squares.to_forces(unknowns));
        dst = squares.pull_back(Q_forces);
      });
    const qp::HalfLinesTimesBoxes boxes(squares.half_widths(), 2 * r_);
    qp::Proportioning solver(A, boxes, qp::spectral_norm(A));

    Eigen::VectorXd x = squares.lift(iterate.lambda);
    qp::move_to(squares.to_forces(x), iterate.lambda, iterate.gradient, block_);
    Eigen::VectorXd gradient    = squares.pull_back(iterate.gradient);
    const Eigen::VectorXd start = iterate.lambda;
    DualMethodResult result     = run_active_set_method(
          solver, x, gradient, task.scaling, task.rule, Mpgp::products_in_an_iteration,
          statistics_,
          [&](const Eigen::VectorXd &now) { iterate.lambda = squares.to_forces(now); },
          task.observer);
    iterate.lambda = start; // the one that the gradient belongs to
    qp::move_to(squares.to_forces(x), iterate.lambda, iterate.gradient, block_);
    return result;
  }

  std::string Squares::limitation() const
  {
    return "the method squares solved its own problem, with polygons of " +
           std::to_string(4 * r_) +
           " sides in place of the discs, choose another 'Contact "
           "solver/Method' for the exact one";
  }
} // namespace stiction
