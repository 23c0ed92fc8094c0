#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/lac/vector.h>

#include <Eigen/Core>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;

  /// An estimate of the error of the displacement of a contact problem in the
  /// energy norm, cell by cell, from what its stress lacks to be in
  /// equilibrium:
  ///
  ///   η_K² = Σ_F h/(6k) ∫_F J·A⁻¹J
  ///        + (k > 1) Σ_d h_d²/60 ∫_K r_d·A_d⁻¹r_d + ‖r − Σ_d r_d‖²_K V^⅔/(60
  ///        E)
  ///        + Σ_{F on Γc} (E/h ‖g⁻‖²_F + ∫_F p g⁺)
  ///
  /// k is the degree of the elements, h the height of the cell above its face F
  /// and A_il = n_j C_ijkl n_k the stiffness against a jump of ∂u/∂n. Between
  /// two cells J is the jump of σn, of which this cell takes the part h/(h +
  /// h'); on the boundary it is t − σn without the components in which the
  /// displacement is prescribed, and on the contact boundary t_c − σn, with t_c
  /// interpolated from the nodal contact tractions −(Bᵀλ)_i/A_i. r = b + div σ
  /// is the residual inside, V the volume, and r_d the part of r that is linear
  /// across the cell in its direction d.
  ///
  /// The constants are those with which the estimate becomes exact on bricks
  /// where the solution is smooth: there the error of trilinear elements is
  /// that of linear interpolation, h²/8 of the second derivative in each
  /// direction, and shows in the jumps alone; that of triquadratic ones shows
  /// inside (I. Babuška, D. Yu, Asymptotically exact a posteriori error
  /// estimator for biquadratic elements, 1987; D. Yu on odd degrees, 1991). It
  /// is an estimate, no bound. Measured: 0.99 to 1.01 of the error for a smooth
  /// load, 0.84 to 0.90 for the reference brick without friction, whose clamped
  /// edges make the solution singular, 1.04 to 1.35 and 0.98 to 0.99 with
  /// triquadratic elements; on a mesh of one element across such a brick, 0.34.
  ///
  /// The last two terms see what contact conditions at nodes do not: with g =
  /// d − n·u, the linearised gap to the obstacle at any point, its penetration
  /// g⁻ between the nodes of a curved obstacle, and the work p g⁺ of a pressure
  /// p across an open gap. g is taken from the curved boundary that faces stand for, see
  /// SmoothBoundary. (After A. Veeser, Efficient and reliable a posteriori error
  /// estimators for elliptic obstacle problems, 2001, and P. Hild, S. Nicaise, A
  /// posteriori error estimations of residual type for Signorini's problem, 2005.) What
  /// friction does between the nodes is left out.
  ///
  /// @param state the solution.
  /// @return the squares η_K², J, by active cells; zero for those of other
  ///   ranks. Throws InputError where a formula has no finite value, or an
  ///   obstacle no normal. Collective.
  dealii::Vector<double> estimate_error(const LinearElasticity &elasticity,
                                        const ContactSurface &surface,
                                        const State &state);

  /// The estimated error of a whole mesh.
  struct MeshError
  {
    double square              = 0.; ///< Σ η_K², J
    bool is_sampled            = false;
    unsigned long long n_cells = 0; ///< that were looked at
  };

  /// Σ η_K², and for a mesh of many cells an estimate of that from a sample:
  /// of the cells that came of one coarser by two levels (by one, up to four
  /// times as many cells as are all looked at), one is drawn at random; of the
  /// few such families that seem to have the largest errors, all are taken. The
  /// sample is the same for any number of ranks.
  ///
  /// Measured over sixteen draws against all cells, the root of the sum has a
  /// standard deviation of 0.8 % and 1.8 % on the reference brick with 162
  /// thousand and 1.2 million unknowns, 1.2 % on the half ball and 0.2 % for
  /// Hertz' contact, whose error is in few families; at most it was 5 % off.
  ///
  /// Parameters as above. @param all_up_to how many cells are all looked at.
  /// Throws InputError as above. Collective.
  MeshError estimate_mesh_error(const LinearElasticity &elasticity,
                                const ContactSurface &surface, const State &state,
                                unsigned long long all_up_to = 16384);
} // namespace stiction
