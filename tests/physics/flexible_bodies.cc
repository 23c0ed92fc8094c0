// Bodies far softer against bending than their nodes are, where Newton steps in
// displacements go astray and the interior point method takes over.
//
// A strip of weight q a length lies on a plane and is lifted at its end by P. As a beam
// it leaves the plane over the length a = 2P/q, and its end rises by q a⁴/(24 E I):
// without Poisson's ratio the strip is that beam but for (thickness/a)². A plate on a
// floor bends up around a ball that is pressed into its middle, and has the forces that
// the dual method finds. So has a sheet of degree 2 of which an elastic holder clamps a
// part, and what pulls it is what both sides of it bear.

#include "several_bodies.h"

#include <cmath>

using namespace stiction;

namespace
{
  const std::string block = shipped("block_on_slope.prm");

  // What a run in displacements says of how it went.
  std::string way(const Run &run)
  {
    const auto &solver = run.summary()["solver"];
    return std::string("certified ") + yes(run.converged) +
           ", by the interior point method alone " +
           yes(solver["interior_point_steps"].get<int>() > 0 &&
               !solver.contains("handed_over_to"));
  }

  // q = 8.1e-3 N/mm, P = 0.243 N on the end of 4 mm x 0.5 mm: a = 60 mm.
  void lift_strip(const std::string &subdivisions, const std::string &method)
  {
    const Run run(block,
                  {"Geometry/Lengths=100,4,0.5", "Geometry/Subdivisions=" + subdivisions,
                   "Geometry/Global refinement=0", "Geometry/Element degree=2",
                   "Material/Young's modulus=210000", "Material/Poisson ratio=0",
                   "Material/Density=1", "Boundary conditions/Gravity=0; 0; -4.05e-3",
                   "Boundary conditions/Traction=right : 0; 0; 0.1215",
                   "Contact solver/Tolerance=1e-6", "Contact solver/Method=" + method});
    const double E_I   = 210000. * 4. * std::pow(0.5, 3) / 12.;
    const double rise  = 8.1e-3 * std::pow(60., 4) / (24. * E_I);
    const double found = run.summary()["displacement"]["max"];
    out() << "strip, " + subdivisions + " cells, " + method + ": " << way(run)
          << ", rises as a beam to 0.1 % " << yes(std::abs(found / rise - 1.) < 1e-3)
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  lift_strip("50,2,1", "newton multigrid");
  if (is_alone())
    {
      lift_strip("100,2,1", "newton multigrid");
      lift_strip("50,2,1", "newton");
    }

  const Settings plate = {
    "Geometry/Lengths=60,60,3",
    "Geometry/Subdivisions=15,15,1",
    "Geometry/Global refinement=0",
    "Material/Young's modulus=70000",
    "Material/Density=0",
    "Boundary conditions/Gravity=",
    "Boundary conditions/Prescribed displacement=left : 0; free; free | front : free; "
    "0; free",
    "Boundary conditions/Contact boundary=top | bottom",
    "Boundary conditions/Obstacle=sphere : 0; 0; 53; 50 | foundation",
    "Boundary conditions/Obstacle force=0; 0; -500 | 0; 0; 0",
    "Contact solver/Tolerance=1e-7"};
  const Run run(block, plate + Settings{"Contact solver/Method=newton multigrid"});
  const Run reference(block, plate + Settings{"Contact solver/Method=newton"});
  out() << "plate: " << way(run) << ", the forces of the dual method to 1e-4 "
        << yes(distance(run, reference) < 1e-4) << std::endl;

  // pulled by 10 MPa on 40 mm x 0.5 mm
  const std::string sheet = file(
    "sheet.prm",
    brick("sheet", "100,40,0.5", "10,4,1", "0;0;0", "0;0;0;0;0;1;0", "70000") +
      brick("holder", "60,40,10", "5,3,1", "0;0;0.5", "0;0;0;0;0;1;0", "210000") +
      section("Geometry", {"Element degree = 2"}) +
      section("Boundary conditions",
              {"Prescribed displacement = holder.left : 0; 0; free",
               "Pressure = holder.top : 2", "Traction = sheet.right : 10; 0; 0"}) +
      section("Contact pair die", {"Boundary = sheet.bottom", "Obstacle = foundation",
                                   "Law = coulomb", "Coefficient = 0.1"}) +
      section("Contact pair holder",
              {"Boundary = sheet.top", "Obstacle = boundary : holder.bottom",
               "Law = coulomb", "Coefficient = 0.12"}));
  const Run clamped(sheet, {"Contact solver/Method=newton multigrid"});
  const Run by_newton(sheet, {"Contact solver/Method=newton"});
  const auto &boundaries = clamped.summary()["contact"]["boundaries"];
  const double die       = boundaries[0]["force_on_body"][0],
               holder    = boundaries[1]["force_on_body"][0];
  out() << "sheet: " << way(clamped) << ", pulled by what bears it "
        << yes(std::abs(200. + die - holder) < 1e-3 && die < -200.)
        << ", the forces of the dual method to 1e-4 "
        << yes(distance(clamped, by_newton) < 1e-4) << std::endl;
}
