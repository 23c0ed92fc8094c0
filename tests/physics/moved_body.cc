// A body that its supports move as a whole, far along the foundation and a
// little into it: before there are contact forces it has neither load nor
// strain, so no scale but rounding. Every method but ADMM (slow here, and it
// says so) is certified in few products, on any number of ranks, also where
// the body is one cell thick and nothing is left to eliminate.

#include "tests.h"

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string cells : {"1,1,1", "2,2,1", "2,2,2"})
    for (const std::string law : {"given", "coulomb", "frictionless"})
      for (const std::string method :
           {"gauss seidel", "newton", "mpgp", "newton multigrid"})
        {
          const Run run(shipped("brick_given_friction.prm"),
                        {"Geometry/Table 1 level=0", "Geometry/Lengths=1,1,0.5",
                         "Geometry/Subdivisions=" + cells, "Geometry/Global refinement=0",
                         "Boundary conditions/Traction=",
                         "Boundary conditions/Prescribed displacement=5 : 0.1; "
                         "0; -1e-4",
                         "Friction/Law=" + law, "Friction/Coefficient=0.3",
                         "Contact solver/Method=" + method});
          const auto &solver  = run.summary()["solver"];
          const auto &contact = run.summary()["contact"];
          const auto m        = run.problem->contact_surface().n_nodes();
          out() << cells << ", " << law << ", " << method << ": certified "
                << yes(run.converged) << ", all nodes closed "
                << yes(contact["closed"] == m) << ", all with friction slip "
                << yes(contact["slip"] == (law == "frictionless" ? 0 : m) &&
                       contact["stick"] == 0 && contact["undecided_tangential"] == 0)
                << ", in at most 150 products "
                << yes(solver["dual_multiplications"].get<double>() < 150.) << std::endl;
        }
}
