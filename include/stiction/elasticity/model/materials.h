#pragma once

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <array>
#include <map>

namespace stiction
{
  class Body;
  struct BodyParameters;
  struct HexahedralCell;

  /// What a part of the body is made of: linear elastic.
  struct Material
  {
    /// @param E Young's modulus, Pa. @param nu Poisson's ratio, from -1 to 0.5 without
    ///   the ends.
    static Material isotropic(double E, double nu);

    /// @param E1_to_G23 E1, E2, E3; ν12, ν13, ν23; G12, G13, G23; moduli in Pa.
    ///   ν12 is the contraction along 2 under a tension along 1, so that the
    ///   compliance has -ν12/E1 in row 1, column 2.
    /// @param axes a rotation, whose columns are the axes 1, 2, 3.
    ///
    /// Throws std::domain_error if the stiffness is not positive definite.
    static Material orthotropic(
      const std::array<double, 9> &E1_to_G23,
      const dealii::Tensor<2, 3> &axes = dealii::unit_symmetric_tensor<3>());

    /// Of a small strain, point by point. Unit: Pa.
    dealii::SymmetricTensor<2, 3> stress(
      const dealii::SymmetricTensor<2, 3> &strain) const;

    bool is_isotropic;

    /// Lamé's λ and G = μ if it is isotropic; otherwise G is the largest one.
    /// Unit: Pa.
    double lame_lambda, shear_modulus;

    /// In the direction where it is largest. Unit: Pa.
    double youngs_modulus;

    /// σ = stiffness : ε. Unit: Pa.
    dealii::SymmetricTensor<4, 3> stiffness;

    /// Unit: kg/m³.
    double density = 0.;

    /// Whether the volume change ∇·u is replaced by its projection on DilatationSpace,
    /// its mean over the cell if that is trilinear, which keeps nearly incompressible
    /// material from locking.
    bool mean_dilatation = false;

    /// Whether Lamé's two numbers say all.
    bool is_simple() const { return is_isotropic && !mean_dilatation; }
  };

  /// The materials of a body by the material ids of its cells.
  class Materials
  {
  public:
    /// Reads the section Material.
    ///
    /// Throws InputError for text that does not read as it should, numbers out
    /// of range, materials that the mesh does not have or that stand twice.
    Materials(const Body &body, const BodyParameters &parameters);

    /// The material of the cells with this id; there must be some.
    const Material &of(dealii::types::material_id id) const { return by_id_.at(id); }

    /// Gives a cell, whose material id is set, its material in this unit.
    void assign(HexahedralCell &cell, double unit = 1.) const;

    /// Whether one is isotropic with a Poisson's ratio above 0.4, and ∇·u is replaced.
    bool are_nearly_incompressible() const;

    /// Such materials with the same shear modulus and Poisson's ratio 0.3.
    Materials softened() const;

    /// With ∇·u as it is.
    Materials without_mean_dilatation() const;

    /// Whether all of them are.
    bool are_simple() const;

    /// Whether ∇·u is to be replaced by its mean over each cell.
    bool have_mean_dilatation() const { return have_mean_dilatation_; }

    /// The extreme ones of all materials in the body, Pa.
    double smallest_youngs_modulus() const;
    double largest_youngs_modulus() const;
    double largest_shear_modulus() const;

  private:
    /// Those in the body, and no other.
    std::map<dealii::types::material_id, Material> by_id_;
    bool have_mean_dilatation_;
  };

  /// Gives the coarse cells, and all that came of them, the ids that the entry
  /// Material/Material ids says; if it is empty, they keep those they have.
  ///
  /// Throws InputError if the formula cannot be read or gives no id.
  void assign_material_ids(Body &body, const BodyParameters &parameters);
} // namespace stiction
