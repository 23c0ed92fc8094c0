#ifndef stiction_elasticity_cell_material_h
#define stiction_elasticity_cell_material_h

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



  /// The isotropic material of Lamé's λ and G = μ, in Pa.
  inline CellMaterial
  isotropic_material(const double lame_lambda, const double shear_modulus)
  {
    const auto unit = dealii::unit_symmetric_tensor<3>();
    return {lame_lambda * dealii::outer_product(unit, unit) +
              2. * shear_modulus * dealii::identity_tensor<3>(),
            false};
  }
} // namespace stiction

#endif
