#include <stiction/qp/methods/active_set_run.h>
#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/methods/squares.h>
#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/operators/squares_operator.h>
#include <stiction/qp/sets/half_lines_times_boxes.h>
#include <stiction/qp/sets/rotated_squares.h>
#include <stiction/qp/solvers/proportioning.h>

namespace stiction
{
  Squares::Squares(const DualOperator &Q, const unsigned int r)
    : Q_(Q)
    , block_(Q, DualBlock::all)
    , r_(r)
  {
  }

  DualMethodResult Squares::solve(DualIterate &iterate, const qp::SlipBound &slip_bound,
                                  const qp::Scaling &scaling, const StoppingRule &rule,
                                  const Observer &observer)
  {
    const qp::RotatedSquares squares(r_, slip_bound.at(iterate.lambda));
    const qp::SquaresOperator A(block_, squares);
    const qp::HalfLinesTimesBoxes boxes(squares.half_widths(), 2 * r_);
    qp::Proportioning solver(A, boxes, qp::spectral_norm(A));

    const auto move_to = [&](const Eigen::VectorXd &lambda) {
      const Eigen::VectorXd d = lambda - iterate.lambda;
      if (d.isZero(0.))
        return;
      Eigen::VectorXd Qd;
      Q_.vmult(DualBlock::all, DualBlock::all, Qd, d);
      iterate.lambda = lambda;
      iterate.gradient += Qd;
    };

    Eigen::VectorXd x = squares.lift(iterate.lambda);
    move_to(squares.to_forces(x));
    Eigen::VectorXd gradient      = squares.pull_back(iterate.gradient);
    const Eigen::VectorXd start   = iterate.lambda;
    const DualMethodResult result = run_active_set_method(
      solver, x, gradient, scaling, rule, Mpgp::products_in_an_iteration, statistics_,
      [&](const Eigen::VectorXd &now) { iterate.lambda = squares.to_forces(now); },
      observer);
    iterate.lambda = start; // the one that the gradient belongs to
    move_to(squares.to_forces(x));
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
