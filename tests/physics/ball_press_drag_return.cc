// A rigid ball pressed on a block, dragged, brought back and dragged again, against
// Cattaneo, Mindlin and Deresiewicz at every step: how far it was dragged for the force
// that holds it back, and how much of the contact sticks.

#include "tests.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

using namespace stiction;

namespace
{
  constexpr double E = 10., nu = 0.49, G = E / 2. / (1. + nu), R = 50., F = 0.3;

  // A step at its end; the forces are those of the whole block.
  struct Step
  {
    double time, way, pull, press;
    double stick; // radius of the circle with the area of the nodes that stick
    double lost;  // by friction since the start
  };

  // The rows of history.csv.
  std::vector<Step> steps(const std::string &file)
  {
    std::ifstream in(file);
    std::string line, cell;
    std::vector<std::string> names;
    std::vector<Step> rows;
    while (std::getline(in, line))
      {
        std::map<std::string, std::string> row;
        std::istringstream cells(line);
        for (std::size_t i = 0; std::getline(cells, cell, ','); ++i)
          if (rows.empty() && names.size() == i)
            names.push_back(cell);
          else
            row[names[i]] = cell;
        const auto number = [&row](const char *name) { return std::stod(row.at(name)); };
        if (!row.empty())
          rows.push_back({number("t"), number("obstacle_x"), 2. * number("force_x"),
                          -2. * number("force_z"),
                          std::sqrt(2. * number("stick_area") / dealii::numbers::PI),
                          2. * number("dissipated_total")});
      }
    return rows;
  }

  // The way that goes with a part q of the force of sliding, as Cattaneo and Mindlin
  // have it, relative to that of sliding.
  double way(const double q) { return 1. - std::pow(1. - q, 2. / 3.); }

  // At the end of a step: by how much the ball was dragged farther than theory says for
  // its force, relative to the largest way; the force as a part of that of sliding; and
  // the radius of sticking less that of theory, relative to the radius of contact.
  struct Deviation
  {
    double way, force, stick;
  };

  std::vector<Deviation> compare(const unsigned int refinement)
  {
    const int percent = refinement == 3 ? 4 : 1;
    const Run run(shipped("ball_press_drag_return.prm"),
                  {"Geometry/Contact refinement=" + std::to_string(refinement),
                   "Output/Write solution=false", "Refinement/Estimate error=false"});
    std::vector<Deviation> deviations;
    double turn = 0., lost = 0.; // q where the ball is turned round, lost before
    for (const Step &step : steps("results/history.csv"))
      {
        const double a = std::cbrt(3. * step.press * R / (4. * E / (1. - nu * nu)));
        const double K = 3. * F * step.press / (16. * a) * (2. - nu) / G;
        const double q = step.pull / (F * step.press);
        if (step.time <= 2.)
          {
            turn = q;
            lost = step.lost;
          }
        // what was dragged back since then, as if from the beginning with 2 F
        const double sign  = step.time <= 4. ? 1. : -1.;
        const double since = step.time <= 2. ? q : (turn - sign * q) / 2.;
        const double exact =
          step.time <= 2. ? way(q) : sign * (way(turn) - 2. * way(since));
        // the area of the loop of force and way
        if (step.time == 6.)
          {
            const double loop =
              4. * K * F * step.press *
              (turn * way(turn) - 2. * turn + 1.2 * (1. - std::pow(1. - turn, 5. / 3.)));
            out() << "certified " << yes(run.converged)
                  << ", energy lost to and fro within " << percent << " % "
                  << yes(std::abs((step.lost - lost) / loop - 1.) < 0.01 * percent)
                  << std::endl;
          }
        if (step.time > 1.)
          deviations.push_back(
            {(step.way - K * exact) / 0.03, q, step.stick / a - std::cbrt(1. - since)});
      }
    return deviations;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto coarse = compare(3), middle = compare(4), fine = compare(5);
  double change_of_middle = 0., change_of_fine = 0.; // of the force, by refinement
  for (unsigned int i = 0; i < fine.size(); ++i)
    {
      out() << "way within 3 % " << yes(std::abs(fine[i].way) < 0.03)
            << ", radius of sticking within 3 % of that of contact "
            << yes(std::abs(fine[i].stick) < 0.03) << std::endl;
      change_of_middle =
        std::max(change_of_middle, std::abs(middle[i].force - coarse[i].force));
      change_of_fine =
        std::max(change_of_fine, std::abs(fine[i].force - middle[i].force));
    }
  out() << "force converges " << yes(change_of_fine < 0.5 * change_of_middle);
  const auto worst = [](const std::vector<Deviation> &deviations) {
    double largest = 0.;
    for (const Deviation &deviation : deviations)
      largest = std::max(largest, std::abs(deviation.stick));
    return largest;
  };
  out() << ", radius of sticking, order in h about 1: "
        << yes(worst(middle) < 0.7 * worst(coarse) && worst(fine) < 0.7 * worst(middle))
        << std::endl;
}
