// Meshes without levels that multigrid can use. A distorted block from a file, of one
// and of two materials, and the same block with a crack, pressed and pulled: newton
// multigrid with grids behind the mesh has the forces of the assembled matrix with
// algebraic multigrid and of the dual method, an elastic solve takes few iterations,
// and contact not many more. So it is where the mesh of the file was refined, everywhere
// or at the contact with hanging nodes.

#include "tests.h"

#include <fstream>
#include <random>

using namespace stiction;

namespace
{
  constexpr unsigned int nx = 16, ny = 12, nz = 8;

  // In Gmsh's format 2.2: unit cells, inner nodes moved at random.
  //
  // @param is_cracked along x = 8 for z > 3, where cells share no nodes.
  void write_mesh(const std::string &file, const bool is_cracked)
  {
    std::mt19937 random(1);
    const auto noise = [&]() { return 0.4 * (random() / 4294967296.) - 0.2; };
    std::ostringstream nodes, elements;
    unsigned int n_nodes = 0, n_elements = 0;
    std::vector<unsigned int> left, right; // of the crack; the same elsewhere
    for (unsigned int k = 0; k <= nz; ++k)
      for (unsigned int j = 0; j <= ny; ++j)
        for (unsigned int i = 0; i <= nx; ++i)
          {
            const double x       = i + (i % nx != 0 && i != nx / 2 ? noise() : 0.);
            const double y       = j + (j % ny != 0 ? noise() : 0.);
            const double z       = k + (k % nz != 0 ? noise() : 0.);
            const bool is_double = is_cracked && i == nx / 2 && k > 3;
            for (unsigned int side = 0; side < (is_double ? 2 : 1); ++side)
              nodes << ++n_nodes << ' ' << x << ' ' << y << ' ' << z << '\n';
            left.push_back(is_double ? n_nodes - 1 : n_nodes);
            right.push_back(n_nodes);
          }
    const auto node = [&](const unsigned int cell, const unsigned int i,
                          const unsigned int j, const unsigned int k) {
      return (cell < nx / 2 ? left : right)[i + (nx + 1) * (j + (ny + 1) * k)];
    };
    const auto begin = [&](const unsigned int type, const unsigned int id) {
      elements << ++n_elements << ' ' << type << " 2 " << id << ' ' << id;
    };
    for (unsigned int j = 0; j < ny; ++j)
      for (unsigned int i = 0; i < nx; ++i)
        for (const unsigned int k : {0u, nz})
          {
            begin(3, k == 0 ? 1 : 2);
            elements << ' ' << node(i, i, j, k) << ' ' << node(i, i + 1, j, k) << ' '
                     << node(i, i + 1, j + 1, k) << ' ' << node(i, i, j + 1, k) << '\n';
          }
    for (unsigned int k = 0; k < nz; ++k)
      for (unsigned int i = 0; i < nx; ++i)
        {
          begin(3, 3);
          elements << ' ' << node(i, i, 0, k) << ' ' << node(i, i + 1, 0, k) << ' '
                   << node(i, i + 1, 0, k + 1) << ' ' << node(i, i, 0, k + 1) << '\n';
        }
    for (unsigned int k = 0; k < nz; ++k)
      for (unsigned int j = 0; j < ny; ++j)
        for (unsigned int i = 0; i < nx; ++i)
          {
            begin(5, k < nz / 2 ? 1 : 2);
            for (const unsigned int z : {k, k + 1})
              elements << ' ' << node(i, i, j, z) << ' ' << node(i, i + 1, j, z) << ' '
                       << node(i, i + 1, j + 1, z) << ' ' << node(i, i, j + 1, z);
            elements << '\n';
          }
    std::ofstream out(file);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n2 1 \"bottom\"\n"
           "2 2 \"top\"\n2 3 \"front\"\n3 1 \"lower\"\n3 2 \"upper\"\n"
           "$EndPhysicalNames\n$Nodes\n"
        << n_nodes << '\n'
        << nodes.str() << "$EndNodes\n$Elements\n"
        << n_elements << '\n'
        << elements.str() << "$EndElements\n";
  }

