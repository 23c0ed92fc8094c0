// The product with K cell by cell is that of deal.II's own matrix-free
// operator, which knows nothing of classes, patches and modes.

#include <stiction/elasticity/kernels/cell_stiffness.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/vector.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/matrix_free.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <string>

using namespace dealii;
using namespace stiction;

namespace
{
  const double lame_lambda = 1.3, shear_modulus = .8;

  template<typename Number>
  Vector<Number> product_of_dealii(const DoFHandler<3> &dof_handler,
                                   const AffineConstraints<Number> &hanging_nodes,
                                   const Vector<Number> &u)
  {
    MatrixFree<3, Number> matrix_free;
    typename MatrixFree<3, Number>::AdditionalData data;
    data.mapping_update_flags = update_gradients | update_JxW_values;
    matrix_free.reinit(MappingQ1<3>(), dof_handler, hanging_nodes, QGauss<1>(2), data);

    Vector<Number> f(u.size());
    const auto add_cells = [](const MatrixFree<3, Number> &matrix_free, Vector<Number> &f,
                              const Vector<Number> &u,
                              const std::pair<unsigned int, unsigned int> &cells) {
      FEEvaluation<3, 1, 2, 3, Number> displacement(matrix_free);
      for (unsigned int cell = cells.first; cell < cells.second; ++cell)
        {
          displacement.reinit(cell);
          displacement.gather_evaluate(u, EvaluationFlags::gradients);
          for (unsigned int q = 0; q < displacement.n_q_points; ++q)
            {
              const auto strain = displacement.get_symmetric_gradient(q);
              auto stress       = Number(2. * shear_modulus) * strain;
              for (unsigned int d = 0; d < 3; ++d)
                stress[d][d] += Number(lame_lambda) * trace(strain);
              displacement.submit_symmetric_gradient(stress, q);
            }
          displacement.integrate_scatter(EvaluationFlags::gradients, f);
        }
    };
    matrix_free.template cell_loop<Vector<Number>, Vector<Number>>(add_cells, f, u);
    return f;
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
            // the three unknowns of a vertex follow each other
            cell.nodes[v] = dofs[3 * v] / 3;
            for (unsigned int d = 0; d < 3; ++d)
              cell.vertices[v][d] = dealii_cell->vertex(v)[d];
          }
        cell.lame_lambda   = lame_lambda;
        cell.shear_modulus = shear_modulus;
        K.add_cell(cell);
      }
    K.finish();
    return K;
  }

  template<typename Number>
  void compare(const std::string &name, const DoFHandler<3> &dof_handler,
               const unsigned int n_general, const unsigned int n_patched)
  {
    Vector<Number> u(dof_handler.n_dofs());
    std::mt19937 random(1);
    for (Number &entry : u)
      entry = random() / Number(4294967296.) - Number(.5);
    AffineConstraints<Number> hanging_nodes;
    DoFTools::make_hanging_node_constraints(dof_handler, hanging_nodes);
    hanging_nodes.close();
    hanging_nodes.distribute(u);
    const Vector<Number> expected = product_of_dealii(dof_handler, hanging_nodes, u);

    bool agree = true, counted = true;
    for (const InstructionSet instruction_set : all_instruction_sets)
      if (is_supported(instruction_set))
        {
          const CellStiffness<Number> K =
            make_stiffness<Number>(dof_handler, instruction_set);
          Vector<Number> f(u.size());
          K.add_product(f.begin(), u.begin());
          hanging_nodes.condense(f);
          f -= expected;
          agree = agree && f.linfty_norm() < 20 * std::numeric_limits<Number>::epsilon() *
                                               expected.linfty_norm();
          counted = counted && K.n_general_cells() == n_general &&
                    K.n_patched_cells() == n_patched;
        }
    std::cout << name << (sizeof(Number) == 4 ? ", float" : ", double")
              << ": agree: " << (agree ? "yes" : "NO")
              << ", cells counted: " << (counted ? "yes" : "NO") << std::endl;
  }

  void compare(const std::string &name, const Triangulation<3> &triangulation,
               const unsigned int n_general, const unsigned int n_patched)
  {
    const FESystem<3> fe(FE_Q<3>(1), 3);
    DoFHandler<3> dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);
    compare<double>(name, dof_handler, n_general, n_patched);
    compare<float>(name, dof_handler, n_general, n_patched);
  }

  Point<3> sheared(const Point<3> &x)
  {
    return {x[0] + .3 * x[1], x[1] - .2 * x[2], x[2] + .1 * x[0] + .25 * x[1]};
  }

  Point<3> curved(const Point<3> &x)
  {
    return {x[0] + .1 * std::sin(2. * x[1] + x[2]),
            x[1] + .08 * std::cos(3. * x[0]) * x[2],
            x[2] - .1 * std::sin(x[0] * x[1] + .3)};
  }
} // namespace

int main()
{
  const auto make_brick = [](Triangulation<3> &triangulation) {
    GridGenerator::subdivided_hyper_rectangle(triangulation, {4, 3, 1}, Point<3>(),
                                              Point<3>(4., 3., 1.));
  };
  Triangulation<3> brick, half, parallelepiped, hexahedra;
  make_brick(brick);
  brick.refine_global(2);
  compare("brick", brick, 0, 768);

  // the first of eight cells is refined
  make_brick(half);
  half.refine_global(1);
  unsigned int n = 0;
  for (const auto &cell : half.active_cell_iterators())
    if (n++ % 8 == 0)
      cell->set_refine_flag();
  half.execute_coarsening_and_refinement();
  compare("brick, locally refined", half, 0, 96);

  make_brick(parallelepiped);
  parallelepiped.refine_global(2);
  GridTools::transform(sheared, parallelepiped);
  compare("parallelepipeds", parallelepiped, 0, 768);

  make_brick(hexahedra);
  hexahedra.refine_global(2);
  GridTools::transform(curved, hexahedra);
  compare("hexahedra", hexahedra, 768, 0);
}
