// The elastic solve that deal.II's tutorials teach, to compare with: multigrid
// on p4est's hierarchy, matrix-free in float with Chebyshev smoothing, around
// it conjugate gradients in double to 1e-8. Prints a line of JSON.
//
//   [mpirun -n RANKS] benchmark_feevaluation_solve LEVEL [DEGREE]
//
// for the reference brick, LEVEL times refined, clamped at y = 0 and loaded,
// and smoothers of that degree.

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/matrix_free/operators.h>
#include <deal.II/matrix_free/tools.h>
#include <deal.II/multigrid/mg_coarse.h>
#include <deal.II/multigrid/mg_constrained_dofs.h>
#include <deal.II/multigrid/mg_matrix.h>
#include <deal.II/multigrid/mg_smoother.h>
#include <deal.II/multigrid/mg_tools.h>
#include <deal.II/multigrid/mg_transfer_matrix_free.h>
#include <deal.II/multigrid/multigrid.h>
#include <deal.II/numerics/vector_tools.h>

#include <nlohmann/json.hpp>

#include "feevaluation_elasticity.h"

#include <cmath>
#include <iostream>
#include <memory>
#include <string>

using namespace dealii;

namespace
{
  template<typename Number> using Vector = feevaluation::Vector<Number>;

  // Faces of the brick in deal.II's colours.
  const types::boundary_id y_low = 2, y_high = 3, z_high = 5;

  template<typename Number>
  class Stiffness : public MatrixFreeOperators::Base<3, Vector<Number>>
  {
  public:
    void compute_diagonal() override
    {
      this->inverse_diagonal_entries = std::make_shared<DiagonalMatrix<Vector<Number>>>();
      Vector<Number> &diagonal       = this->inverse_diagonal_entries->get_vector();
      this->data->initialize_dof_vector(diagonal);
      MatrixFreeTools::compute_diagonal<3, 1, 2, 3, Number>(
        *this->data, diagonal, &feevaluation::integrate_stress<Number>);
      this->set_constrained_entries_to_one(diagonal);
      for (Number &entry : diagonal)
        entry = Number(1) / entry;
    }

  private:
    void apply_add(Vector<Number> &dst, const Vector<Number> &src) const override
    {
      this->data->cell_loop(&feevaluation::add_product<Number>, dst, src);
    }
  };

  struct Solution
  {
    unsigned int iterations;

    // of the loads on the displacements they cause, to compare answers; J
    double work_of_load;
  };

  class Brick
  {
  public:
    Brick(unsigned int level, unsigned int degree);

    Solution solve();

    types::global_dof_index n_dofs() const { return dof_handler.n_dofs(); }

  private:
    using LevelStiffness = Stiffness<float>;
    using Smoother       = PreconditionChebyshev<LevelStiffness, Vector<float>>;

    void set_up_levels(unsigned int degree);

    void assemble_load();

    parallel::distributed::Triangulation<3> triangulation;
    FESystem<3> fe;
    DoFHandler<3> dof_handler;
    MappingQ1<3> mapping;
    AffineConstraints<double> constraints;
    Stiffness<double> stiffness;
    Vector<double> load;

    MGConstrainedDoFs level_constraints;
    MGLevelObject<LevelStiffness> level_stiffness;
    MGLevelObject<MatrixFreeOperators::MGInterfaceOperator<LevelStiffness>> interfaces;
    MGTransferMatrixFree<3, float> transfer;
    mg::SmootherRelaxation<Smoother, Vector<float>> smoother;
  };

  template<typename Number>
  std::shared_ptr<MatrixFree<3, Number>> make_matrix_free(
    const DoFHandler<3> &dof_handler, const Mapping<3> &mapping,
    const AffineConstraints<double> &constraints, const unsigned int level)
  {
    typename MatrixFree<3, Number>::AdditionalData data;
    data.tasks_parallel_scheme =
      MatrixFree<3, Number>::AdditionalData::TasksParallelScheme::none;
    data.mapping_update_flags = update_gradients | update_JxW_values;
    data.mg_level             = level;
    auto result               = std::make_shared<MatrixFree<3, Number>>();
    result->reinit(mapping, dof_handler, constraints, QGauss<1>(2), data);
    return result;
  }

  Brick::Brick(const unsigned int level, const unsigned int degree)
    : triangulation(
        MPI_COMM_WORLD, Triangulation<3>::limit_level_difference_at_vertices,
        parallel::distributed::Triangulation<3>::construct_multigrid_hierarchy)
    , fe(FE_Q<3>(1), 3)
    , dof_handler(triangulation)
  {
    GridGenerator::subdivided_hyper_rectangle(triangulation,
                                              std::vector<unsigned int>{4, 3, 1},
                                              Point<3>(), Point<3>(4., 3., 1.), true);
    triangulation.refine_global(level);
    dof_handler.distribute_dofs(fe);
    dof_handler.distribute_mg_dofs();

    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    constraints.reinit(relevant);
    VectorTools::interpolate_boundary_values(mapping, dof_handler, y_low,
                                             Functions::ZeroFunction<3>(3), constraints);
    constraints.close();
    stiffness.initialize(make_matrix_free<double>(dof_handler, mapping, constraints,
                                                  numbers::invalid_unsigned_int));
    stiffness.initialize_dof_vector(load);
    assemble_load();
    set_up_levels(degree);
  }

