// What is said where bodies move farther than linear kinematics goes: along an obstacle
// that is another one there, off the end of another body within a history, by a tenth of
// the friction angle where contact alone holds them. Friction that pairs lack at held
// nodes, whichever side moves; none beside planes of symmetry, and none of ties. A free
// ring whose slit is a contact has nothing that balances its loads.

#include "how_it_ends.h"
#include "several_bodies.h"

#include <cmath>
#include <fstream>

using namespace stiction;

namespace
{
  void warned(const std::string &name, const std::string &prm, const std::string &words,
              const Settings &settings = {})
  {
    const Run run(file("moved.prm", prm), settings);
    out() << name << ": certified " << yes(run.converged) << ", warnings "
          << n_warnings(run, words) << std::endl;
  }

  // @param twist of the body about the z axis.
  void dragged(const std::string &obstacle, const std::string &way,
               const std::string &twist = "0")
  {
    warned(obstacle + " dragged by " + way + ", twisted by " + twist,
           section("Geometry", {"Lengths = 40,20,10", "Subdivisions = 20,10,4"}) +
             section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
             section(
               "Boundary conditions",
               {"Prescribed displacement = bottom : -" + twist + "*y; " + twist + "*x; 0",
                "Contact boundary = top", "Obstacle = " + obstacle, "Initial gap = -0.1",
                "Obstacle displacement = " + way + "; 0; 0"}) +
             section("Friction", {"Law = coulomb", "Coefficient = 0.2"}),
           "'Sliding = far' takes");
  }

  // A shell on a ball. Normals stay with what turns, unless they are taken anew.
  void turned(const std::string &sliding, const std::string &angle,
              const std::string &words)
  {
    warned(
      sliding + " sliding, turned by " + angle + ", " + words,
      section("Geometry", {"Type = generator", "Generator = hyper_shell",
                           "Generator arguments = 0,0,0 : 10 : 14 : 6 : true",
                           "Global refinement = 2"}) +
        section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
        section("Boundary conditions",
                {"Prescribed displacement = 1 : -" + angle + "*y; " + angle + "*x; 0",
                 "Contact boundary = 0", "Obstacle = sphere : 0; 0; 0; 10",
                 "Initial gap = -0.05", "Sliding = " + sliding}) +
        section("Friction", {"Law = coulomb", "Coefficient = 0.2"}),
      words);
  }

  std::string blocks(const std::string &lower, const std::string &upper,
                     const std::string &supports, const std::string &pair)
  {
    return brick("lower", lower + ",10,5", "12,4,2", "0;0;0") +
           brick("upper", upper + ",10,5", "10,5,2", "0;0;5") +
           section("Boundary conditions", {"Prescribed displacement = " + supports,
                                           "Pressure = upper.top : 1"}) +
           section("Contact pair c",
                   {"Boundary = upper.bottom", "Obstacle = boundary : lower.top",
                    "Coefficient = 0.3", pair});
  }

  void out_and_back(const std::string &end, const std::string &words)
  {
    warned("out and back until t = " + end + ", " + words,
           blocks("30", "20",
                  "lower.bottom : 0; 0; 0 | upper.top : 30*(1-abs(t-1)); 0; free",
                  "Law = coulomb") +
             section("Time", {"Steps = " + std::string(end == "1" ? "0.5,1" : "1,2")}),
           words);
  }

  // Eight bricks around the z axis that are one body, with a slit of no width at y = 0.
  void slit_ring(const std::string &force)
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ofstream mesh("ring.msh");
        mesh.precision(17);
        mesh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"one\"\n"
                "2 2 \"other\"\n$EndPhysicalNames\n$Nodes\n36\n";
        for (int k = 0; k < 9; ++k)
          for (int i = 0; i < 4; ++i)
            {
              const double angle = k * dealii::numbers::PI / 4., r = i % 2 == 0 ? 2. : 3.;
              mesh << 4 * k + i + 1 << ' ' << r * std::cos(angle) << ' '
                   << (k % 8 == 0 ? 0. : r * std::sin(angle)) << ' ' << i / 2 << '\n';
            }
        mesh << "$EndNodes\n$Elements\n10\n1 3 2 1 1 1 2 4 3\n2 3 2 2 2 33 34 36 35\n";
        for (int k = 0; k < 8; ++k)
          {
            mesh << k + 3 << " 5 2 3 3";
            for (const int section : {4 * k, 4 * k + 4})
              for (const int i : {1, 2, 4, 3})
                mesh << ' ' << section + i;
            mesh << '\n';
          }
        mesh << "$EndElements\n";
      }
    MPI_Barrier(MPI_COMM_WORLD);
    out() << "a slit ring under a force of " << force << ": "
          << how_it_ends(file(
               "ring.prm",
               section("Geometry", {"Mesh file = ring.msh"}) +
                 section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
                 section("Boundary conditions", {"Body force = " + force + "; 0; 0"}) +
                 section("Contact pair slit",
                         {"Boundary = one", "Obstacle = boundary : other",
                          "Law = coulomb", "Coefficient = 0.2"})))
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  dragged("sphere : 15;10;60;50", "0.3");
  dragged("sphere : 15;10;60;50", "5");
  dragged("plane : 0;0;10;0;0;-1", "5");
  dragged("sphere : 15;10;60;50", "5", "0.021");

  out_and_back("1", "from where they were");
  out_and_back("2", "at t = 1: nodes of 'upper.bottom' are");

  turned("far", "0.03", "of the friction angle");
  warned("twisted on a plane with far sliding",
         section("Geometry", {"Lengths = 40,20,10", "Subdivisions = 20,10,4"}) +
           section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
           section("Boundary conditions",
                   {"Prescribed displacement = bottom : -0.03*y; 0.03*x; 0",
                    "Contact boundary = top", "Obstacle = plane : 0;0;10;0;0;-1",
                    "Initial gap = -0.1", "Sliding = far"}) +
           section("Friction", {"Law = coulomb", "Coefficient = 0.2"}),
         "of the friction angle");
  turned("little", "0.6", "is no better");

  const std::string lacks = "without friction in the directions",
                    held  = "upper.left : 0;free;free | upper.right : 0;free;free",
                    way   = " | lower.bottom : 0.1;0;0";
  warned("held while the other body moves",
         blocks("30", "20", held + way, "Law = coulomb"), lacks);
  warned("held across the larger slip",
         blocks("30", "20", held + " | lower.bottom : 0.05;0.1;0", "Law = coulomb"),
         lacks);
  warned("and tied",
         blocks("20", "20",
                held + " | lower.left : 0;free;free | lower.right : "
                       "0;free;free | lower.bottom : free;0;0",
                "Law = tied"),
         lacks);
  warned("beside a plane of symmetry",
         blocks("30", "20",
                "upper.left : 0;free;free | lower.left : 0;free;free | "
                "lower.bottom : free;0;0",
                "Law = coulomb"),
         lacks);

  for (const std::string E : {"1000", "10"})
    warned("tilted on E = " + E,
           brick("lower", "20,10,5", "8,4,2", "0;0;0", "0;0;0;0;0;1;0", E) +
             brick("upper", "20,10,5", "10,5,2", "0;0;5") +
             section("Boundary conditions",
                     {"Prescribed displacement = lower.bottom : 0; 0; 0",
                      "Pressure = upper.top : 0.8*x/20"}) +
             section("Contact pair c",
                     {"Boundary = upper.bottom", "Obstacle = boundary : lower.top",
                      "Law = coulomb", "Coefficient = 0.1"}),
           "of the friction angle");
  slit_ring("1");
}
