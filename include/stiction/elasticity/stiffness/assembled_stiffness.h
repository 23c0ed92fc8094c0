#ifndef stiction_elasticity_stiffness_assembled_stiffness_h
#define stiction_elasticity_stiffness_assembled_stiffness_h

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/dofs/dof_handler.h>

#include <functional>
#include <memory>

namespace stiction
{
  class Body;
  struct CellMaterial;

  /// What a cell is made of.
  using MaterialOfCell =
    std::function<CellMaterial(const dealii::DoFHandler<3>::active_cell_iterator &)>;

  /// K_c = CᵀKC without boundary conditions: the stiffness matrix of any body,
  /// the unknowns of hanging nodes eliminated. Their rows and columns are
  /// empty but for a zero on the diagonal. Unit: N/m. Collective.
  std::unique_ptr<LA::SparseMatrix> assemble_stiffness(const Body &body,
                                                       const MaterialOfCell &material);
} // namespace stiction

#endif
