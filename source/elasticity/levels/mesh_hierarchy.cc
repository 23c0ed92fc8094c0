#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>

#include <stdexcept>

namespace stiction
{
  MeshHierarchy::MeshHierarchy(const Body &body, const MeshLevel &mesh,
                               const bool levels_in_use)
    : mesh_(mesh)
  {
    const unsigned int n = body.triangulation().n_global_levels();
    if (!levels_in_use || !body.has_levels() || (n == 1 && mesh.is_trilinear()))
      return;
    // so that vectors of the mesh are vectors of its last level
    if (mesh.is_trilinear() && body.dof_handler().locally_owned_dofs() !=
                                 body.dof_handler().locally_owned_mg_dofs(n - 1))
      throw std::logic_error("the mesh is not numbered like its last level");

    for (unsigned int l = 0; l < (mesh.is_trilinear() ? n - 1 : n); ++l)
      coarser_.push_back(std::make_unique<MeshLevel>(body, l));
    for (unsigned int l = 1; l < n_levels(); ++l)
      transfers_.push_back(
        std::make_unique<LevelTransfer>(body, l, level(l - 1), level(l)));
  }
} // namespace stiction