  void Brick::assemble_load()
  {
    FEFaceValues<3> values(mapping, fe, QGauss<2>(2),
                           update_values | update_quadrature_points | update_JxW_values);
    dealii::Vector<double> of_cell(fe.n_dofs_per_cell());
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        if (cell->is_locally_owned() && cell->face(face)->at_boundary())
          {
            const types::boundary_id id = cell->face(face)->boundary_id();
            const bool on_top = id == z_high && cell->face(face)->center()[1] > 1.5;
            if (id != y_high && !on_top)
              continue;
            const Tensor<1, 3> traction =
              on_top ? Point<3>(0., 0., -1e8) : Point<3>(1e7, 2e7, 2e7);
            values.reinit(cell, face);
            of_cell = 0.;
            for (unsigned int i = 0; i < of_cell.size(); ++i)
              for (const unsigned int q : values.quadrature_point_indices())
                of_cell(i) += traction[fe.system_to_component_index(i).first] *
                              values.shape_value(i, q) * values.JxW(q);
            cell->get_dof_indices(dofs);
            constraints.distribute_local_to_global(of_cell, dofs, load);
          }
    load.compress(VectorOperation::add);
  }

  void Brick::set_up_levels(const unsigned int degree)
  {
    level_constraints.initialize(dof_handler);
    level_constraints.make_zero_boundary_constraints(dof_handler, {y_low});
    const unsigned int n_levels = triangulation.n_global_levels();
    level_stiffness.resize(0, n_levels - 1);
    interfaces.resize(0, n_levels - 1);
    std::vector<std::shared_ptr<const Utilities::MPI::Partitioner>> partitioners;
    MGLevelObject<Smoother::AdditionalData> smoother_data(0, n_levels - 1);
    for (unsigned int level = 0; level < n_levels; ++level)
      {
        IndexSet relevant;
        DoFTools::extract_locally_relevant_level_dofs(dof_handler, level, relevant);
        AffineConstraints<double> of_level(relevant);
        of_level.add_lines(level_constraints.get_boundary_indices(level));
        of_level.close();
        const auto matrix_free =
          make_matrix_free<float>(dof_handler, mapping, of_level, level);
        level_stiffness[level].initialize(matrix_free, level_constraints, level);
        level_stiffness[level].compute_diagonal();
        interfaces[level].initialize(level_stiffness[level]);
        partitioners.push_back(matrix_free->get_vector_partitioner());

        Smoother::AdditionalData &data = smoother_data[level];
        data.preconditioner = level_stiffness[level].get_matrix_diagonal_inverse();
        if (level > 0)
          {
            data.smoothing_range     = 15.;
            data.degree              = degree;
            data.eig_cg_n_iterations = 10;
          }
        else
          {
            // the coarsest level is solved, by the same iteration
            data.smoothing_range     = 1e-3;
            data.degree              = numbers::invalid_unsigned_int;
            data.eig_cg_n_iterations = level_stiffness[0].m();
          }
      }
    transfer.initialize_constraints(level_constraints);
    transfer.build(dof_handler, partitioners);
    smoother.initialize(level_stiffness, smoother_data);

    // estimates the eigenvalues, which belongs to the set-up
    for (unsigned int level = 0; level < n_levels; ++level)
      {
        Vector<float> vector;
        level_stiffness[level].initialize_dof_vector(vector);
        smoother[level].estimate_eigenvalues(vector);
      }
  }

  Solution Brick::solve()
  {
    MGCoarseGridApplySmoother<Vector<float>> coarse(smoother);
    const mg::Matrix<Vector<float>> matrix(level_stiffness);
    const mg::Matrix<Vector<float>> interface(interfaces);
    Multigrid<Vector<float>> multigrid(matrix, coarse, transfer, smoother, smoother);
    multigrid.set_edge_matrices(interface, interface);
    const PreconditionMG<3, Vector<float>, MGTransferMatrixFree<3, float>> preconditioner(
      dof_handler, multigrid, transfer);

    Vector<double> displacement;
    stiffness.initialize_dof_vector(displacement);
    SolverControl control(200, 1e-8 * load.l2_norm());
    SolverCG<Vector<double>> solver(control);
    solver.solve(stiffness, displacement, load, preconditioner);
    return {control.last_step(), displacement * load};
  }

  // Peak resident memory of all ranks. Unit: MB.
  double peak_memory()
  {
    Utilities::System::MemoryStats stats;
    Utilities::System::get_memory_stats(stats);
    return Utilities::MPI::sum(stats.VmHWM / 1024., MPI_COMM_WORLD);
  }
} // namespace

int main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize initialization(argc, argv, 1);
  const int level   = argc == 2 || argc == 3 ? whole_number(argv[1]) : -1;
  const int degree  = argc == 3 ? whole_number(argv[2]) : 2;
  const bool speaks = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  if (level < 0 || degree < 1)
    {
      if (speaks)
        std::cerr << "benchmark_feevaluation_solve LEVEL [DEGREE]" << std::endl;
      return 1;
    }

  Timer timer(MPI_COMM_WORLD, true);
  Brick brick(level, degree);
  const double setup_seconds = timer.wall_time();
  timer.restart();
  const Solution solution    = brick.solve();
  const double solve_seconds = timer.wall_time();
  const double memory        = peak_memory();

  nlohmann::json line;
  line["dofs"]           = brick.n_dofs();
  line["ranks"]          = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  line["iterations"]     = solution.iterations;
  line["setup_seconds"]  = setup_seconds;
  line["solve_seconds"]  = solve_seconds;
  line["peak_memory_MB"] = memory;
  line["work_of_load"]   = solution.work_of_load;
  if (speaks)
    std::cout << line << std::endl;
}
