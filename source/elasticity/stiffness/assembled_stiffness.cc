#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/stiffness/assembled_stiffness.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace stiction
{
  using namespace dealii;

  std::unique_ptr<LA::SparseMatrix> assemble_stiffness(
    const MeshLevel &level, const Materials &materials,
    const AffineConstraints<double> &constraints)
  {
    const Body &body      = level.body();
    const IndexSet &owned = level.partitioner()->locally_owned_range();
    IndexSet relevant     = owned;
    relevant.add_indices(level.partitioner()->ghost_indices());
    std::vector<types::global_dof_index> indices;
    const auto find_indices = [&](const std::vector<unsigned int> &nodes) {
      indices.clear();
      for (const unsigned int node : nodes)
        for (unsigned int c = 0; c < 3; ++c)
          indices.push_back(level.first_dof(node) + c);
    };

    DynamicSparsityPattern pattern(relevant);
    level.for_each_node_list([&](const std::vector<unsigned int> &nodes) {
      find_indices(nodes);
      // prescribed unknowns keep their rows, hanging ones have none
      constraints.add_entries_local_to_global(indices, pattern,
                                              body.n_hanging_nodes() == 0);
    });
    SparsityTools::distribute_sparsity_pattern(pattern, owned, level.communicator(),
                                               relevant);
    auto matrix = std::make_unique<LA::SparseMatrix>();
    matrix->reinit(owned, owned, pattern, level.communicator());

    for_each_element(level, materials, 1.,
                     [&](const std::vector<unsigned int> &nodes, const auto &K) {
                       find_indices(nodes);
                       constraints.distribute_local_to_global(K, indices, *matrix);
                     });
    matrix->compress(VectorOperation::add);
    if (body.n_hanging_nodes() == 0)
      return matrix;

    // deal.II leaves something on the diagonal of what it eliminates
    for (const auto dof : owned)
      if (body.is_hanging(dof))
        matrix->set(dof, dof, 0.);
    matrix->compress(VectorOperation::insert);
    return matrix;
  }
} // namespace stiction