  Settings problem(const std::string &file)
  {
    return {"Geometry/Table 1 level=0",
            "Geometry/Type=file",
            "Geometry/Mesh file=" + file,
            "Boundary conditions/Prescribed displacement=front : 0; 0; 0",
            "Boundary conditions/Traction=top : 3e6; 2e6; if(y > 6, -2e7, 0)",
            "Boundary conditions/Contact boundary=bottom",
            "Refinement/Estimate error=false",
            "Performance/Measure one elastic solve=true"};
  }

  unsigned int krylov_iterations(const Run &run)
  {
    return run.summary()["solver"]["krylov_iterations"];
  }

  // @param beside_assembled whether one rank alone solves with the assembled matrix as
  // well, which takes long.
  void check(const std::string &name, const Settings &settings,
             const unsigned int most_elastic, const unsigned int most,
             const bool beside_assembled = true)
  {
    const std::string brick = shipped("brick.prm");
    const Settings multigrid{"Contact solver/Method=newton multigrid"};
    const Run run(brick, settings + multigrid);
    std::string assembled;
    if (beside_assembled && is_alone())
      {
        const Run amg(brick,
                      settings + multigrid + Settings{"Stiffness solver/Type=amg"});
        assembled = std::string(" of the assembled matrix to 1e-7 ") +
                    yes(amg.converged && distance(run, amg) < 1e-7) + ",";
      }
    const Run dual(brick, settings + Settings{"Contact solver/Method=newton"});
    const unsigned int elastic = run.summary()["solver"]["elastic_solve_iterations"];
    out() << name << ": certified " << yes(run.converged) << ", opens, slips and sticks "
          << yes(run.summary()["contact"]["open"] > 0 &&
                 run.summary()["contact"]["slip"] > 0 &&
                 run.summary()["contact"]["stick"] > 0)
          << ", forces" << assembled << " of the dual method "
          << yes(dual.converged && distance(run, dual) < 1e-7)
          << ", iterations of an elastic solve at most " << most_elastic << ' '
          << yes(elastic <= most_elastic) << ", of contact at most " << most << ' '
          << yes(krylov_iterations(run) <= most) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      write_mesh("whole.msh", false);
      write_mesh("cracked.msh", true);
    }
  MPI_Barrier(MPI_COMM_WORLD);

  check("from a file", problem("whole.msh"), 12, 30);
  check("two materials",
        problem("whole.msh") + Settings{"Material/Materials=lower : isotropic; 2e11; 0.3 "
                                        "| upper : isotropic; 2e10; 0.3"},
        18, 40);
  check("mean dilatation",
        problem("whole.msh") +
          Settings{"Material/Poisson ratio=0.4", "Material/Volume strain=cell mean"},
        30, 80);
  check("orthotropic above isotropic",
        problem("whole.msh") +
          Settings{"Material/Materials=upper : orthotropic; 2e11; 1e11; 5e10; 0.3; 0.3; "
                   "0.3; 5e10; 5e10; 3e10"},
        18, 40);
  check("quadratic elements",
        problem("whole.msh") + Settings{"Geometry/Element degree=2"}, 15, 30, false);
  check("with a crack", problem("cracked.msh"), 21, 42);
  check("refined once", problem("whole.msh") + Settings{"Geometry/Global refinement=1"},
        13, 20);
  check("refined at the contact",
        problem("whole.msh") +
          Settings{"Geometry/Contact refinement=1",
                   "Boundary conditions/Prescribed displacement=front : 1e-5; 0; 0"},
        16, 40);
  if (is_alone())
    check("quadratic elements refined at the contact",
          problem("whole.msh") + Settings{"Geometry/Element degree=2",
                                          "Geometry/Contact refinement=1",
                                          "Geometry/Contact refinement where=x - 13"},
          15, 50, false);
}
