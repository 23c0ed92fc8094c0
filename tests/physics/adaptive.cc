// Adaptive refinement of the reference brick under a load on a small part of
// its top. Without friction the displacement minimises the potential energy
// ½ u·Ku − f·u, on the foundation exactly so on every mesh that has lines
// around the load: the less energy, the smaller the error in the energy norm.
// So two meshes are compared without a third: the adapted one must have less
// energy than a uniform one with more than twice as many unknowns.
//
// Then the reference brick itself with Coulomb friction: a method for contact
// forces and one for displacements, on any number of ranks, cut the same cells
// and agree.

#include "tests.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace stiction;

namespace
{
  Run solve(std::vector<std::string> settings)
  {
    settings.insert(settings.end(),
                    {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                     "Geometry/Subdivisions=4,3,1",
                     "Boundary conditions/Traction=top : 0; 0; if(abs(x - 2) < "
                     "0.25 && abs(y - 1.5) < 0.25, -1e9, 0)",
                     "Friction/Law=frictionless",
                     "Contact solver/Method=newton multigrid",
                     "Contact solver/Tolerance=1e-9"});
    return Run(shipped("brick.prm"), settings);
  }

  // The same cells are cut on any number of ranks.
  void print_meshes(const Run &run)
  {
    double last = 0.;
    for (const auto &mesh : run.summary()["refinement"])
      {
        const double error = mesh["relative_estimated_error"];
        out() << "  " << mesh["cells"] << " cells, " << mesh["dofs"] << " unknowns, "
              << mesh["contact_nodes"] << " contact nodes, estimate falls "
              << yes(last == 0. || error < last) << '\n';
        last = error;
      }
  }

  double potential_energy(const Run &run)
  {
    const auto &energy = run.summary()["energy"];
    return energy["strain"].get<double>() - energy["load_work"].get<double>();
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Run uniform = solve({"Geometry/Global refinement=3"});
  const Run adapted =
    solve({"Geometry/Global refinement=2", "Refinement/Adaptive steps=3"});
  const double n_uniform = uniform.summary()["problem"]["dofs"];
  const double n_adapted = adapted.summary()["problem"]["dofs"];
  out() << "uniform mesh certified " << yes(uniform.converged)
        << ", adapted mesh certified " << yes(adapted.converged)
        << "\nless energy with less than half the unknowns "
        << yes(potential_energy(adapted) < potential_energy(uniform) &&
               n_adapted < 0.5 * n_uniform)
        << '\n';

  print_meshes(adapted);

  std::vector<double> force;
  for (const std::string method : {"newton", "newton multigrid"})
    {
      const Run run(shipped("adaptive.prm"),
                    {"Refinement/Adaptive steps=3", "Contact solver/Method=" + method,
                     "Contact solver/Tolerance=1e-10"});
      out() << method << ": certified " << yes(run.converged);
      const std::vector<double> this_force = run.summary()["contact"]["force_on_body"];
      if (force.empty())
        force = this_force;
      double difference = 0.;
      for (unsigned int c = 0; c < 3; ++c)
        difference = std::max(difference, std::abs(this_force[c] - force[c]));
      out() << ", agrees to 1e-8 " << yes(difference < 1e-8 * std::abs(force[2])) << '\n';
      print_meshes(run);
    }
}
