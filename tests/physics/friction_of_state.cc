// Friction that depends on pressure and on the way slipped: at every node the force
// follows the law at the answer's own pressure and way, which on a straight path is
// the displacement itself.

#include "tests.h"

#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace stiction;

namespace
{
  // Pressed, then dragged by more than it takes to slip.
  const Settings dragged = {
    "Geometry/Table 1 level=0",
    "Geometry/Lengths=4,3,1",
    "Geometry/Subdivisions=4,3,1",
    "Geometry/Global refinement=1",
    "Material/Poisson ratio=0",
    "Boundary conditions/Traction=",
    "Boundary conditions/Prescribed displacement=top : 1e-3*max(0, t - 1); 0; "
    "-1e-4*min(t, 1)",
    "Time/Steps=1, 1.4, 2",
    "Contact solver/Tolerance=1e-9"};

  using Law = std::function<double(double pressure, double slip)>;

  // By how much the tangential forces miss what the law allows at most, relative to
  // the normal forces; all nodes slip along x all the time but while they are pressed.
  double distance_from_law(const Run &run, const Law &bound)
  {
    const ContactSurface &surface = run.problem->contact_surface();
    const Eigen::VectorXd &lambda = run.problem->state().lambda;
    const Eigen::VectorXd u = surface.B().dofs().restriction(run.problem->state().u);
    const Eigen::Index m    = surface.n_nodes();
    double worst            = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const double area = surface.areas()(i), pressure = lambda(i) / area;
        const double friction = std::hypot(lambda(i + m), lambda(i + 2 * m)) / area;
        worst = std::max(worst, std::abs(friction - bound(pressure, std::abs(u(i)))) /
                                  std::max(pressure, 1.));
      }
    return worst;
  }

  void check(const std::string &what, const Method &method, const Settings &friction,
             const Law &bound)
  {
    const Run run(shipped("brick.prm"), dragged + method.settings + friction);
    out() << "  " << what << ": certified " << yes(run.converged)
          << ", the law holds to 1e-6 " << yes(distance_from_law(run, bound) < 1e-6)
          << std::endl;
  }

  void check(const Method &method)
  {
    out() << method.name << ":" << std::endl;
    const auto falling = [](double, const double slip) {
      return 0.2 + 0.2 * std::exp(-slip / 1e-4);
    };
    check("falls with slip", method, {"Friction/Coefficient=0.2+0.2*exp(-slip/1e-4)"},
          [&](const double p, const double s) { return falling(p, s) * p; });
    check(
      "rises with slip", method, {"Friction/Coefficient=0.2+0.2*slip/(slip+1e-5)"},
      [](const double p, const double s) { return (0.2 + 0.2 * s / (s + 1e-5)) * p; });
    check(
      "falls with pressure and slip, another one for each place", method,
      {"Friction/Coefficient=(0.2+0.2*exp(-slip/1e-4))/(1+pressure/1e7)+0*x"},
      [&](const double p, const double s) { return falling(p, s) / (1. + p / 1e7) * p; });
    check("rises with pressure", method, {"Friction/Coefficient=0.1+0.1*pressure/2.1e7"},
          [](const double p, double) { return (0.1 + 0.1 * p / 2.1e7) * p; });
    check("an ellipse that shrinks", method,
          {"Friction/Coefficient=0.3*exp(-slip/1e-3); 0.1*exp(-slip/1e-3)"},
          [](const double p, const double s) { return 0.3 * std::exp(-s / 1e-3) * p; });
    check("as the pressure until the metal yields", method,
          {"Friction/Law=given", "Friction/Slip stress=min(0.2*pressure, 4.2e6)"},
          [](const double p, double) { return std::min(0.2 * p, 4.2e6); });
  }

  // Numbers written as formulas are numbers.
  void check_constant()
  {
    const auto forces = [](const std::string &coefficient) {
      const Run run(shipped("brick.prm"), {"Friction/Coefficient=" + coefficient});
      return run.problem->state().lambda;
    };
    const Eigen::VectorXd number = forces("0.3");
    out() << "0.3 + 0*pressure + 0*slip is 0.3, to 1e-8 "
          << yes((forces("0.3 + 0*pressure + 0*slip") - number).norm() <
                 1e-8 * number.norm())
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Method &method : all_methods())
    if (method.name == "newton" || method.name == "newton multigrid" ||
        method.name == "gauss seidel" || method.name == "mpgp")
      check(method);
  check_constant();
}
