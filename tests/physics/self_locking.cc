// A keystone between two planes at 20 degrees, with friction beyond that angle, is
// pressed in and its load taken away, which friction holds back: what remains does not
// depend on the method, and not on the number of steps but for what these leave over. A
// method that forgets where the stone was finds it touching nothing, which is in
// equilibrium as well. Pulled by more than friction holds it with it comes out, and the
// run says by how much.

#include "several_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>

using namespace stiction;

namespace
{
  const double angle = dealii::numbers::PI / 9.;

  // One cell: 2 wide below, wider above by the angle.
  void write_mesh()
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ofstream mesh("keystone.msh");
        mesh.precision(17);
        mesh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 \"l\"\n2 2 "
                "\"r\"\n2 3 \"top\"\n$EndPhysicalNames\n$Nodes\n8\n";
        for (int i = 0; i < 8; ++i)
          {
            const double z    = i / 4;
            const double half = 1. + z * std::tan(angle);
            mesh << i + 1 << ' ' << (i % 2 == 0 ? -half : half) << ' ' << i / 2 % 2 << ' '
                 << z << '\n';
          }
        mesh
          << "$EndNodes\n$Elements\n4\n1 3 2 1 1 1 3 7 5\n2 3 2 2 2 2 4 8 6\n3 3 2 3 3 "
             "5 6 8 7\n4 5 2 9 9 1 2 4 3 5 6 8 7\n$EndElements\n";
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }

  const std::string problem = R"(
subsection Geometry
  set Mesh file         = keystone.msh
  set Global refinement = 2
end
subsection Material
  set Young's modulus = 1e9
  set Poisson ratio   = 0
end
subsection Boundary conditions
  set Traction = top : 0; 0; -1000*(1 - max(t - 1, 0))
end
subsection Contact pair L
  set Boundary    = l
  set Obstacle    = plane : -1; 0; 0; 0.9396926207859083; 0; 0.34202014332566877
  set Law         = coulomb
  set Coefficient = 0.5
end
subsection Contact pair R
  set Boundary    = r
  set Obstacle    = plane : 1; 0; 0; -0.9396926207859083; 0; 0.34202014332566877
  set Law         = coulomb
  set Coefficient = 0.5
end
)";

  // A taper of degree 2 between planes at atan(1/10), which in displacements alone came
  // out.
  std::string taper(const std::string &F)
  {
    std::string text =
      section("Geometry",
              {"Lengths = 1, 1, 2", "Subdivisions = 6, 6, 12", "Element degree = 2"}) +
      section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
      section("Boundary conditions", {"Prescribed displacement = front : free; 0; free",
                                      "Pressure = top : if(t < 1.5, 1, 0)"}) +
      section("Time", {"End = 2", "Steps = 1, 2"});
    for (const auto &[side, plane] :
         {std::array<std::string, 2>{"left", "0; 0; 0; 0.99503719; 0; 0.099503719"},
          {"right", "1; 0; 0; -0.99503719; 0; 0.099503719"}})
      text +=
        section("Contact pair " + side,
                {"Boundary = " + side, "Obstacle = plane : " + plane,
                 "Initial gap = 0.0995037*z", "Law = coulomb", "Coefficient = " + F});
    return text;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  write_mesh();
  const std::string keystone = file("keystone.prm", problem);

  for (const std::string steps : {"1, 2", "1, 1.5, 2", "1, 1.25, 1.5, 1.75, 2"})
    {
      double least = 1e300, most = 0.;
      bool certified = true;
      for (const std::string method : {"newton", "newton multigrid", "automatic"})
        {
          const Run run(keystone,
                        {"Time/Steps=" + steps, "Contact solver/Method=" + method});
          const double N = run.summary()["contact"]["normal_force"];
          certified      = certified && run.converged;
          least          = std::min(least, N);
          most           = std::max(most, N);
        }
      out() << "steps to t = " << steps << ": certified " << yes(certified)
            << ", the same by all methods to 1e-5 " << yes(most - least < 1e-5 * most)
            << ", held with some 2 kN " << yes(std::abs(least / 2000. - 1.) < 0.05)
            << std::endl;
    }

  // the planes bear N (F cos 20° - sin 20°) against a pull
  const Run held(keystone, {"Time/Steps=1, 2"});
  const double N     = held.summary()["contact"]["normal_force"];
  const double bears = N * (0.5 * std::cos(angle) - std::sin(angle));
  for (const std::string pull : {"80", "110"})
    {
      const Run run(keystone, {"Time/Steps=1, 2, 3",
                               "Boundary conditions/Traction=top : 0; 0; if(t < 1.5, "
                               "-1000, if(t < 2.5, 0, " +
                                 pull + "))"});
      const std::string text = run.summary()["reason"];
      const std::string told = "moves away along (0, 0, 1), where the loads push with";
      out() << "pulled with " << pull << " Pa: certified " << yes(run.converged);
      if (const auto place = text.find("contact bears "); place != std::string::npos)
        out() << ", out " << yes(text.find(told) != std::string::npos)
              << ", bears N (F cos - sin) to 1e-3 "
              << yes(std::abs(std::stod(text.substr(place + 14)) / bears - 1.) < 1e-3);
      out() << std::endl;
    }

  for (const std::string F : {"0.17", "0.09"})
    {
      const std::string prm = file("taper.prm", taper(F));
      const Run run(prm, {"Contact solver/Method=newton multigrid"}),
        newton(prm, {"Contact solver/Method=newton"});
      const auto is_held = [](const Run &of) {
        return of.summary()["contact"]["normal_force"].get<double>() > 1.;
      };
      out() << "taper with F = " << F << ": certified " << yes(run.converged) << ", held "
            << yes(is_held(run)) << ", as by newton to 1e-4 "
            << yes(is_held(run) ? distance(run, newton) < 1e-4 : !is_held(newton))
            << std::endl;
    }
}
