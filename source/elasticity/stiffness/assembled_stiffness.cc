#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/stiffness/assembled_stiffness.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace stiction
{
  using namespace dealii;

  std::unique_ptr<LA::SparseMatrix> assemble_stiffness(
    const MeshLevel &mesh, const Materials &materials,
    const AffineConstraints<double> &constraints)
  {
    const Body &body         = mesh.body();
    const IndexSet &owned    = body.locally_owned_dofs();
    const IndexSet &relevant = body.locally_relevant_dofs();
    DynamicSparsityPattern pattern(relevant);
    // prescribed unknowns keep their rows, hanging ones have none
    DoFTools::make_sparsity_pattern(body.dof_handler(), pattern, constraints,
                                    body.n_hanging_nodes() == 0);
    SparsityTools::distribute_sparsity_pattern(pattern, owned, body.communicator(),
                                               relevant);
    auto matrix = std::make_unique<LA::SparseMatrix>();
    matrix->reinit(owned, owned, pattern, body.communicator());

    std::vector<types::global_dof_index> indices;
    for_each_element(mesh, materials, 1.,
                     [&](const std::vector<unsigned int> &nodes, const auto &K) {
                       indices.clear();
                       for (const unsigned int node : nodes)
                         for (unsigned int c = 0; c < 3; ++c)
                           indices.push_back(mesh.first_dof(node) + c);
                       constraints.distribute_local_to_global(K, indices, *matrix);
                     });
    matrix->compress(VectorOperation::add);

    // deal.II leaves something on the diagonal of what it eliminates
    for (const auto dof : owned)
      if (body.is_hanging(dof))
        matrix->set(dof, dof, 0.);
    matrix->compress(VectorOperation::insert);
    return matrix;
  }
} // namespace stiction
