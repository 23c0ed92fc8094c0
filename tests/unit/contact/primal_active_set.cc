// The linearised conditions in displacements: Newton's method with them, on
// single nodes held by springs, ends where contact and friction conditions
// hold, whatever ρ is and with normal and tangential stiffness coupled.

#include <stiction/contact/primal/primal_active_set.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/LU>

#include <cmath>
#include <iostream>
#include <string>

using namespace stiction;

int main()
{
  const Eigen::Matrix3d K =
    (Eigen::Matrix3d() << 3., 0.4, -0.3, 0.4, 2., 0.2, -0.3, 0.2, 1.5).finished();
  for (const std::string law : {"frictionless", "given", "coulomb"})
    for (const double rho : {0.03, 0.3, 3.})
      {
        unsigned int solved = 0, steps = 0, most = 0, states = 0;
        for (unsigned int k = 0; k < 200; ++k)
          {
            // loads of all directions; R = f − K w
            const double angle = 0.7 * k, size = 1.5 * std::sin(0.31 * k);
            const Eigen::Vector3d f(2. * std::sin(1.3 * k) + 0.5, size * std::cos(angle),
                                    size * std::sin(angle));
            const Eigen::VectorXd data =
              Eigen::VectorXd::Constant(1, law == "frictionless" ? 0.
                                           : law == "given"      ? 0.6
                                                                 : 0.5);
            const qp::SlipBound bound = law == "coulomb" ? qp::SlipBound::coulomb(data)
                                                         : qp::SlipBound::given(data);
            Eigen::Vector3d w         = Eigen::Vector3d::Zero();
            double residual           = 1.;
            unsigned int step         = 0;
            for (; step < 60 && residual > 1e-12; ++step)
              {
                const Eigen::VectorXd lambda = f - K * w;
                const PrimalActiveSet linearization(
                  lambda, w, Eigen::VectorXd::Constant(1, rho), bound);
                const auto &node = linearization.nodes[0];
                w += node.shift;
                const Eigen::Matrix3d A = node.test * K * node.projection + node.spring +
                                          Eigen::Matrix3d::Identity() - node.projection;
                w += A.lu().solve(node.test * (f - K * w) - node.spring * w - node.load);

                const Eigen::VectorXd now = f - K * w;
                Eigen::VectorXd projected = now + w;
                qp::HalfLinesTimesDiscs(bound.at(now)).project(projected);
                residual = (now - projected).norm();
                if (residual <= 1e-12)
                  states |= now(0) < 1e-9 ? 1u : w.norm() < 1e-9 ? 2u : 4u;
              }
            solved += residual <= 1e-12 ? 1 : 0;
            steps += step;
            most = std::max(most, step);
          }
        std::cout << law << ", rho = " << rho << ": " << solved
                  << " of 200 solved, at most 12 steps on average "
                  << (steps <= 12 * 200 ? "yes" : "NO") << ", all states occur "
                  << ((states & 5u) == 5u && (states == 7u || law == "frictionless")
                        ? "yes"
                        : "NO")
                  << std::endl;
      }
}
