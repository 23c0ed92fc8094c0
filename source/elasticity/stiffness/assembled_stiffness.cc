#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/assembled_stiffness.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>
#include <stiction/elasticity/stiffness/general_element_stiffness.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // A matrix of zeros.
    std::unique_ptr<LA::SparseMatrix> make_matrix(
      const Body &body, const AffineConstraints<double> &constraints,
      const bool has_constrained_entries)
    {
      const IndexSet &owned    = body.locally_owned_dofs();
      const IndexSet &relevant = body.locally_relevant_dofs();
      DynamicSparsityPattern pattern(relevant);
      DoFTools::make_sparsity_pattern(body.dof_handler(), pattern, constraints,
                                      has_constrained_entries);
      SparsityTools::distribute_sparsity_pattern(pattern, owned, body.communicator(),
                                                 relevant);
      auto matrix = std::make_unique<LA::SparseMatrix>();
      matrix->reinit(owned, owned, pattern, body.communicator());
      return matrix;
    }
  } // namespace

  std::unique_ptr<LA::SparseMatrix> assemble_stiffness(const Body &body,
                                                       const MaterialOfCell &material)
  {
    const DoFHandler<3> &dof_handler = body.dof_handler();
    auto matrix                      = make_matrix(body, body.hanging_nodes(), false);

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
    for (const auto dof : body.locally_owned_dofs())
      if (body.is_hanging(dof))
        matrix->set(dof, dof, 0.);
    matrix->compress(VectorOperation::insert);
    return matrix;
  }

  std::unique_ptr<LA::SparseMatrix> assemble_simple_stiffness(
    const Body &body, const MeshLevel &mesh, const Materials &materials,
    const AffineConstraints<double> &constraints)
  {
    auto matrix = make_matrix(body, constraints, true);
    ElementStiffness element_stiffness;
    std::vector<types::global_dof_index> indices(24);
    mesh.for_each_cell([&](HexahedralCell cell) {
      materials.assign(cell);
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int c = 0; c < 3; ++c)
          indices[3 * v + c] = mesh.first_dof(cell.nodes[v]) + c;
      constraints.distribute_local_to_global(element_stiffness(cell), indices, *matrix);
    });
    matrix->compress(VectorOperation::add);
    return matrix;
  }
} // namespace stiction
