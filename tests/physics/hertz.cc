// Hertz' contact: a rigid sphere, and the paraboloid gap that goes with it,
// pressed into a quarter of an elastic block without friction. Pressure and
// radius of contact against Hertz' formulas for the force that was computed,
// their convergence, and the approach extrapolated to a block of infinite size.

#include "tests.h"

#include <deal.II/base/numbers.h>

#include <cmath>

using namespace stiction;

namespace
{
  constexpr double E_star = 210000. / (1. - 0.3 * 0.3), R = 100.;

  // What was computed, relative to Hertz' solution for the same force.
  struct Ratios
  {
    double pressure, radius, approach, a;
    double n_unknowns;
    bool certified;
  };

  Ratios
  press(std::vector<std::string> settings)
  {
    settings.push_back("Output/Write solution=false");
    const Run run(shipped("hertz.prm"), settings);
    const ContactSurface &surface = run.problem->contact_surface();
    const auto &lambda            = run.problem->certificate().lambda();
    double P = 0., second_moment = 0., highest = 0.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        P += lambda(i);
        second_moment += lambda(i) * (node.position[0] * node.position[0] +
                                      node.position[1] * node.position[1]);
        highest = std::max(highest, lambda(i) / node.area);
      }
    // of the whole, of which the symmetry leaves a quarter
    const double a  = std::cbrt(3. * 4. * P * R / (4. * E_star));
    const double p0 = 3. * 4. * P / (2. * dealii::numbers::PI * a * a);
    return {highest / p0,
            std::sqrt(2.5 * second_moment / P) / a,
            0.01 / (a * a / R),
            a,
            run.summary()["problem"]["dofs"].get<double>(),
            run.converged};
  }

  std::string
  refinement(const unsigned int r)
  {
    return "Geometry/Global refinement=" + std::to_string(r);
  }

  double
  error(const double ratio)
  {
    return std::abs(ratio - 1.);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Ratios coarse = press({refinement(2)});
  const Ratios middle = press({refinement(3)});
  const Ratios fine   = press({refinement(4)});
  out() << "sphere: certified " << yes(fine.certified)
        << ", pressure within 1 % " << yes(error(fine.pressure) < 0.01)
        << ", radius within 1 % " << yes(error(fine.radius) < 0.01) << '\n';
  // two refinements, order one: a quarter
  out() << "order in h at least 1: pressure "
        << yes(error(fine.pressure) < error(coarse.pressure) / 4.)
        << ", radius " << yes(error(fine.radius) < error(coarse.radius) / 4.)
        << '\n';

  const Ratios paraboloid =
    press({refinement(3),
           "Boundary conditions/Obstacle=foundation",
           "Boundary conditions/Initial gap=(x^2+y^2)/200-0.01*t"});
  out() << "paraboloid: certified " << yes(paraboloid.certified)
        << ", the sphere's pressure and radius to 1e-3 "
        << yes(std::abs(paraboloid.pressure - middle.pressure) < 1e-3 &&
               std::abs(paraboloid.radius - middle.radius) < 1e-3)
        << '\n';

  // a block twice as large, so that more of it is far from the contact
  const auto in_large_block = [](const unsigned int r,
                                 const unsigned int adaptive_steps) {
    return press(
      {refinement(r),
       "Geometry/Lengths=16,16,16",
       "Boundary conditions/Obstacle=sphere : 0; 0; 116-0.01*t; 100",
       "Refinement/Adaptive steps=" + std::to_string(adaptive_steps)});
  };

  // linear in a/L, with cells of the same size
  const Ratios large = in_large_block(4, 0);
  const double x = middle.a / 8., y = large.a / 16.;
  const double limit = (large.approach * x - middle.approach * y) / (x - y);
  out() << "approach: of the block itself more than 5 % off "
        << yes(error(middle.approach) > 0.05)
        << ", of an infinite one within 2 % " << yes(error(limit) < 0.02)
        << '\n';

  const Ratios uniform  = in_large_block(3, 0);
  const Ratios adaptive = in_large_block(1, 6);
  out() << "adaptive: certified " << yes(adaptive.certified)
        << ", a quarter of the unknowns "
        << yes(adaptive.n_unknowns <= uniform.n_unknowns / 4.)
        << ", pressure not worse "
        << yes(error(adaptive.pressure) <= error(uniform.pressure))
        << ", radius not worse "
        << yes(error(adaptive.radius) <= error(uniform.radius))
        << ", approach not worse "
        << yes(std::abs(adaptive.approach - large.approach) <=
               std::abs(uniform.approach - large.approach))
        << '\n';
}
