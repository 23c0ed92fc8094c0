// Two equal elastic bodies with a gap like that of two spheres, pressed on one another
// and moved to and fro, against Cattaneo, Mindlin and Deresiewicz: how much of the
// contact sticks, and what a loop of the tangential force loses.

#include "tests.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <cmath>
#include <fstream>
#include <map>

using namespace stiction;

namespace
{
  constexpr double E = 10., nu = 0.3, G = E / 2. / (1. + nu), R = 50., F = 0.3;

  // Halves of two blocks, by a plane of symmetry; 1/R is the sum of the curvatures.
  const char *const text = R"(
subsection Body lower
  set Lengths      = 60, 32, 32
  set Subdivisions = 15, 8, 8
end
subsection Body upper
  set Lengths      = 60, 32, 32
  set Subdivisions = 15, 8, 8
  set Translation  = 0; 0; 32
end
subsection Geometry
  set Contact refinement where = (x-30)^2 + y^2 < 7
end
subsection Material
  set Young's modulus = 10
  set Poisson ratio   = 0.3
end
subsection Boundary conditions
  set Prescribed displacement = lower.bottom : 0; 0; 0 | lower.front : free; 0; free \
    | upper.front : free; 0; free \
    | upper.top : 0.0175*if(t < 1, 0, if(t < 2, t-1, if(t < 4, 3-t, t-5))); 0; -0.1*min(t,1)
  set Contact boundary        = upper.bottom
  set Obstacle                = boundary : lower.top
  set Initial gap             = ((x-30)^2 + y^2)/100
end
subsection Friction
  set Law         = coulomb
  set Coefficient = 0.3
end
subsection Time
  set End   = 6
  set Steps = 6
end
subsection Contact solver
  set Tolerance = 1e-8
end
subsection Refinement
  set Estimate error = false
end
subsection Output
  set Write solution = false
end
)";

  using Row = std::map<std::string, double>;

  std::vector<Row> history(const std::string &file)
  {
    std::ifstream in(file);
    std::string line, cell;
    std::vector<std::string> names;
    std::vector<Row> rows;
    while (std::getline(in, line))
      {
        std::vector<std::string> values;
        std::istringstream cells(line);
        while (std::getline(cells, cell, ','))
          values.push_back(cell);
        if (names.empty())
          names = values;
        else
          {
            rows.emplace_back();
            for (std::size_t i = 0; i < values.size(); ++i)
              if (!values[i].empty() && names[i] != "boundary" && names[i] != "pair" &&
                  names[i] != "opposite")
                rows.back()[names[i]] = std::stod(values[i]);
          }
      }
    return rows;
  }

  // By how much the radius of sticking and the energy lost in a loop differ from theory.
  std::pair<double, double> deviations(const unsigned int refinement, bool &is_certified,
                                       const std::string &method = "newton")
  {
    const Run run("two_spheres.prm",
                  {"Geometry/Contact refinement=" + std::to_string(refinement),
                   "Contact solver/Method=" + method});
    is_certified   = is_certified && run.converged;
    const auto all = history("results/history.csv");
    const Row &end = all.back();

    const double P = 2. * std::abs(end.at("force_z"));
    const double q = 2. * std::abs(end.at("force_x")) / (F * P);
    const double a = std::cbrt(3. * P * R * 2. * (1. - nu * nu) / (4. * E));
    const double stick =
      std::sqrt(end.at("stick_area") / (end.at("stick_area") + end.at("slip_area")));
    const double loop =
      9. * F * F * P * P / (10. * a) * 2. * (2. - nu) / G *
      (1. - std::pow(1. - q, 5. / 3.) - 5. * q / 6. * (1. + std::pow(1. - q, 2. / 3.)));
    const double lost = 2. * (end.at("dissipated_total") - all[1].at("dissipated_total"));
    return {stick / std::cbrt(1. - q) - 1., lost / loop - 1.};
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::ofstream("two_spheres.prm") << text;
  bool are_certified = true;
  const auto coarse  = deviations(3, are_certified);
  const auto fine    = deviations(5, are_certified);
  const auto primal  = deviations(3, are_certified, "newton multigrid");
  out() << "certified " << yes(are_certified) << std::endl;
  out() << "by newton multigrid the same to 1e-6 "
        << yes(std::abs(primal.first - coarse.first) < 1e-6 &&
               std::abs(primal.second - coarse.second) < 1e-6)
        << std::endl;
  out() << "radius of sticking to 2 % " << yes(std::abs(fine.first) < 0.02)
        << ", nearer than on cells four times as large "
        << yes(std::abs(fine.first) < std::abs(coarse.first)) << std::endl;
  out() << "energy lost in a loop to 1.5 % " << yes(std::abs(fine.second) < 0.015)
        << ", ten times nearer than on cells four times as large "
        << yes(std::abs(fine.second) < std::abs(coarse.second) / 10.) << std::endl;
}
