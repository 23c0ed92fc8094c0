// What contact forces can balance: a block on a table, whose limits of sliding and
// tipping are known, by Coulomb's law and given friction; few nodes and many; a motion
// that nothing stops does more work than any contact forces; no units; normals across a
// motion but for the rounding of a mesh do not bear it.

#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/unbalanced_load.h>

#include "qp_tests.h"

#include <cmath>

using namespace stiction;
using namespace qp_tests;

namespace
{
  constexpr double coefficient = 0.3;

  // n × n nodes of the unit square below a block whose centre is at a height; the loads
  // are forces and moments about that centre, which G takes along −Z.
  EqualityConstraint block(const Index n, const double height, const VectorXd &load)
  {
    const Index m = n * n;
    EqualityConstraint balance{MatrixXd(3 * m, 6), -load};
    for (Index i = 0; i < m; ++i)
      {
        const double x = static_cast<double>(i % n) / static_cast<double>(n - 1) - 0.5;
        const double y = static_cast<double>(i / n) / static_cast<double>(n - 1) - 0.5;
        const double z = -height;
        MatrixXd Z(3, 6); // of the node
        Z << 1., 0., 0., 0., z, -y, 0., 1., 0., -z, 0., x, 0., 0., 1., y, -x, 0.;
        balance.G.row(i)         = Z.row(2); // n = −z
        balance.G.row(i + m)     = -Z.row(0);
        balance.G.row(i + 2 * m) = -Z.row(1);
      }
    return balance;
  }

  // A pin in a bore that can move along its axis alone, pushed with 1.
  EqualityConstraint pin(const Index m)
  {
    EqualityConstraint balance{MatrixXd::Zero(3 * m, 1), VectorXd::Constant(1, -1.)};
    for (Index i = 0; i < m; ++i)
      {
        balance.G(i, 0)     = i % 2 == 0 ? 1e-9 : -1e-9;
        balance.G(i + m, 0) = -1.;
      }
    return balance;
  }

  VectorXd load(const double x, const double y, const double z, const double twist = 0.)
  {
    VectorXd f(6);
    f << x, y, z, 0., 0., twist;
    return f;
  }

  // Whether the forces are allowed and balance, or the motion runs away from all that
  // are allowed: the largest they can do along ρ is that of given friction.
  bool is_right(const EqualityConstraint &balance, const qp::SlipBound &bound)
  {
    const auto [rho, lambda, part] = qp::unbalanced_load(balance, bound);
    const Index m                  = bound.n_nodes();
    const VectorXd g               = bound.at(lambda);
    const double size              = balance.e.norm();
    bool are_allowed               = true;
    for (Index i = 0; i < m; ++i)
      are_allowed =
        are_allowed && lambda(i) >= 0. &&
        at_node(lambda, i).tail<2>().norm() <= g(i) * (1. + 1e-12) + 1e-15 * size;
    const VectorXd left = balance.e - balance.G.transpose() * lambda;
    if (rho.isZero(0.))
      return are_allowed && part == 0. && left.norm() <= 2e-8 * size;
    if (!(std::abs(part * size - rho.norm()) <= 1e-12 * size))
      return false;
    const VectorXd v = balance.G * rho;
    double most      = 0.;
    bool resists     = false;
    for (Index i = 0; i < m; ++i)
      {
        const Eigen::Vector3d at = at_node(v, i);
        most += bound.constant()(i) * at.tail<2>().norm();
        resists = resists || at(0) + bound.coefficient()(i) * at.tail<2>().norm() >
                               1e-3 * rho.norm();
      }
    return are_allowed && !resists && balance.e.dot(rho) > most;
  }

  void check(const std::string &what, const EqualityConstraint &balance,
             const qp::SlipBound &bound)
  {
    const double unit = 1e9;
    const auto result = qp::unbalanced_load(balance, bound);
    const auto larger = qp::unbalanced_load(
      {balance.G, unit * balance.e},
      qp::SlipBound::mixed(unit * bound.constant(), bound.coefficient()));
    std::cout << what << ": balanced " << yes(result.is_balanced()) << ", right "
              << yes(is_right(balance, bound)) << ", the same in other units "
              << yes((larger.rho - unit * result.rho).norm() <=
                     1e-6 * unit * balance.e.norm())
              << std::endl;
  }
} // namespace

int main()
{
  for (const Index n : {2, 9, 40})
    {
      const Index m    = n * n;
      const auto rough = qp::SlipBound::coulomb(VectorXd::Constant(m, coefficient));
      const auto glued =
        qp::SlipBound::given(VectorXd::Constant(m, coefficient / static_cast<double>(m)));
      const auto smooth = qp::SlipBound::given(VectorXd::Zero(m));
      std::cout << n * n << " nodes" << std::endl;
      check("at rest", block(n, 0.5, load(0., 0., -1.)), rough);
      check("slope 0.29999", block(n, 0.5, load(0.29999, 0., -1.)), rough);
      check("slope 0.30001", block(n, 0.5, load(0.30001, 0., -1.)), rough);
      check("oblique slope 0.29999",
            block(n, 0.5, load(0.29999 * 0.6, 0.29999 * 0.8, -1.)), rough);
      check("oblique slope 0.30001",
            block(n, 0.5, load(0.30001 * 0.6, 0.30001 * 0.8, -1.)), rough);
      check("tipping, centre at 1.9999", block(n, 1.9999, load(0.25, 0., -1.)), rough);
      check("tipping, centre at 2.0001", block(n, 2.0001, load(0.25, 0., -1.)), rough);
      check("pulled off", block(n, 0.5, load(0., 0., 1e-3)), rough);
      check("twisted", block(n, 0.5, load(0., 0., -1., 0.1)), rough);
      check("twisted off", block(n, 0.5, load(0., 0., -1., 0.25)), rough);
      check("given friction, 0.29999", block(n, 0.5, load(0.29999, 0., -1.)), glued);
      check("given friction, 0.30001", block(n, 0.5, load(0.30001, 0., -1.)), glued);
      check("no friction", block(n, 0.5, load(0., 0., -1.)), smooth);
      check("no friction, slope 1e-5", block(n, 0.5, load(1e-5, 0., -1.)), smooth);
      check("no load", block(n, 0.5, load(0., 0., 0.)), rough);
    }
  check("in a bore, too little friction", pin(10),
        qp::SlipBound::given(VectorXd::Constant(10, 0.09)));
  check("in a bore, enough friction", pin(10),
        qp::SlipBound::given(VectorXd::Constant(10, 0.11)));
}
