#pragma once

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include "tests.h"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <fstream>
#include <string>
#include <vector>

// A parameter file in the directory of the test.
inline std::string file(const std::string &name, const std::string &text)
{
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::ofstream(name) << text;
  MPI_Barrier(MPI_COMM_WORLD);
  return name;
}

inline std::string section(const std::string &name, const std::vector<std::string> &lines)
{
  std::string text = "subsection " + name + "\n";
  for (const std::string &line : lines)
    text += "  set " + line + "\n";
  return text + "end\n";
}

inline std::string brick(const std::string &name, const std::string &lengths,
                         const std::string &subdivisions, const std::string &translation,
                         const std::string &rotation = "0;0;0;0;0;1;0",
                         const std::string &E        = "1000")
{
  return section("Body " + name,
                 {"Lengths = " + lengths, "Subdivisions = " + subdivisions,
                  "Translation = " + translation, "Rotation = " + rotation,
                  "Young's modulus = " + E, "Poisson ratio = 0.3", "Density = 1"});
}

// Whether the method certified its answer itself, without another one it falls back to.
inline bool certified_alone(const Run &run)
{
  const auto solver = run.summary()["solver"];
  return run.converged && solver["fallbacks"] == 0 && !solver.contains("handed_over_to");
}

inline unsigned int n_warnings(const Run &run, const std::string &words)
{
  unsigned int n = 0;
  for (const auto &warning : run.summary()["warnings"])
    if (warning.get<std::string>().find(words) != std::string::npos)
      ++n;
  return n;
}

// About the origin. Collective.
inline dealii::Tensor<1, 3> moment_of_loads(const Run &run)
{
  const auto &elasticity = run.problem->elasticity();
  dealii::Tensor<1, 3> sum;
  for (const stiction::Body::Node &node : elasticity.body().locally_owned_nodes())
    {
      dealii::Tensor<1, 3> f;
      for (unsigned int c = 0; c < 3; ++c)
        f[c] = elasticity.load()(node.dofs[c]);
      sum += cross_product_3d(node.position, f);
    }
  return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
}
