// A ball in a liner without friction, or with hardly any: nothing but normals that are
// not quite across resists where it turns, about each axis. Newton steps in displacements
// find the turn, on coarse levels, where it is another one, and on the mesh itself.

#include "several_bodies.h"

using namespace stiction;

namespace
{
  const std::string problem = R"(
subsection Geometry
  set Element degree = 2
end
subsection Body ball
  set Type                = generator
  set Generator           = hyper_ball_balanced
  set Generator arguments = 0, 0, 0 : 22
  set Refinement          = 1
  set Young's modulus     = 2e5
  set Poisson ratio       = 0.3
end
subsection Body liner
  set Type                = generator
  set Generator           = hyper_shell
  set Generator arguments = 0, 0, 0 : 22 : 26 : 6 : true
  set Rotation            = 0; 0; 0; 1; 1; 0; 17
  set Refinement          = 2
  set Young's modulus     = 50
  set Poisson ratio       = 0.3
end
subsection Boundary conditions
  set Prescribed displacement = liner.1 : 0; 0; 0
  set Body force              = 0.01; 0; -0.033
end
subsection Contact pair joint
  set Boundary = ball.0
  set Obstacle = boundary : liner.0
  set Law      = frictionless
end
)";
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string ball = file("ball.prm", problem);
  for (const std::string coefficient : {"0", "0.001"})
    {
      const Settings friction = {"Contact pair joint/Law=coulomb",
                                 "Contact pair joint/Coefficient=" + coefficient};
      const Run run(ball, friction);
      const Run dual(ball, friction + Settings{"Contact solver/Method=newton"});
      const auto &solver = run.summary()["solver"];
      int steps          = 0;
      for (const auto &level : solver["levels"])
        steps += level["newton_steps"].get<int>();
      out() << "F = " << coefficient << ": certified " << yes(run.converged)
            << ", in at most 10 steps on all levels " << yes(steps <= 10)
            << ", forces of the dual method to 1e-4 " << yes(distance(run, dual) < 1e-4)
            << std::endl;
    }
}
