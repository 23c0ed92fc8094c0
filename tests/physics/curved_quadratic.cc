// Triquadratic elements on bodies with curved boundaries: all nodes lie on the
// surface, not on chords of it, and a half ball that is pressed on a plane
// agrees with finer trilinear meshes.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/numbers.h>

#include <cmath>

using namespace stiction;

namespace
{
  struct Answer
  {
    double force, pressure;
    double area_error;         // of the curved surface, relative
    double largest_off_sphere; // distance of a contact node, in radii
    bool certified;
  };

  Answer press(const unsigned int degree, const unsigned int refinement)
  {
    const Run run(
      shipped("half_ball.prm"),
      {"Geometry/Element degree=" + std::to_string(degree),
       std::string("Contact solver/Method=newton") + (degree == 1 ? " multigrid" : ""),
       "Geometry/Global refinement=" + std::to_string(refinement),
       "Boundary conditions/Prescribed displacement="
       "flat : 0; 0; -2e-2",
       "Output/Write solution=false"});
    const ContactSurface &surface = run.problem->contact_surface();
    Answer answer{};
    answer.force     = run.summary()["contact"]["force_on_body"][2].get<double>();
    answer.pressure  = run.summary()["contact"]["max_pressure"].get<double>();
    answer.certified = run.converged;
    answer.area_error =
      std::abs(surface.boundary_area() / (2. * dealii::numbers::PI) - 1.);
    const dealii::Point<3> centre(0., 0., 1.);
    for (const ContactNode &node : surface.nodes())
      answer.largest_off_sphere = std::max(answer.largest_off_sphere,
                                           std::abs(node.position.distance(centre) - 1.));
    return answer;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Answer coarse = press(2, 1), middle = press(2, 2);
  out() << "all nodes on the sphere to 1e-12 " << yes(middle.largest_off_sphere < 1e-12)
        << ", area of order four: within 1e-4 " << yes(middle.area_error < 1e-4)
        << ", a twelfth of that of cells twice as large "
        << yes(middle.area_error < coarse.area_error / 12.) << std::endl;

  const Answer trilinear = press(1, 4);
  out() << "eight times as many unknowns of trilinear elements: certified "
        << yes(middle.certified && trilinear.certified) << ", forces alike to 10 % "
        << yes(std::abs(middle.force / trilinear.force - 1.) < 0.1)
        << ", largest pressures to 25 % "
        << yes(std::abs(middle.pressure / trilinear.pressure - 1.) < 0.25) << std::endl;
}
