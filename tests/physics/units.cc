// Nothing in the program has a unit: with E, loads and slip stress multiplied
// by a power of two every number of the run is the same up to that factor, to
// the last bit; multiplied by 1e6, or in millimetres, up to rounding.

#include "tests.h"

#include <cmath>

using namespace stiction;

namespace
{
  std::vector<std::string> settings(const std::string &law, const std::string &method,
                                    const double stress, const double length)
  {
    const auto pascal = [&](const double value) { return exact(value * stress); };
    return {"Friction/Law=" + law,
            "Contact solver/Method=" + method,
            "Geometry/Table 1 level=0",
            "Geometry/Lengths=" + exact(4. * length) + "," + exact(3. * length) + "," +
              exact(length),
            "Geometry/Subdivisions=5,4,1",
            "Geometry/Global refinement=1",
            "Material/Young's modulus=" + pascal(2.119e11),
            "Friction/Slip stress=" + pascal(1.5e7),
            "Boundary conditions/Traction=5 : 0; 0; if(y > " + exact(1.5 * length) +
              ", -" + pascal(1e8) + ", 0) | 3 : " + pascal(1e7) + ";" + pascal(2e7) +
              ";" + pascal(2e7)};
  }

  void compare(const char *name, const Run &run, const Run &reference, const double force,
               const bool identical, const double spread)
  {
    const auto &a = run.summary()["solver"], &b = reference.summary()["solver"];
    const auto &lambda   = run.problem->state().lambda;
    const auto &expected = reference.problem->state().lambda;
    const double error   = (lambda / force - expected).norm() / expected.norm();

    const auto near = [&](const char *entry, const double allowed) {
      return std::abs(a.value(entry, 0.) - b.value(entry, 0.)) <= allowed;
    };
    const double products = b["dual_multiplications"].get<double>();
    out() << "  " << name << ": certified " << yes(run.converged);
    if (identical)
      out() << ", identical counts "
            << yes(near("coulomb_iterations", 0) && near("gauss_seidel_iterations", 0) &&
                   near("newton_steps", 0) && near("krylov_iterations", 0) &&
                   near("admm_iterations", 0) && near("dual_multiplications", 0) &&
                   near("stiffness_solves", 0))
            << ", identical forces " << yes(error == 0.);
    else
      {
        // relative to the whole force: without friction some components are 0
        double difference = 0., size = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const double expected_force =
              reference.summary()["contact"]["force_on_body"][c].get<double>();
            difference = std::hypot(
              difference,
              run.summary()["contact"]["force_on_body"][c].get<double>() / force -
                expected_force);
            size = std::hypot(size, expected_force);
          }
        const bool forces = difference <= 1e-8 * size;
        out() << ", outer counts within 1 "
              << yes(near("coulomb_iterations", 1) &&
                     near("newton_steps", 0.05 * b["newton_steps"].get<double>() + 1) &&
                     (!b.contains("levels") || near("krylov_iterations", 1)) &&
                     near("admm_iterations",
                          0.05 * b["admm_iterations"].get<double>() + 1) &&
                     near("gauss_seidel_iterations",
                          0.05 * b["gauss_seidel_iterations"].get<double>() + 1))
              << ", products within " << 100. * spread << " % "
              << yes(near("dual_multiplications", spread * products + 1))
              << ", forces to 1e-8 " << yes(forces);
      }
    out() << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const double two_20 = std::ldexp(1., 20);
  for (const std::string method :
       {"gauss seidel", "newton", "mpgp", "admm", "newton multigrid"})
    for (const std::string law : {"coulomb", "given", "frictionless"})
      {
        out() << method << ", " << law << std::endl;
        // long runs of active set steps are chaotic in the last digit: seven
        // scalings of E on 14 x 12 x 4 cells, on one and two threads, took 311
        // to 354 products
        const double spread = method == "mpgp" ? 0.15 : 0.05;
        const auto run      = [&](const double stress, const double length) {
          return Run(shipped("brick.prm"), settings(law, method, stress, length));
        };
        const Run reference = run(1., 1.);
        compare("2^20 times stiffer", run(two_20, 1.), reference, two_20, true, spread);
        compare("1e6 times stiffer", run(1e6, 1.), reference, 1e6, false, spread);
        compare("1e-6 times as stiff", run(1e-6, 1.), reference, 1e-6, false, spread);
        compare("in millimetres", run(1e-6, 1e3), reference, 1., false, spread);
      }
}
