// Hertz' contact: a rigid sphere, and the paraboloid gap that goes with it,
// pressed with a force into a quarter of an elastic block without friction.
// Pressure, radius of contact and approach against Hertz' formulas, their
// convergence, and the approach extrapolated to a block of infinite size.

#include "tests.h"

#include <deal.II/base/numbers.h>

#include <cmath>

using namespace stiction;

namespace
{
  constexpr double E_star = 210000. / (1. - 0.3 * 0.3), R = 100.;

  // The force on the whole block.
  constexpr double P = 4. * 769.2307692;

  // What was computed, relative to Hertz' solution.
  struct Ratios
  {
    double pressure, radius, approach;
    double n_unknowns;
    bool certified;
  };

  Ratios press(std::vector<std::string> settings)
  {
    settings.push_back("Output/Write solution=false");
    const Run run(shipped("hertz.prm"), settings);
    const ContactSurface &surface = run.problem->contact_surface();
    const auto &lambda            = run.problem->certificate().lambda();
    double force = 0., second_moment = 0., highest = 0.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        force += lambda(i) * node.normal[2];
        second_moment += lambda(i) * (node.position[0] * node.position[0] +
                                      node.position[1] * node.position[1]);
        highest = std::max(highest, lambda(i) / node.area);
      }
    const double a  = std::cbrt(3. * P * R / (4. * E_star));
    const double p0 = 3. * P / (2. * dealii::numbers::PI * a * a);
    const double approach =
      -run.summary()["contact"]["boundaries"][0]["obstacle_displacement"][2]
         .get<double>();
    return {highest / p0, std::sqrt(2.5 * second_moment / force) / a,
            approach / (a * a / R), run.summary()["problem"]["dofs"].get<double>(),
            run.converged && std::abs(4. * force / P - 1.) < 1e-6};
  }

  std::string refinement(const unsigned int r)
  {
    return "Geometry/Global refinement=" + std::to_string(r);
  }

  double error(const double ratio) { return std::abs(ratio - 1.); }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Ratios coarse = press({refinement(2)});
  const Ratios middle = press({refinement(3)});
  const Ratios fine   = press({refinement(4)});
  out() << "sphere: certified, with its force " << yes(fine.certified)
        << ", pressure within 1 % " << yes(error(fine.pressure) < 0.01)
        << ", radius within 1 % " << yes(error(fine.radius) < 0.01) << '\n';
  // two refinements, order one: a quarter
  out() << "order in h at least 1: pressure "
        << yes(error(fine.pressure) < error(coarse.pressure) / 4.) << ", radius "
        << yes(error(fine.radius) < error(coarse.radius) / 4.) << '\n';

  const Ratios paraboloid =
    press({refinement(3), "Boundary conditions/Obstacle=foundation",
           "Boundary conditions/Initial gap=(x^2+y^2)/200"});
  out() << "paraboloid: certified " << yes(paraboloid.certified)
        << ", the sphere's pressure and radius to 1e-3 "
        << yes(std::abs(paraboloid.pressure - middle.pressure) < 1e-3 &&
               std::abs(paraboloid.radius - middle.radius) < 1e-3)
        << '\n';

  // a block twice as large, so that more of it is far from the contact
  const auto in_large_block = [](const unsigned int r,
                                 const unsigned int adaptive_steps) {
    return press({refinement(r), "Geometry/Lengths=16,16,16",
                  "Boundary conditions/Obstacle=sphere : 0; 0; 116; 100",
                  "Refinement/Adaptive steps=" + std::to_string(adaptive_steps)});
  };

  // linear in a/L, with cells of the same size
  const Ratios large = in_large_block(4, 0);
  const double limit = 2. * large.approach - middle.approach;
  out() << "approach: of the block itself more than 5 % off "
        << yes(error(middle.approach) > 0.05) << ", of an infinite one within 2 % "
        << yes(error(limit) < 0.02) << '\n';

  const Ratios uniform  = in_large_block(3, 0);
  const Ratios adaptive = in_large_block(1, 6);
  out() << "adaptive: certified " << yes(adaptive.certified)
        << ", a quarter of the unknowns "
        << yes(adaptive.n_unknowns <= uniform.n_unknowns / 4.) << ", pressure not worse "
        << yes(error(adaptive.pressure) <= error(uniform.pressure))
        << ", radius not worse " << yes(error(adaptive.radius) <= error(uniform.radius))
        << ", approach not worse "
        << yes(std::abs(adaptive.approach - large.approach) <=
               std::abs(uniform.approach - large.approach))
        << '\n';
}
