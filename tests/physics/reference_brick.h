// The body of the reference_brick tests: STIFFNESS_SOLVER is the solver, up to
// which row of Table 1 LARGEST_LEVEL.

#include "tests.h"

#include <array>
#include <cmath>

namespace
{
  struct Reference
  {
    const char *law;
    unsigned int level;
    std::array<double, 3> force;        // N, on the body
    std::array<unsigned int, 3> status; // open, stick, slip
  };

  const std::array<Reference, 6> references = {
    {{"coulomb", 1, {{-3.983695e7, -6.998529e7, 5.273469e8}}, {{0, 13, 41}}},
     {"coulomb", 2, {{-3.976076e7, -7.128451e7, 5.268047e8}}, {{25, 35, 120}}},
     {"coulomb", 3, {{-3.974534e7, -7.158390e7, 5.265854e8}}, {{61, 63, 254}}},
     {"given", 1, {{-3.979409e7, -5.461809e7, 5.275008e8}}, {{6, 24, 30}}},
     {"given", 2, {{-3.965936e7, -5.733979e7, 5.270135e8}}, {{25, 84, 96}}},
     {"given", 3, {{-3.962652e7, -5.799868e7, 5.268582e8}}, {{71, 178, 200}}}}};
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Reference &reference : references)
    for (const std::string form : {"assembled", "by solves"})
      {
        if (reference.level > LARGEST_LEVEL)
          continue;
        const Run run(shipped("brick.prm"),
                      {"Geometry/Table 1 level=" + std::to_string(reference.level),
                       "Friction/Law=" + std::string(reference.law),
                       "Friction/Slip stress=1.5e7", "Contact solver/Tolerance=1e-7",
                       "Dual operator/Form=" + form,
                       "Stiffness solver/Type=" STIFFNESS_SOLVER});
        const auto &contact = run.summary()["contact"];

        double error = 0., size = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          {
            error +=
              std::pow(contact["force_on_body"][c].get<double>() - reference.force[c], 2);
            size += std::pow(reference.force[c], 2);
          }
        out() << reference.law << ", k = " << reference.level << ", " << form
              << ": certified " << yes(run.converged) << ", force to 1e-6 "
              << yes(std::sqrt(error / size) < 1e-6) << ", open/stick/slip "
              << contact["open"] << "/" << contact["stick"] << "/" << contact["slip"]
              << ", as they should be "
              << yes(contact["open"] == reference.status[0] &&
                     contact["stick"] == reference.status[1] &&
                     contact["slip"] == reference.status[2])
              << std::endl;
      }
}
