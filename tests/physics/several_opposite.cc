// Pairs of one boundary with several opposite to it: a pad over the joint of two plates.
// Exact: a column of bodies without lateral contraction bears one pressure, each plate
// its part; two plates that are tied at their joint bear what one plate of the same cells
// does, while the pad sticks and slips. And sides of pairs of which supports hold nodes:
// the other one bears the forces, and all of friction, unless it goes on beyond the edge.

#include <stiction/contact/interface/contact_boundary.h>

#include "several_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace stiction;

namespace
{
  const Settings methods[] = {{"Contact solver/Method=newton"},
                              {"Contact solver/Method=newton multigrid"},
                              {"Contact solver/Method=admm"}};

  std::string body(const std::string &name, const std::string &lengths,
                   const std::string &subdivisions, const std::string &translation,
                   const std::string &poisson)
  {
    return section("Body " + name,
                   {"Lengths = " + lengths, "Subdivisions = " + subdivisions,
                    "Translation = " + translation, "Young's modulus = 1000",
                    "Poisson ratio = " + poisson});
  }

  // The pad's nodes are not above the joint at x = 11.
  double column(const std::string &law, const std::string &pressure,
                const Settings &method)
  {
    const Run run(
      file(
        "column.prm",
        body("left", "11,10,8", "4,3,2", "0;0;0", "0") +
          body("right", "13,10,8", "3,4,2", "11;0;0", "0") +
          body("pad", "24,10,5", "8,5,2", "0;0;8", "0") +
          section("Boundary conditions",
                  {"Prescribed displacement = left.bottom : 0;0;0 | right.bottom : 0;0;0",
                   "Pressure = pad.top : " + pressure}) +
          section("Contact pair c",
                  {"Boundary = pad.bottom", "Obstacle = boundary : left.top, right.top",
                   "Law = " + law, "Coefficient = 0.3"})),
      method + Settings{"Contact solver/Tolerance=1e-11"});
    const auto &surface = run.problem->contact_surface();
    double error        = run.converged ? 0. : 1.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      error = std::max(error, std::abs(run.problem->state().lambda(i) /
                                         surface.areas()(i) / std::stod(pressure) -
                                       1.));
    // what each plate exerts is what its supports bear
    const auto &summary = run.summary();
    for (unsigned int p = 0; p < 2; ++p)
      {
        const std::array<double, 3> of_plate =
          summary["contact"]["boundaries"][0]["of_opposite"][p]["force_on_body"];
        const std::array<double, 3> support =
          summary["reactions"]["boundaries"][p]["force"];
        const double all = std::stod(pressure) * (p == 0 ? 110. : 130.);
        error            = std::max({error, std::abs(of_plate[2] / all - 1.),
                                     std::abs(of_plate[2] - support[2]) / std::abs(all)});
      }
    return error;
  }

  // What the pad bears, pressed and dragged until much of it slips.
  std::string pad_on(const std::string &plates, const std::string &opposite,
                     const std::string &supports, const std::string &tie)
  {
    return plates + body("pad", "16,8,4", "7,3,2", "5;1;6", "0.3") +
           section("Boundary conditions",
                   {"Prescribed displacement = " + supports,
                    "Pressure = pad.top : 1 + x/10", "Traction = pad.left : 1.2;0;0"}) +
           section("Contact pair c",
                   {"Boundary = pad.bottom", "Obstacle = boundary : " + opposite,
                    "Slave side = boundary", "Law = coulomb", "Coefficient = 0.3"}) +
           tie;
  }

  void joint(const Settings &method)
  {
    const Settings settings = method + Settings{"Contact solver/Tolerance=1e-11"};
    const Run one(
      file("one.prm", pad_on(body("plate", "24,10,6", "8,5,2", "0;0;0", "0.3"),
                             "plate.top", "plate.bottom : 0;0;0", "")),
      settings);
    const Run two(
      file("two.prm",
           pad_on(body("left", "12,10,6", "4,5,2", "0;0;0", "0.3") +
                    body("right", "12,10,6", "4,5,2", "12;0;0", "0.3"),
                  "left.top, right.top", "left.bottom : 0;0;0 | right.bottom : 0;0;0",
                  section("Contact pair joint",
                          {"Boundary = left.right", "Obstacle = boundary : right.left",
                           "Law = tied"}))),
      settings);
    const auto &nodes    = two.problem->contact_surface().nodes();
    const auto &all      = one.problem->contact_surface().nodes();
    const auto &lambda   = two.problem->state().lambda,
               &expected = one.problem->state().lambda;
    double error         = 0.;
    unsigned int n       = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < all.size(); ++j)
        if (nodes[i].boundary == 0 && nodes[i].position.distance(all[j].position) < 1e-9)
          {
            ++n;
            for (unsigned int c = 0; c < 3; ++c)
              error = std::max(error, std::abs(lambda(i + c * nodes.size()) -
                                               expected(j + c * all.size())));
          }
    const auto contact = two.summary()["contact"];
    out() << "two plates: certified " << yes(one.converged && two.converged)
          << ", sticks and slips "
          << yes(contact["slip"].get<int>() > 0 && contact["stick"].get<int>() > 0)
          << ", as one plate to 1e-7 "
          << yes(n == all.size() && error < 1e-7 * expected.lpNorm<Eigen::Infinity>())
          << std::endl;
  }

  // A block that its side guides while it is dragged along another one: F N is borne.
  void guided(const std::string &name, const std::string &lower, const std::string &side)
  {
    const Run run(
      file("guided.prm",
           brick("lower", lower + ",10,5", "6,3,2", "0;0;0") +
             brick("upper", "20,10,5", "7,4,2", "0;0;5") +
             section("Boundary conditions",
                     {"Prescribed displacement = lower.bottom : 0;0;0 | "
                      "upper.left : 0.3; free; free",
                      "Pressure = upper.top : 1"}) +
             section("Contact pair c",
                     {"Boundary = upper.bottom", "Obstacle = boundary : lower.top",
                      "Law = coulomb", "Coefficient = 0.3", "Slave side = " + side})),
      {});
    const auto &surface  = run.problem->contact_surface();
    const auto &boundary = surface.boundaries().front();
    const double friction =
      std::abs(surface.forces(run.problem->state().lambda).head(surface.n_nodes()).sum());
    out() << name << ": certified " << yes(run.converged) << ", forces on "
          << boundary.name()
          << boundary.description().substr(boundary.description().rfind(','))
          << ", all of friction " << yes(std::abs(friction / (0.3 * 200.) - 1.) < 1e-5)
          << ", warnings " << n_warnings(run, "without friction in the directions")
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Settings &method : methods)
    {
      out() << "one pressure to 1e-9: pressed "
            << yes(column("coulomb", "1", method) < 1e-9) << ", glued and pulled "
            << yes(column("tied", "-1", method) < 1e-9) << std::endl;
      joint(method);
    }
  guided("equal blocks", "20", "automatic");
  guided("the guided side", "20", "boundary");
  guided("a longer one below", "30", "automatic");
}
