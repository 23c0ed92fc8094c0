// Where a rigid block comes to rest on springs: it falls onto a table, symmetrically and
// not, with friction or none; a block between two plates; with motions that nothing
// holds it stays where it is.

#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/rigid_place.h>

#include "qp_tests.h"

using namespace stiction;
using namespace qp_tests;

namespace
{
  constexpr double stiffness = 1000., gap = 0.3;

  // Four nodes of a square of side 2, at z = 0, gap above a table; motions along x, z
  // and about y.
  EqualityConstraint block(const VectorXd &load)
  {
    EqualityConstraint balance{MatrixXd::Zero(12, 3), -load};
    for (Index i = 0; i < 4; ++i)
      {
        const double x = i % 2 == 0 ? -1. : 1.;
        balance.G.row(i) << 0., 1., -x; // −n·u with n = −z, u_z = α_1 − x α_2
        balance.G.row(i + 4) << -1., 0., 0.; // −t1·u
      }
    return balance;
  }

  VectorXd gradient()
  {
    VectorXd r = VectorXd::Zero(12);
    r.head(4).setConstant(gap);
    return r;
  }

  VectorXd three(const double x, const double z, const double turn)
  {
    return (VectorXd(3) << x, z, turn).finished();
  }
} // namespace

int main()
{
  const VectorXd rho = VectorXd::Constant(4, stiffness);
  const auto smooth  = qp::SlipBound::given(VectorXd::Zero(4));
  const auto rough   = qp::SlipBound::coulomb(VectorXd::Constant(4, 0.3));
  const auto near    = [](const VectorXd &a, const VectorXd &b) {
    return yes((a - b).norm() < 1e-3 * b.norm());
  };

  // weight 40: four springs give way by 0.01
  std::cout
    << "falls: "
    << near(qp::rigid_place(block(three(0., -40., 0.)), gradient(), rho, smooth).alpha,
            three(0., -gap - 0.01, 0.))
    << std::endl;
  // the moment 20 about y: 4 k x² turn = 20
  const VectorXd turned =
    qp::rigid_place(block(three(0., -40., 20.)), gradient(), rho, smooth).alpha;
  std::cout << "falls and turns: " << near(turned, three(0., -gap - 0.01, 0.005))
            << std::endl;
  // rough: 4 k x = 4 beside what it went while it fell
  const VectorXd pushed =
    qp::rigid_place(block(three(4., -40., 0.)), gradient(), rho, rough).alpha;
  std::cout << "sticks: " << yes(std::abs(4. * stiffness * pushed(0) - 4.) < 0.1)
            << ", and presses: " << yes(std::abs(pushed(1) + gap + 0.01) < 1e-4)
            << std::endl;
  std::cout << "no load, no touch: "
            << yes(qp::rigid_place(block(three(0., 0., 0.)), gradient(), rho, rough)
                     .alpha.isZero(0.))
            << std::endl;
  // overlaps of 0.02 below two nodes, and of 0.01 above the two others
  VectorXd overlap = VectorXd::Zero(12);
  overlap.head(4) << -0.02, -0.02, -0.01, -0.01;
  EqualityConstraint plates = block(three(0., 0., 0.));
  plates.G.middleRows(2, 2) *= -1.;
  const VectorXd between = qp::rigid_place(plates, overlap, rho, smooth).alpha;
  const VectorXd r       = overlap + plates.G * between;
  std::cout << "between two plates forces balance: "
            << yes(std::abs(r(0) + r(1) - r(2) - r(3)) < 1e-4)
            << ", it moved: " << yes(std::abs(between(1) - 0.005) < 1e-4) << std::endl;
}
