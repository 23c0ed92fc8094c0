#ifndef stiction_elasticity_stiffness_assembled_stiffness_h
#define stiction_elasticity_stiffness_assembled_stiffness_h

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <functional>
#include <memory>

namespace stiction
{
  class Body;
  class Materials;
  class MeshLevel;
  struct CellMaterial;

  /// What a cell is made of.
  using MaterialOfCell =
    std::function<CellMaterial(const dealii::DoFHandler<3>::active_cell_iterator &)>;

  /// K_c = CᵀKC without boundary conditions: the stiffness matrix of any body,
  /// the unknowns of hanging nodes eliminated. Their rows and columns are
  /// empty but for a zero on the diagonal. Unit: N/m. Collective.
  std::unique_ptr<LA::SparseMatrix> assemble_stiffness(const Body &body,
                                                       const MaterialOfCell &material);

  /// K of a body of trilinear cells and simple materials, the constraints eliminated
  /// symmetrically. Unit: N/m. Collective.
  std::unique_ptr<LA::SparseMatrix> assemble_simple_stiffness(
    const Body &body, const MeshLevel &mesh, const Materials &materials,
    const dealii::AffineConstraints<double> &constraints);
} // namespace stiction

#endif
