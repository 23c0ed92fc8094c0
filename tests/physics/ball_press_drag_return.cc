// A rigid ball pressed on a block, dragged, brought back and dragged again, against
// Cattaneo, Mindlin and Deresiewicz at every step: how far it was dragged for the force
// that holds it back, and how much of the contact sticks.

#include "tests.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  constexpr double E = 10., nu = 0.49, G = E / 2. / (1. + nu), R = 50., F = 0.3;

  // A step at its end; the forces are those of the whole block.
  struct Step
  {
    double time, way, pull, press;
    double stick; // radius of the circle with the area of the nodes that stick
    bool certified;
  };

  // The last of the steps through these times.
  Step last_step(const std::string &times, const Settings &mesh)
  {
    const std::string end = times.substr(times.rfind(',') + 1);
    const Run run(shipped("ball_press_drag_return.prm"),
                  mesh + Settings{"Time/End=" + end, "Time/Steps=" + times,
                                  "Output/Write solution=false",
                                  "Refinement/Estimate error=false"});
    const auto &boundary = run.summary()["contact"]["boundaries"][0];
    double area          = 0.;
    const auto statuses  = run.problem->node_statuses();
    for (Eigen::Index i = 0; i < run.problem->contact_surface().n_nodes(); ++i)
      if (statuses[i].tangential == TangentialStatus::stick)
        area += 2. * run.problem->contact_surface().nodes()[i].area;
    return {std::stod(end),
            boundary["obstacle_displacement"][0].get<double>(),
            2. * boundary["force_on_body"][0].get<double>(),
            -2. * boundary["force_on_body"][2].get<double>(),
            std::sqrt(area / dealii::numbers::PI),
            run.converged};
  }

  // The way that goes with a part q of the force of sliding, as Cattaneo and Mindlin
  // have it, relative to that of sliding.
  double way(const double q)
  {
    return 1. - std::pow(1. - q, 2. / 3.);
  }

  // At the end of a step: by how much the ball was dragged farther than theory says for
  // its force, relative to the largest way; the force as a part of that of sliding; and
  // the radius of sticking less that of theory, relative to the radius of contact.
  struct Deviation
  {
    double way, force, stick;
    bool certified;
  };

  std::vector<Deviation> compare(const Settings &mesh)
  {
    std::vector<Deviation> deviations;
    double turn       = 0.; // q where the ball is turned round
    std::string times = "1";
    for (const std::string time : {"1.5", "2", "3", "4", "5"})
      {
        times += "," + time;
        const Step step = last_step(times, mesh);
        const double a  = std::cbrt(3. * step.press * R / (4. * E / (1. - nu * nu)));
        const double K  = 3. * F * step.press / (16. * a) * (2. - nu) / G;
        const double q  = step.pull / (F * step.press);
        if (step.time <= 2.)
          turn = q;
        // what was dragged back since then, as if from the beginning with 2 F
        const double sign  = step.time <= 4. ? 1. : -1.;
        const double since = step.time <= 2. ? q : (turn - sign * q) / 2.;
        const double exact =
          step.time <= 2. ? way(q) : sign * (way(turn) - 2. * way(since));
        deviations.push_back({(step.way - K * exact) / 0.03, q,
                              step.stick / a - std::cbrt(1. - since), step.certified});
      }
    return deviations;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto refined = [](const unsigned int n) {
    return compare({"Geometry/Contact refinement=" + std::to_string(n)});
  };
  const auto coarse = refined(3), middle = refined(4), fine = refined(5);
  for (unsigned int i = 0; i < fine.size(); ++i)
    out() << "certified "
          << yes(coarse[i].certified && middle[i].certified && fine[i].certified)
          << ", way within 3 % " << yes(std::abs(fine[i].way) < 0.03)
          << ", force converges "
          << yes(std::abs(fine[i].force - middle[i].force) <
                 std::abs(middle[i].force - coarse[i].force))
          << ", radius of sticking within 3 % of that of contact "
          << yes(std::abs(fine[i].stick) < 0.03) << std::endl;
  const auto worst = [](const std::vector<Deviation> &deviations) {
    double largest = 0.;
    for (const Deviation &deviation : deviations)
      largest = std::max(largest, std::abs(deviation.stick));
    return largest;
  };
  out() << "radius of sticking, order in h about 1: "
        << yes(worst(middle) < 0.7 * worst(coarse) && worst(fine) < 0.7 * worst(middle))
        << std::endl;
}
