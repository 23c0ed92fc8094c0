// Smaller cells at the contact boundary alone: a half ball on a plane. Where
// they end too near below the surface, the large cells show in the pressure.

#include "tests.h"

#include <cmath>

using namespace stiction;

namespace
{
  struct Answer
  {
    double force, at_centre, largest;
  };

  Answer press(const Settings &mesh)
  {
    const Run run(shipped("half_ball.prm"),
                  Settings{"Geometry/Global refinement=3",
                           "Boundary conditions/Prescribed displacement="
                           "flat : 0; 0; -2e-2",
                           "Friction/Law=frictionless", "Output/Write solution=false"} +
                    mesh);
    const ContactSurface &surface = run.problem->contact_surface();
    const auto &lambda            = run.problem->certificate().lambda();
    Answer answer{run.summary()["contact"]["force_on_body"][2].get<double>(), 0., 0.};
    double nearest = 1.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        const double pressure   = lambda(i) / node.area;
        const double distance   = node.position.norm();
        answer.largest          = std::max(answer.largest, pressure);
        if (distance < nearest)
          {
            nearest          = distance;
            answer.at_centre = pressure;
          }
      }
    return answer;
  }

  Settings refined(const unsigned int steps)
  {
    return {"Geometry/Contact refinement=" + std::to_string(steps),
            "Geometry/Contact refinement where=0.1 - z"};
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const Answer uniform = press({"Geometry/Global refinement=4"});
  const Answer once = press(refined(1)), twice = press(refined(2));
  out() << "refined once: pressure at the centre to 1 % that of a uniform mesh "
           "with cells as small "
        << yes(std::abs(once.at_centre / uniform.at_centre - 1.) < 0.01)
        << ", force to 1 % " << yes(std::abs(once.force / uniform.force - 1.) < 0.01)
        << std::endl;
  out() << "refined twice: the largest pressure is at the centre "
        << yes(twice.at_centre > (1. - 1e-6) * twice.largest) << std::endl;
}
