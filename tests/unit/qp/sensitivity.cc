// How contact forces follow the multipliers of an equality constraint: against
// differences of solutions with all digits, with given and with Coulomb friction, where
// some nodes are open, some slip and some stick.

#include <stiction/qp/methods/newton.h>
#include <stiction/qp/sensitivity.h>
#include <stiction/qp/sets/feasible_set.h>

#include "qp_tests.h"

using namespace stiction;
using namespace qp_tests;

namespace
{
  // The solution of the contact conditions with r = Qλ − h.
  DualIterate solution(const MatrixXd &Q, const VectorXd &h, const qp::SlipBound &bound)
  {
    const DenseDualOperator dense(Q, h);
    DualIterate iterate{VectorXd::Zero(h.size()), -h};
    Newton(dense).solve(iterate,
                        {bound, {VectorXd::Ones(bound.n_nodes())}, {1e-13, 1., 1000}});
    return iterate;
  }
} // namespace

int main()
{
  Random random(11);
  const Index m = 20, n = 4;
  const MatrixXd Q = random.spd(3 * m, 100.);
  MatrixXd G(3 * m, n);
  for (Index j = 0; j < n; ++j)
    G.col(j) = random.vector(3 * m);
  const VectorXd h = random.vector(3 * m);

  const std::vector<std::pair<std::string, qp::SlipBound>> laws = {
    {"given", qp::SlipBound::given(random.vector(m, 0., 2.))},
    {"coulomb", qp::SlipBound::coulomb(random.vector(m, 0., 2.))}};
  for (const auto &[name, bound] : laws)
    {
      const DualIterate at = solution(Q, h, bound);
      Index n_open = 0, n_slip = 0, n_stick = 0;
      for (Index i = 0; i < m; ++i)
        {
          const double t = std::hypot(at.lambda(i + m), at.lambda(i + 2 * m));
          const double g = bound.at(at.lambda)(i);
          (at.lambda(i) <= 0. ? n_open : t < (1. - 1e-9) * g ? n_stick : n_slip)++;
        }
      const DenseDualOperator dense(Q, h);
      const MatrixXd S =
        qp::sensitivity(dense.diagonal_block(DualBlock::all), G, at.lambda, at.gradient,
                        dense.nodal_compliance(), bound);
      const double step = 1e-5;
      MatrixXd differences(3 * m, n);
      for (Index j = 0; j < n; ++j)
        differences.col(j) = (solution(Q, h - step * G.col(j), bound).lambda -
                              solution(Q, h + step * G.col(j), bound).lambda) /
                             (2. * step);
      std::cout << name << ": nodes open " << n_open << ", slipping " << n_slip
                << ", sticking " << n_stick << ", as differences are to 1e-3 "
                << ((S - differences).norm() < 1e-3 * differences.norm() ? "yes" : "no")
                << std::endl;
    }
}
