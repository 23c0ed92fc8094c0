#pragma once

#include <stiction/qp/sets/feasible_set.h>

#include <Eigen/Core>

#include <limits>

namespace stiction
{
  /// Of a double when it is rounded, relative: 2⁻⁵³.
  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2.;

  /// Forces of up to this many times the rounding of K u are nothing else.
  constexpr double only_rounding = 100.;

  /// What rounding leaves of gaps that a displacement makes, as a part of it.
  constexpr double rounding_of_gaps = 1e-12;

  /// That 'Contact solver/Tolerance' may have.
  constexpr double largest_tolerance = 1e-2;

  /// Up to where a residual may be a matter of rounding, not of the method. On its
  /// way to the residual rounding grows by what linear systems are conditioned: on
  /// bodies of one material by some thousands.
  ///
  /// @param rounding what rounding alone makes of it, an estimate.
  inline double reach_of_rounding(const double rounding) { return 1e4 * rounding; }

  inline bool is_rounding(const double residual, const double rounding)
  {
    return residual <= reach_of_rounding(rounding);
  }

  /// What a scale of displacements has to know of the body behind the contact
  /// boundary: Young's moduli in Pa.
  struct ContactStiffness
  {
    Eigen::VectorXd youngs_moduli; ///< of the cells behind each contact node, of the
                                   ///< softer body of a pair
    double softest = 0.;           ///< of the whole body

    /// Springs E_i A_i/L under the contact nodes, N/m: together they are about as stiff
    /// as a body of the size L, m, on a cross-section of the @p areas, m².
    Eigen::VectorXd foundation(const Eigen::VectorXd &areas, const double size) const
    {
      return youngs_moduli.cwiseProduct(areas) / size;
    }
  };

  /// A scale to divide by: 1 where there is nothing to measure.
  inline double nonzero(const double scale) { return scale == 0. ? 1. : scale; }

  /// The scales in which the certificate measures contact forces and remaining
  /// gaps.
  ///
  /// A nodal force is worth A_i p0 with p0 = S/|Γc|. A displacement is worth
  /// u0 = uᵀKu/S, how far the forces S move the body, though no less than 1e-8 of
  /// p0 √|Γc|/E (see below), wherever its cells behind
  /// the contact boundary are as soft as any. Where they are stiffer it is
  /// worth less: a soft part far from the contact face may move by any distance
  /// and says nothing of the gaps that matter to the contact forces. At node i
  /// it is then worth
  ///
  ///     u0 min(1, max(E_soft/E_i, p0 √|Γc|/(E_i u0))):
  ///
  /// the first is what u0 would be were all cells as stiff as those at the
  /// node, the second how far a pressure p0 on the contact face alone presses
  /// it in (a half-space gives way by about p0 √|Γc|/E), which counts where the
  /// soft part carries no load. A body of one material has u0 everywhere.
  ///
  /// @param S force scale, N. @param energy uᵀKu in J.
  /// @param areas nodal areas in m². @param boundary_area |Γc| in m².
  qp::Scaling contact_scaling(double S, double energy, const Eigen::VectorXd &areas,
                              double boundary_area, const ContactStiffness &stiffness);
} // namespace stiction
