// Products with K: stiction's, with every instruction set this machine has,
// deal.II's FEEvaluation, and dst += a src, which reads and writes the same
// vectors and shows what memory allows. One thread. A line of JSON for each.
//
//   benchmark_products LEVEL REPETITIONS
//
// on the reference brick, LEVEL times refined, with congruent cells and with
// its inner vertices moved.

#include <stiction/elasticity/kernels/cell_stiffness.h>

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <nlohmann/json.hpp>

#include "feevaluation_elasticity.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace dealii;
using namespace stiction;

namespace
{
  struct Candidate
  {
    std::string name;
    std::function<void()> run;
    std::size_t bytes;
    std::vector<double> seconds;
  };

  double seconds_of(const std::function<void()> &run)
  {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
  }

  template<typename Number>
  CellStiffness<Number> make_stiffness(const DoFHandler<3> &dof_handler,
                                       const InstructionSet instruction_set)
  {
    CellStiffness<Number> K(instruction_set);
    std::vector<types::global_dof_index> dofs(24);
    for (const auto &dealii_cell : dof_handler.active_cell_iterators())
      {
        HexahedralCell cell;
        dealii_cell->get_dof_indices(dofs);
        for (unsigned int v = 0; v < 8; ++v)
          {
            cell.nodes[v] = dofs[3 * v] / 3;
            for (unsigned int d = 0; d < 3; ++d)
              cell.vertices[v][d] = dealii_cell->vertex(v)[d];
          }
        cell.lame_lambda   = reference_brick::lame_lambda;
        cell.shear_modulus = reference_brick::shear_modulus;
        K.add_cell(cell);
      }
    K.finish();
    return K;
  }

  // Of this process, in bytes.
  std::size_t memory_in_use()
  {
    Utilities::System::MemoryStats stats;
    Utilities::System::get_memory_stats(stats);
    return 1024 * stats.VmRSS;
  }

  // What memory has to do in any product.
  template<typename Number>
  void add(Number *const dst, const Number *const src, const std::size_t n)
  {
#pragma GCC ivdep
    for (std::size_t i = 0; i < n; ++i)
      dst[i] += Number(1e-3) * src[i];
  }

  template<typename Number>
  void measure(const DoFHandler<3> &dof_handler, const std::string &cells,
               const unsigned int level, const unsigned int repetitions)
  {
    const AffineConstraints<Number> no_constraints;
    MatrixFree<3, Number> matrix_free;
    typename MatrixFree<3, Number>::AdditionalData data;
    data.tasks_parallel_scheme =
      MatrixFree<3, Number>::AdditionalData::TasksParallelScheme::none;
    data.mapping_update_flags = update_gradients | update_JxW_values;
    matrix_free.reinit(MappingQ1<3>(), dof_handler, no_constraints, QGauss<1>(2), data);
    feevaluation::Vector<Number> src, dst;
    matrix_free.initialize_dof_vector(src);
    matrix_free.initialize_dof_vector(dst);
    for (std::size_t i = 0; i < src.locally_owned_size(); ++i)
      src.local_element(i) = Number(1e-12) * Number(i % 17);

    std::vector<CellStiffness<Number>> products;
    std::vector<Candidate> candidates;
    candidates.push_back(
      {"FEEvaluation",
       [&] { matrix_free.cell_loop(&feevaluation::add_product<Number>, dst, src); },
       matrix_free.memory_consumption(),
       {}});
    for (const InstructionSet instruction_set : all_instruction_sets)
      if (is_supported(instruction_set))
        {
          const std::size_t before = memory_in_use();
          products.push_back(make_stiffness<Number>(dof_handler, instruction_set));
          candidates.push_back({name(instruction_set),
                                [&, i = products.size() - 1] {
                                  products[i].add_product(dst.begin(), src.begin());
                                },
                                std::max(memory_in_use(), before) - before,
                                {}});
        }
    candidates.push_back(
      {"dst += a src", [&] { add(dst.begin(), src.begin(), src.size()); }, 0, {}});

    // Taking turns, so that what slows down the machine slows down all.
    for (Candidate &candidate : candidates)
      candidate.run();
    for (unsigned int i = 0; i < repetitions; ++i)
      for (Candidate &candidate : candidates)
        candidate.seconds.push_back(seconds_of(candidate.run));

    for (Candidate &candidate : candidates)
      {
        std::sort(candidate.seconds.begin(), candidate.seconds.end());
        nlohmann::json line;
        line["level"]          = level;
        line["dofs"]           = dof_handler.n_dofs();
        line["cells"]          = cells;
        line["number"]         = sizeof(Number) == 4 ? "float" : "double";
        line["product"]        = candidate.name;
        line["best_seconds"]   = candidate.seconds.front();
        line["median_seconds"] = candidate.seconds[repetitions / 2];
        line["bytes"]          = candidate.bytes;
        std::cout << line << std::endl;
      }
  }
} // namespace

int main(int argc, char **argv)
{
  MultithreadInfo::set_thread_limit(1);
  const int level       = argc == 3 ? whole_number(argv[1]) : -1;
  const int repetitions = argc == 3 ? whole_number(argv[2]) : 0;
  if (level < 0 || repetitions < 1)
    {
      std::cerr << "benchmark_products LEVEL REPETITIONS" << std::endl;
      return 1;
    }

  Triangulation<3> brick;
  GridGenerator::subdivided_hyper_rectangle(brick, std::vector<unsigned int>{4, 3, 1},
                                            Point<3>(), Point<3>(4., 3., 1.));
  brick.refine_global(level);
  const FESystem<3> fe(FE_Q<3>(1), 3);
  for (const std::string cells : {"congruent", "general"})
    {
      if (cells == "general")
        GridTools::distort_random(.15, brick);
      DoFHandler<3> dof_handler(brick);
      dof_handler.distribute_dofs(fe);
      measure<double>(dof_handler, cells, level, repetitions);
      measure<float>(dof_handler, cells, level, repetitions);
    }
}
