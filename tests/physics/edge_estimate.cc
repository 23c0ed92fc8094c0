// The estimated error where forces of a pair act on a side that ends beyond the other:
// there a strip of a cell has the force of a node, and pressures as high as it is narrow.
// A brick is pressed on a larger one, either side bearing the forces, in elements of
// either degree, with edges anywhere and a thousandth beyond a line of nodes. Without
// friction the square of the error is what the strain energy lacks beside a fine mesh.

#include "several_bodies.h"

#include <cmath>

using namespace stiction;

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string turn = "0;0;0;0;0;1;0";
  const auto pad         = [&](const std::string &sizes, const std::string &place) {
    return file("pad.prm", brick("low", "40,40,20", "4,4,2", "0;0;0", turn, "210000") +
                                     brick("up", sizes, "3,3,2", place, turn, "210000") +
                                     section("Boundary conditions",
                                             {"Prescribed displacement = low.bottom : 0; 0; 0",
                                      "Pressure = up.top : 100"}) +
                                     section("Contact pair p", {"Boundary = up.bottom",
                                                        "Obstacle = boundary : low.top",
                                                        "Law = frictionless"}));
  };
  const auto energy = [](const Run &run) {
    return run.summary()["energy"]["strain"].get<double>();
  };
  for (const auto &[sizes, place] :
       {std::pair("21,21,10", "9.3;9.3;20"), {"20.002,20.002,10", "9.999;9.999;20"}})
    {
      const std::string file = pad(sizes, place);
      const Run fine(file, {"Geometry/Global refinement=2", "Geometry/Element degree=2",
                            "Refinement/Estimate error=false"});
      for (const std::string degree : {"1", "2"})
        for (const std::string side : {"boundary", "obstacle"})
          for (const std::string steps : {"0", "1", "3"})
            {
              if (degree == "2" && steps == "3")
                continue; // as good as the fine mesh
              const Run run(file, {"Contact pair p/Slave side=" + side,
                                   "Geometry/Element degree=" + degree,
                                   "Refinement/Adaptive steps=" + steps});
              const double error = std::sqrt(1. - energy(run) / energy(fine)),
                           estimate =
                             run.summary()["mesh_error"]["relative_energy_error"];
              out() << "degree " << degree << ", " << side << ", " << steps
                    << " adaptive steps: certified " << yes(run.converged)
                    << ", estimate between 0.6 and 1.7 of the error "
                    << yes(estimate > 0.6 * error && estimate < 1.7 * error) << std::endl;
            }
    }
}
