// All methods give one answer. On the reference brick, both readings of
// Table 1 and both laws of friction, every exact method is certified, its
// contact forces agree with those of the first one to 1e-6, and Newton's
// method stays within 100 products with Q for given friction and 120 for
// Coulomb friction. The methods with squares in place of discs are never
// certified; their error is that of the polygon and falls with its corners.

#include "tests.h"

#include <algorithm>
#include <cmath>

namespace
{
  std::string file(const std::string &reading, const std::string &law)
  {
    return shipped("table_1/" + reading + "_" + law + ".prm");
  }

  Run solve(const std::string &prm, const unsigned int level,
            std::vector<std::string> settings)
  {
    settings.push_back("Geometry/Table 1 level=" + std::to_string(level));
    settings.push_back("Contact solver/Tolerance=1e-8");
    return Run(prm, settings);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  for (const std::string reading : {"nodes", "unknowns"})
    for (const std::string law : {"given_friction", "coulomb"})
      for (const unsigned int level : {1, 2, 3})
        {
          const std::string prm = file(reading, law);
          const Run newton      = solve(prm, level, {"Contact solver/Method=newton"});
          const double products =
            newton.summary()["solver"]["dual_multiplications"].get<double>();
          out() << reading << ", " << law << ", k = " << level << ": newton certified "
                << yes(newton.converged) << ", products within bounds "
                << yes(products <= (law == "coulomb" ? 120. : 100.)) << ";";

          std::vector<std::vector<std::string>> others = {
            {"Contact solver/Method=gauss seidel"},
            {"Contact solver/Method=gauss seidel", "Contact solver/Disc solver=spectral"},
            {"Contact solver/Method=mpgp"},
            {"Contact solver/Method=admm"},
            {"Contact solver/Method=newton", "Dual operator/Form=by solves"}};
          if (law == "coulomb")
            {
              others.push_back({"Contact solver/Method=newton",
                                "Contact solver/Coulomb iteration=fixed "
                                "point"});
              others.push_back({"Contact solver/Method=gauss seidel",
                                "Contact solver/Coulomb iteration=fixed point"});
            }
          unsigned int certified = 0;
          double largest         = 0.;
          for (const auto &settings : others)
            {
              const Run run = solve(prm, level, settings);
              certified += run.converged ? 1 : 0;
              largest = std::max(largest, distance(run, newton));
            }
          out() << " others certified " << yes(certified == others.size())
                << ", agree to 1e-6 " << yes(largest < 1e-6) << std::endl;
        }

  const std::string prm = file("nodes", "given_friction");
  const Run disc        = solve(prm, 2, {"Contact solver/Method=newton"});
  double last           = 1.;
  for (const unsigned int squares : {1, 2, 4, 8, 16})
    {
      const Run run      = solve(prm, 2,
                                 {"Contact solver/Method=squares",
                                  "Contact solver/Squares=" + std::to_string(squares)});
      const double error = distance(run, disc);
      // the corners of the polygon lie outside of the circle by this part
      const double corners = 1. / std::cos(std::acos(-1.) / (4. * squares)) - 1.;
      const double violation =
        run.summary()["certificate"]["cone_violation"].get<double>();
      // bounds are relative to A p0; the slip stress is 1.5e7 Pa at every node
      const double in_radii =
        violation / (1.5e7 * disc.problem->contact_surface().areas()(0) /
                     run.problem->certificate().scaling().force(0));
      out() << squares << " squares: refused " << yes(!run.converged)
            << ", cone violated by the polygon's corners "
            << yes(in_radii < 1.0001 * corners && in_radii > 0.5 * corners)
            << ", nearer to the disc than before " << yes(error < 0.7 * last)
            << std::endl;
      last = error;
    }
}
