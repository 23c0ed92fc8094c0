// Nearly incompressible bodies by displacements and pressures of the cells: newton
// multigrid factorises nothing where smoothing node by node was no use, on refined
// meshes, with hanging nodes, on a mesh of cut tetrahedra from a file and for a pair of
// rubber on steel, and finds the forces of newton. So do elastic solves by multigrid. A
// column between smooth walls has the exact pressure and displacement.

#include "cut_block_file.h"
#include "several_bodies.h"

#include <array>
#include <cmath>

namespace
{
  const Settings multigrid = {"Contact solver/Method=newton multigrid"};
  const Settings common    = {"Geometry/Table 1 level=0", "Material/Young's modulus=1e9",
                              "Output/Write solution=false",
                              "Refinement/Estimate error=false",
                              "Contact solver/Tolerance=1e-9"};

  // Whether no level was factorised because its systems were hard, and the finest one is
  // not so small that it always is.
  bool is_without_factors(const Run &run)
  {
    const auto levels = run.summary()["solver"].value("levels", nlohmann::json::array());
    if (levels.empty())
      return false;
    for (const auto &level : levels)
      if (!level["factorized_from_step"].is_null())
        return false;
    return levels.back()["dofs"] > 4000;
  }

  void check_column(const double nu)
  {
    const double E = 1e9, p = 1e6;
    const Run run(
      shipped("brick.prm"),
      common + multigrid +
        Settings{"Geometry/Lengths=1,1,1", "Geometry/Subdivisions=3,3,3",
                 "Geometry/Global refinement=2",
                 "Material/Poisson ratio=" + std::to_string(nu),
                 "Boundary conditions/Prescribed displacement=left : 0; free; "
                 "free | right : 0; free; free | front : free; 0; free | "
                 "back : free; 0; free",
                 "Boundary conditions/Traction=top : 0; 0; -1e6"});
    const double M       = E * (1. - nu) / ((1. + nu) * (1. - 2. * nu));
    const auto contact   = run.summary()["contact"];
    const double largest = contact["max_pressure"].get<double>(),
                 sunk    = run.summary()["displacement"]["max"].get<double>();
    out() << "column, " << nu << ": certified alone " << yes(certified_alone(run))
          << ", pressure to 1e-6 " << yes(std::abs(largest / p - 1.) < 1e-6)
          << ", displacement to 1e-4 " << yes(std::abs(sunk * M / p - 1.) < 1e-4)
          << ", nothing factorised " << yes(is_without_factors(run)) << std::endl;
  }

  // @param own settings of the one that is compared.
  // @return is_without_factors().
  bool compare(const std::string &what, const std::string &prm, const Settings &settings,
               const Settings &own)
  {
    const Run run(prm, settings + own);
    const Run reference(prm, settings + Settings{"Contact solver/Method=newton"});
    out() << what << ": certified alone " << yes(certified_alone(run))
          << ", forces of newton to 1e-6 " << yes(distance(run, reference) < 1e-6)
          << std::endl;
    return is_without_factors(run);
  }

  void check_brick(const std::string &what, const Settings &settings,
                   const Settings &own = {})
  {
    const bool is_free = compare(
      what, shipped("brick.prm"),
      common + Settings{"Geometry/Lengths=4,3,1", "Material/Poisson ratio=0.499"} +
        settings,
      multigrid + own);
    out() << what << ": nothing factorised " << yes(is_free) << std::endl;
  }
  // Two blocks of rubber that loads press on one another, and nothing holds.
  void check_free_bodies()
  {
    const std::string rubber = "Young's modulus = 5", nu = "Poisson ratio = 0.499";
    const bool is_free = compare(
      "free bodies",
      file(
        "free.prm",
        section("Body lower", {"Lengths = 2, 1, 1", "Subdivisions = 8, 4, 4",
                               "Refinement = 1", rubber, nu}) +
          section("Body upper",
                  {"Lengths = 1.5, 0.8, 1", "Subdivisions = 6, 4, 2",
                   "Translation = 0.25; 0.1; 1", "Refinement = 1", rubber, nu}) +
          section("Contact pair both",
                  {"Boundary = upper.bottom", "Obstacle = boundary : lower.top",
                   "Law = coulomb", "Coefficient = 0.6"}) +
          section("Boundary conditions",
                  {"Traction = upper.top : 0; 0; -0.12 | lower.bottom : 0; 0; 0.072"}) +
          section("Contact solver", {"Tolerance = 1e-9"})),
      {"Output/Write solution=false", "Refinement/Estimate error=false"}, multigrid);
    out() << "free bodies: nothing factorised " << yes(is_free) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (is_alone())
    check_column(0.49);
  check_column(0.499);

  check_brick("levels", {"Geometry/Subdivisions=5,4,1", "Geometry/Global refinement=2"});
  check_brick("hanging nodes",
              {"Geometry/Subdivisions=5,4,2", "Geometry/Global refinement=1",
               "Geometry/Contact refinement=1"});
  if (is_alone())
    check_brick("algebraic",
                {"Geometry/Subdivisions=15,12,6", "Geometry/Global refinement=0"},
                {"Stiffness solver/Type=amg"});
  CutBlockFile(
    {{5, 5, 3}}, [](const auto &) { return 't'; },
    [](const dealii::Point<3> &q) {
      return dealii::Point<3>(4. * q[0], 3. * q[1], q[2]);
    },
    1)
    .write("rubber.msh");
  check_brick("cut tetrahedra",
              {"Geometry/Type=file", "Geometry/Mesh file=rubber.msh", "Geometry/Lengths=",
               "Geometry/Subdivisions=", "Geometry/Global refinement=0"});
  compare("elastic solves by multigrid", shipped("brick.prm"),
          common + Settings{"Geometry/Lengths=1,1,2.5", "Material/Poisson ratio=0.49",
                            "Geometry/Subdivisions=2,2,5",
                            "Boundary conditions/Prescribed displacement=",
                            "Boundary conditions/Traction=top : 1e4; 0; -1e6",
                            "Geometry/Global refinement=2"},
          {"Contact solver/Method=newton", "Stiffness solver/Type=multigrid",
           "Dual operator/Form=by solves"});
  const bool is_free = compare(
    "rubber on steel",
    file("pair.prm",
         section("Body rubber", {"Lengths = 2, 1, 1", "Subdivisions = 8, 4, 4",
                                 "Refinement = 1", "Translation = 0.5; 0.5; 1",
                                 "Young's modulus = 5", "Poisson ratio = 0.499"}) +
           section("Body steel", {"Lengths = 3, 2, 1", "Subdivisions = 6, 4, 2",
                                  "Young's modulus = 2e5", "Poisson ratio = 0.3"}) +
           section("Contact pair seal",
                   {"Boundary = rubber.bottom", "Obstacle = boundary : steel.top",
                    "Law = coulomb", "Coefficient = 0.6"}) +
           section("Boundary conditions",
                   {"Prescribed displacement = steel.bottom : 0; 0; 0 | rubber.top "
                    ": 0.02; 0; -0.05"}) +
           section("Contact solver", {"Tolerance = 1e-9"})),
    {"Output/Write solution=false", "Refinement/Estimate error=false"}, multigrid);
  out() << "rubber on steel: nothing factorised " << yes(is_free) << std::endl;
  check_free_bodies();
}
