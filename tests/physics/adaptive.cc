// Adaptive refinement of the reference brick, whose solution has singularities
// at the rim of the clamped face and where the load ends. Without friction the
// displacement minimises the potential energy ½ u·Ku − f·u, on the foundation
// exactly so on every mesh, and the less energy, the smaller the error in the
// energy norm. So two meshes are compared without a third: the adapted one
// with less energy must have at most half as many unknowns.

#include "tests.h"

#include <string>

using namespace stiction;

namespace
{
  const std::vector<std::string> problem = {"Geometry/Table 1 level=0",
                                            "Friction/Law=frictionless",
                                            "Contact solver/Method=newton",
                                            "Contact solver/Tolerance=1e-9"};

  Run
  solve(std::vector<std::string> settings)
  {
    settings.insert(settings.begin(), problem.begin(), problem.end());
    return Run(shipped("brick.prm"), settings);
  }

  double
  potential_energy(const Run &run)
  {
    const auto &energy = run.summary()["energy"];
    return energy["strain"].get<double>() - energy["load_work"].get<double>();
  }
} // namespace



int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Run uniform =
    solve({"Geometry/Subdivisions=4,3,1", "Geometry/Global refinement=3"});
  const double n_uniform = uniform.summary()["problem"]["dofs"];
  const Run adapted =
    solve({"Geometry/Subdivisions=4,3,1",
           "Geometry/Global refinement=1",
           "Refinement/Adaptive steps=20",
           "Refinement/Maximum unknowns=" +
             std::to_string(static_cast<int>(n_uniform) / 2)});
  const auto &meshes     = adapted.summary()["refinement"];
  const double n_adapted = meshes.back()["dofs"];
  out() << "uniform mesh certified " << yes(uniform.converged)
        << ", adapted mesh certified " << yes(adapted.converged)
        << "\nless energy with at most half the unknowns "
        << yes(potential_energy(adapted) < potential_energy(uniform) &&
               n_adapted <= 0.5 * n_uniform)
        << std::endl;
  for (const auto &mesh : meshes)
    std::cout << mesh << std::endl;
  std::cout << n_uniform << " " << potential_energy(adapted) << " "
            << potential_energy(uniform) << std::endl;
}
