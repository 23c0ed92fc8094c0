// The patch tests on trilinear elements: stick and slip, both laws of friction,
// directions of shear that are no axis.

#include "patch_test.h"

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"gauss seidel", "newton multigrid"})
    for (const std::string law : {"given", "coulomb"})
      for (const double degrees : {0., 30., 90., 137., 250.})
        for (const std::string ending : {"stick", "slip"})
          {
            const Patch patch = solve_patch(
              {"Geometry/Subdivisions=3,2,2", "Geometry/Global refinement=1",
               "Contact solver/Method=" + method, "Contact solver/Tolerance=1e-11"},
              law, ending, ending == "stick" ? 3e-5 : 2e-4, degrees);
            out() << method << ", " << law << ", " << degrees << " degrees, expected to "
                  << ending << ": certified " << yes(patch.certified) << ", all nodes "
                  << ending << " " << yes(patch.ends_as_expected)
                  << ", displacement exact to 1e-8 "
                  << yes(patch.displacement_error < 1e-8)
                  << ", contact forces exact to 1e-8 " << yes(patch.force_error < 1e-8)
                  << std::endl;
          }
}
