#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/assembled_stiffness.h>
#include <stiction/elasticity/stiffness/general_element_stiffness.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace stiction
{
  using namespace dealii;

  std::unique_ptr<LA::SparseMatrix> assemble_stiffness(const Body &body,
                                                       const MaterialOfCell &material)
  {
    const DoFHandler<3> &dof_handler = body.dof_handler();
    const IndexSet &owned            = body.locally_owned_dofs();
    const IndexSet &relevant         = body.locally_relevant_dofs();

    DynamicSparsityPattern pattern(relevant);
    DoFTools::make_sparsity_pattern(dof_handler, pattern, body.hanging_nodes(), false);
    SparsityTools::distribute_sparsity_pattern(pattern, owned, body.communicator(),
                                               relevant);
    auto matrix = std::make_unique<LA::SparseMatrix>();
    matrix->reinit(owned, owned, pattern, body.communicator());

    GeneralElementStiffness element_stiffness(body.mapping(), dof_handler.get_fe());
    std::vector<types::global_dof_index> indices(dof_handler.get_fe().n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(indices);
          body.hanging_nodes().distribute_local_to_global(
            element_stiffness(cell, material(cell)), indices, *matrix);
        }
    matrix->compress(VectorOperation::add);

    // deal.II leaves something on the diagonal of what it eliminates
    for (const auto dof : owned)
      if (body.is_hanging(dof))
        matrix->set(dof, dof, 0.);
    matrix->compress(VectorOperation::insert);
    return matrix;
  }
} // namespace stiction
