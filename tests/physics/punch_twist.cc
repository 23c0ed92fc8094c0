// A round punch, pressed on with a force and twisted: where all of its contact slips the
// torque is the coefficient of friction times the pressure times the arm, summed over
// the contact, and 3 pi/16 F P a of Hertz' contact.

#include "tests.h"

#include <deal.II/base/numbers.h>

#include <cmath>

using namespace stiction;

namespace
{
  constexpr double F = 0.3, P = 5.;

  double torque(const Run &run)
  {
    return run.summary()["contact"]["boundaries"][0]["torque"].get<double>();
  }

  Run twist(const Settings &settings)
  {
    return Run(shipped("punch_twist.prm"),
               settings + Settings{"Output/Write solution=false",
                                   "Refinement/Estimate error=false"});
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double a =
    std::cbrt(3. * P * 50. / (4. * 10. / (1. - 0.4 * 0.4))); // radius of contact
  const double hertz = 3. * dealii::numbers::PI / 16. * F * P * a;

  const Run slips               = twist({});
  const ContactSurface &surface = slips.problem->contact_surface();
  double sum                    = 0.;
  for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
    {
      const auto &x = surface.nodes()[i].position;
      sum += F * slips.problem->state().lambda(i) * std::hypot(x[0] - 16., x[1] - 16.);
    }
  out() << "certified " << yes(slips.converged) << ", all slips but the middle "
        << yes(slips.summary()["contact"]["stick"] <= 1)
        << ", torque of the pressures to 1e-3 "
        << yes(std::abs(torque(slips) / sum - 1.) < 1e-3) << ", of Hertz' within 2 % "
        << yes(std::abs(torque(slips) / hertz - 1.) < 0.02) << std::endl;

  const Run begins = twist({"Time/End=2", "Time/Steps=2"});
  out() << "twisted a little: certified " << yes(begins.converged)
        << ", the middle sticks and the rim slips "
        << yes(begins.summary()["contact"]["stick"] > 10 &&
               begins.summary()["contact"]["slip"] > 10)
        << ", with less torque " << yes(torque(begins) < 0.9 * torque(slips))
        << std::endl;
  if (std::getenv("SHOW"))
    std::cerr << torque(slips) << ' ' << sum << ' ' << hertz << ' ' << torque(begins)
              << ' ' << begins.summary()["contact"]["stick"] << std::endl;
}
