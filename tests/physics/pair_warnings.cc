// What is said of pairs whose answer is certified and not what is meant. A ball in a
// socket, pressed and turned by forces inside: friction bears less than F P R =
// 23,500 N mm; beyond that facets hold it. A block that falls onto another one from as
// far as half of its size: friction has a moment then. A stiff block on a wide soft one,
// whose cells are 2.5 times as wide, or as wide as its own. A block over the joint of two
// others, one of which is drawn down: a soft block follows it, a stiff one does not.

#include "several_bodies.h"

using namespace stiction;

namespace
{
  std::string warnings(const Run &run, const std::string &words)
  {
    return std::string("certified ") + yes(run.converged) + ", warnings " +
           std::to_string(n_warnings(run, words));
  }

  // Turned by M x r in every point, with a torque of 149,880 N mm times M.
  std::string ball(const std::string &M)
  {
    const auto inside = [](const std::string &force) {
      return "if(x^2+y^2+z^2 < 100.01, " + force + ", 0)";
    };
    return file(
      "ball.prm",
      section("Body ball", {"Type = generator", "Generator = hyper_ball",
                            "Generator arguments = 0,0,0 : 10 : false", "Refinement = 2",
                            "Rotation = 0;0;0;1;2;3;25"}) +
        section("Body socket",
                {"Type = generator", "Generator = hyper_shell",
                 "Generator arguments = 0,0,0 : 10 : 16 : 6 : true", "Refinement = 2"}) +
        section("Material", {"Young's modulus = 210000", "Poisson ratio = 0.3"}) +
        section("Boundary conditions", {"Prescribed displacement = socket.1 : 0; 0; 0",
                                        "Body force = " + inside("-" + M + "*y") + "; " +
                                          inside(M + "*x") + "; " + inside("-2")}) +
        section("Contact pair joint",
                {"Boundary = ball.0", "Obstacle = boundary : socket.0",
                 "Mesh gap = removed", "Law = coulomb", "Coefficient = 0.3"}));
  }

  void check(const std::string &M, const Settings &settings)
  {
    const Run run(ball(M), settings);
    out() << "torque of " << (moment_of_loads(run)[2] > 23500. ? "more" : "less")
          << " than friction bears: " << warnings(run, "until facets wedged")
          << std::endl;
  }

  // Pressed straight down it has friction, but no moment of it.
  void fall(const std::string &height, const std::string &pressure)
  {
    const Run run(
      file("block.prm",
           brick("lower", "2,2,1", "6,6,2", "0;0;-1") +
             brick("upper", "2,2,1", "4,4,2", "0;0;" + height) +
             section("Boundary conditions",
                     {"Prescribed displacement = lower.bottom : 0; 0; 0",
                      "Traction = upper.top : " + pressure}) +
             section("Contact pair joint",
                     {"Boundary = upper.bottom", "Obstacle = boundary : lower.top",
                      "Law = coulomb", "Coefficient = 0.5"})),
      {});
    out() << "from " << height << " by " << pressure << ": "
          << warnings(run, "acts across the") << std::endl;
  }

  void press(const std::string &law, const std::string &cells)
  {
    const Run run(
      file("punch.prm",
           brick("soft", "3,3,1", cells, "0;0;-1", "0;0;0;0;0;1;0", "10") +
             brick("stiff", "1,1,0.5", "10,10,5", "0.98;1.02;0", "0;0;0;0;0;1;0", "1e4") +
             section("Boundary conditions",
                     {"Prescribed displacement = soft.bottom : 0; 0; 0 | "
                      "stiff.top : 0; 0; free",
                      "Pressure = stiff.top : 1"}) +
             section("Contact pair sole",
                     {"Boundary = stiff.bottom", "Obstacle = boundary : soft.top",
                      "Law = " + law})),
      {});
    out() << law << " on " << cells
          << " cells: " << warnings(run, "waver from node to node") << std::endl;
  }

  // A sheet under a narrow load: what is one cell of the base has the pressures of
  // several nodes, which a soft sheet has as on a rigid wall.
  void squeeze(const std::string &E)
  {
    const Run run(
      file("sheet.prm",
           brick("base", "3,3,1", "6,6,2", "0;0;-1", "0;0;0;0;0;1;0", "10") +
             brick("sheet", "1,1,0.1", "20,10,2", "0.98;1.02;0", "0;0;0;0;0;1;0", E) +
             section("Boundary conditions",
                     {"Prescribed displacement = base.bottom : 0; 0; 0 | "
                      "sheet.top : 0; 0; free",
                      "Pressure = sheet.top : 1e-3*if(abs(x-1.48)<0.1,1,0)"}) +
             section("Contact pair sole",
                     {"Boundary = sheet.bottom", "Obstacle = boundary : base.top",
                      "Slave side = boundary", "Law = frictionless"})),
      {});
    out() << "sheet with E = " << E << ": " << warnings(run, "waver from node to node")
          << std::endl;
  }

  // The nodes of the block over the joint bear where the mean of both sides is.
  void straddle(const std::string &E, const std::string &down)
  {
    const Run run(
      file("joint.prm",
           brick("left", "1,1,1", "4,4,4", "-1;0;0") +
             brick("right", "1,1,1", "4,4,4", "0;0;0") +
             brick("block", "1,1,0.5", "5,5,2", "-0.6;0;1", "0;0;0;0;0;1;0", E) +
             section("Boundary conditions",
                     {"Prescribed displacement = left.bottom : 0; 0; 0 | "
                      "right.bottom : 0; 0; -" +
                        down + " | block.left : 0; 0; free",
                      "Pressure = block.top : 1"}) +
             section("Contact pair sole", {"Boundary = block.bottom",
                                           "Obstacle = boundary : left.top, right.top",
                                           "Law = frictionless"})),
      {});
    out() << "over " << down << " with E = " << E << ": "
          << warnings(run, "over whose joint they lie") << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string degree : {"1", "2"})
    for (const std::string M : {"0.1", "0.3"})
      check(M, {"Geometry/Element degree=" + degree});
  for (const std::string height : {"0", "0.01", "0.5"})
    fall(height, "0.2; 0; -1");
  fall("0.5", "0; 0; -1");
  for (const std::string law : {"frictionless", "tied"})
    for (const std::string cells : {"12,12,4", "30,30,10"})
      press(law, cells);
  for (const std::string E : {"0.1", "10"})
    squeeze(E);
  for (const std::string down : {"0.01", "0.05"})
    straddle("30", down);
  straddle("1000", "0.05");
}
