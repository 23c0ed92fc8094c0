// A ball in a socket, pressed and turned by forces inside: friction bears less than
// F P R = 23,500 N mm. Within that nothing is warned of. Beyond, facets hold it, which
// the certificate does not see, and which is said.

#include "several_bodies.h"

using namespace stiction;

namespace
{
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
    unsigned int n_facets = 0;
    for (const auto &warning : run.summary()["warnings"])
      if (warning.get<std::string>().find("until facets wedged") != std::string::npos)
        ++n_facets;
    out() << "torque of " << (moment_of_loads(run)[2] > 23500. ? "more" : "less")
          << " than friction bears: certified " << yes(run.converged)
          << ", warnings of facets " << n_facets << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string degree : {"1", "2"})
    for (const std::string M : {"0.1", "0.3"})
      check(M, {"Geometry/Element degree=" + degree});
}
