// A stiff pad on a soft slab, the pad bearing the forces, its cells larger than those of
// the slab: newton multigrid certifies it alone, with and without levels, in iterations
// that grow little with the stiffness. Smoothed by a diagonal it took several hundred,
// or factors, or came no closer.

#include "several_bodies.h"

#include <cmath>

using namespace stiction;

namespace
{
  struct Meshes
  {
    std::string of_pad, of_slab, refinement, what;
  };

  std::string pad_on_slab(const Meshes &meshes, const std::string &stiffness,
                          const Settings &friction)
  {
    const std::string straight = "0;0;0;0;0;1;0";
    return file("pad.prm",
                brick("pad", "2.4,2,1", meshes.of_pad, "1.2;1.6;1", straight, stiffness) +
                  brick("slab", "6,5,1", meshes.of_slab, "0;0;0", straight, "1") +
                  section("Boundary conditions",
                          {"Prescribed displacement = slab.bottom : 0; 0; 0",
                           "Traction = pad.top : 1e-3 * x; 0; -1e-2",
                           "Contact boundary = pad.bottom",
                           "Obstacle = boundary : slab.top", "Slave side = boundary"}) +
                  section("Friction", friction));
  }

  double strain_energy(const Run &run)
  {
    return run.summary()["energy"]["strain"].get<double>();
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto solve = [](const std::string &file, const std::string &method,
                        const std::string &refinement) {
    return Run(file, {"Contact solver/Method=" + method, "Contact solver/Tolerance=1e-8",
                      "Geometry/Global refinement=" + refinement});
  };
  for (const Meshes &meshes :
       {Meshes{"3,2,1", "10,8,1", "2", "cells half as large again"},
        Meshes{"2,2,1", "10,9,1", "2", "cells twice as large"},
        Meshes{"8,7,3", "26,23,4", "0", "no levels"}})
    for (const Settings &law :
         {Settings{"Law = coulomb", "Coefficient = 0.3"}, Settings{"Law = tied"}})
      {
        int of_equal = 0;
        for (const std::string stiffness : {"1", "1e3", "1e5"})
          {
            const bool is_tied = law.front() == "Law = tied";
            if (stiffness == "1e5" && !is_tied)
              continue;
            const std::string file = pad_on_slab(meshes, stiffness, law);
            const Run run          = solve(file, "newton multigrid", meshes.refinement);
            const int n = run.summary()["solver"]["krylov_iterations"].get<int>();
            if (of_equal == 0)
              of_equal = n;
            out() << meshes.what << ", " << law.front() << ", " << stiffness
                  << " times as stiff: certified alone " << yes(certified_alone(run))
                  << ", at most four times the iterations " << yes(n <= 4 * of_equal)
                  << std::endl;
            if (!is_alone() || stiffness != "1e3" || is_tied)
              continue;
            const double energy = strain_energy(run),
                         other  = strain_energy(solve(file, "newton", meshes.refinement));
            out() << "  as by newton " << yes(std::abs(energy - other) < 1e-6 * other)
                  << std::endl;
          }
      }
}
