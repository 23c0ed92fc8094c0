// Pairs on round surfaces whose facets do not match: an inner and an outer sector of a
// tube, pressed on one another from inside and turned by tractions. Exact: what holds the
// outer one takes up the whole moment of the loads, and contact forces stay as they are
// where it is turned as a whole. With ties and with friction, either side the slave, with
// a gap between the surfaces, of degree 2, of tetrahedra, on levels, by the methods
// for pairs.

#include "cut_block_file.h"
#include "several_bodies.h"

#include <cmath>

using namespace stiction;

namespace
{
  // A quarter of a tube; left is inside, right is outside.
  void write_sector(const std::string &name, const double inner, const double outer,
                    const unsigned int n_facets, const char kind,
                    const unsigned int order)
  {
    CutBlockFile(
      {{2, n_facets, 2}}, [&](const auto &) { return kind; },
      [&](const dealii::Point<3> &q) {
        const double r = inner + (outer - inner) * q[0], phi = std::acos(0.) * q[1];
        return dealii::Point<3>(r * std::cos(phi), r * std::sin(phi), 8. * q[2]);
      },
      order)
      .write(name + ".msh");
  }

  struct Problem
  {
    std::string law    = "coulomb";
    double between     = 0.; // the surfaces
    char kind          = 'h';
    unsigned int order = 1;
    Settings settings  = {};
  };

  Run solve(const Problem &problem, const bool is_turned)
  {
    write_sector("inner", 10., 20., 7, problem.kind, problem.order);
    write_sector("outer", 20. + problem.between, 30., 5, problem.kind, problem.order);
    const auto body = [](const std::string &name) {
      return section("Body " + name, {"Mesh file = " + name + ".msh",
                                      "Young's modulus = 1000", "Poisson ratio = 0.3"});
    };
    const std::string contact =
      problem.law == "tied" ? "Law = tied" : "Law = coulomb\n  set Coefficient = 0.6";
    const std::string prm = file(
      "sectors.prm",
      body("inner") + body("outer") +
        section("Contact pair fit",
                {"Boundary = inner.right", "Obstacle = boundary : outer.left",
                 "Mesh gap = removed", contact}) +
        section("Boundary conditions",
                {std::string("Prescribed displacement = outer.right : ") +
                   (is_turned ? "-0.02*y; 0.02*x; 0" : "0; 0; 0"),
                 "Traction = inner.left : 2*x/10 - 0.3*y/10; 2*y/10 + 0.3*x/10; 0.1"}) +
        section("Contact solver", {"Tolerance = 1e-10"}));
    return Run(prm, problem.settings + Settings{"Output/Write solution=false",
                                                "Refinement/Estimate error=false"});
  }

  // Of the reactions and the loads, relative to those of the loads.
  double missing_moment(const Run &run)
  {
    const dealii::Tensor<1, 3> loads = moment_of_loads(run);
    dealii::Tensor<1, 3> all         = loads;
    for (const auto &support : run.summary()["reactions"]["boundaries"])
      for (unsigned int c = 0; c < 3; ++c)
        all[c] += support["moment"][c].get<double>();
    return all.norm() / loads.norm();
  }

  void check(const std::string &what, const Problem &problem)
  {
    const Run still = solve(problem, false), turned = solve(problem, true);
    out() << what << ": certified " << yes(still.converged && turned.converged)
          << ", moment of the loads to 1e-8 "
          << yes(missing_moment(still) < 1e-8 && missing_moment(turned) < 1e-8)
          << ", forces as before it is turned to 1e-7 "
          << yes(distance(turned, still) < 1e-7) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check("tied", {"tied"});
  for (const std::string side : {"boundary", "obstacle"})
    {
      const Settings slaves = {"Contact pair fit/Slave side=" + side};
      check("friction, " + side, {"coulomb", 0., 'h', 1, slaves});
      check("apart, " + side, {"coulomb", 0.5, 'h', 1, slaves});
    }
  check("curved, of degree 2", {"coulomb", 0., 'h', 2, {"Geometry/Element degree=2"}});
  check("tetrahedra", {"coulomb", 0., 't', 1, {}});
  check("levels",
        {"coulomb", 0., 'h', 1, {"Body inner/Refinement=1", "Body outer/Refinement=1"}});
  for (const Method &method : all_methods())
    if (method.name != "gauss seidel" && method.name.find("amg") == std::string::npos)
      check(method.name, {"coulomb", 0., 'h', 1, method.settings});
}
