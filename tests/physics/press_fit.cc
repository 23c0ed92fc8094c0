// A ring that is shrunk onto a hollow shaft, both of facets that do not match, turned by
// a traction: exact, it bears the coefficient of friction times the normal forces times
// the radius, and no more. Nothing holds it up to there but friction, beyond nothing
// does. Without supports a torque that another one does not balance is refused before
// anything is solved.

#include "how_it_ends.h"
#include "several_bodies.h"

#include <cmath>

using namespace stiction;

namespace
{
  constexpr double radius = 20., friction = 0.15;

  // A tube around z of two layers of cells both ways, with the surfaces inside and
  // outside.
  void write_tube(const std::string &name, const double inner, const double outer,
                  const unsigned int n)
  {
    std::ostringstream nodes, cells;
    nodes.precision(17);
    const auto node = [&](const unsigned int i, const unsigned int j,
                          const unsigned int k) { return 1 + j % n + n * (i + 3 * k); };
    std::string inside, outside;
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const double r = inner + (outer - inner) * i / 2.,
                         a = 4. * std::acos(0.) * j / n;
            nodes << node(i, j, k) << ", " << r * std::cos(a) << ", " << r * std::sin(a)
                  << ", " << 5. * k << '\n';
            if (i == 2 || k == 2)
              continue;
            const unsigned int cell = node(i, j, k);
            cells << cell;
            for (const unsigned int top : {0, 1})
              cells << ", " << node(i, j, k + top) << ", " << node(i + 1, j, k + top)
                    << ", " << node(i + 1, j + 1, k + top) << ", "
                    << node(i, j + 1, k + top);
            cells << '\n';
            (i == 0 ? inside : outside) +=
              std::to_string(cell) + (i == 0 ? ", S6\n" : ", S4\n");
          }
    file(name + ".inp", "*NODE\n" + nodes.str() + "*ELEMENT, TYPE=C3D8\n" + cells.str() +
                          "*SURFACE, NAME=inside\n" + inside +
                          "*SURFACE, NAME=outside\n" + outside);
  }

  // Turned by tractions of the given size at the circumference of the ring and the
  // shaft, which are held at the shaft if that is zero.
  std::string fit(const double on_ring, const double on_shaft = 0.)
  {
    write_tube("shaft", 10., radius, 16);
    write_tube("ring", radius, 40., 20);
    const auto body = [](const std::string &name) {
      return section("Body " + name, {"Mesh file = " + name + ".inp",
                                      "Young's modulus = 210000", "Poisson ratio = 0.3"});
    };
    const auto turning = [](const std::string &where, const double r, const double size) {
      const std::string factor = exact(size / r);
      return where + " : -(" + factor + ")*y; (" + factor + ")*x; 0";
    };
    const std::string torque = "Traction = " + turning("ring.outside", 40., on_ring);
    return file(
      "fit.prm",
      body("shaft") + body("ring") +
        section("Contact pair fit",
                {"Boundary = ring.inside", "Obstacle = boundary : shaft.outside",
                 "Mesh gap = removed", "Initial gap = -0.01", "Law = coulomb",
                 "Coefficient = " + exact(friction)}) +
        section("Boundary conditions",
                on_shaft == 0.
                  ? std::vector<std::string>{torque, "Prescribed displacement = "
                                                     "shaft.inside : 0; 0; 0"}
                  : std::vector<std::string>{torque + " | " +
                                             turning("shaft.inside", 10., on_shaft)}) +
        section("Contact solver", {"Tolerance = 1e-8"}));
  }

  void check(const std::string &what, const Settings &settings)
  {
    const Run light(fit(0.1), settings);
    const auto &surface = light.problem->contact_surface();
    const double normal = light.problem->state().lambda.head(surface.n_nodes()).sum();
    const double limit  = 0.1 * friction * normal * radius / moment_of_loads(light)[2];
    out() << what << ": 99 % of the limit " << how_it_ends(fit(0.99 * limit), settings)
          << ", 101 % " << how_it_ends(fit(1.01 * limit), settings) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string method : {"newton multigrid", "newton"})
    check(method, {"Contact solver/Method=" + method});
  check("shaft bears the forces", {"Contact pair fit/Slave side=obstacle"});
  const std::string ends = how_it_ends(fit(0.1, -2.));
  out() << "torques that differ are refused "
        << yes(ends.find("no equilibrium exists") == 0) << std::endl;
}
