#ifndef stiction_elasticity_stiffness_cell_material_h
#define stiction_elasticity_stiffness_cell_material_h

#include <deal.II/base/symmetric_tensor.h>

namespace stiction
{
  /// What a cell is made of, for assembled stiffness matrices.
  struct CellMaterial
  {
    /// σ = stiffness : ε, in Pa.
    dealii::SymmetricTensor<4, 3> stiffness;

    /// Whether the volume change ∇·u is replaced by its mean over the cell
    /// (mean dilatation, B-bar: T. J. R. Hughes, 1980), which keeps nearly
    /// incompressible material from locking.
    bool mean_dilatation = false;
  };

} // namespace stiction

#endif
