#ifndef stiction_contact_error_estimator_h
#define stiction_contact_error_estimator_h

#include <stiction/elasticity/linear_algebra.h>

#include <deal.II/lac/vector.h>

#include <Eigen/Core>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;

  /// A residual error estimator for the displacement of a contact problem, in
  /// the energy norm, cell by cell:
  ///
  ///   η_K² = h²/E ‖b + div σ‖²_K + Σ_F h_F/E ‖J_F‖²_F
  ///        + Σ_{F on Γc} (E/h_F ‖g⁻‖²_F + ∫_F p g⁺)
  ///
  /// with h the diameter of a cell or face. Between two cells J_F is half the
  /// jump of σn; on the boundary it is t − σn without the components in which
  /// the displacement is prescribed, and on the contact boundary t_c − σn, with
  /// t_c interpolated from the nodal contact tractions −(Bᵀλ)_i/A_i. Where a
  /// node of the contact boundary is held and its contact force is not known,
  /// that is the mean of the face's other nodes.
  ///
  /// The last two terms see what contact conditions at nodes do not: with g =
  /// d − n·u, the linearised gap to the obstacle at any point, its penetration
  /// g⁻ between the nodes of a curved obstacle, and the work p g⁺ of a pressure
  /// p across an open gap. (After A. Veeser, Efficient and reliable a
  /// posteriori error estimators for elliptic obstacle problems, 2001, and P.
  /// Hild, S. Nicaise, A posteriori error estimations of residual type for
  /// Signorini's problem, 2005.)
  ///
  /// Constants are left out, and so is what friction does between the nodes:
  /// the estimate steers the refinement of the mesh, it certifies nothing.
  ///
  /// @param u the displacement of the solution (m) and @p lambda its contact
  ///   forces (N).
  /// @return the squares η_K², J, by active cells; zero for those of other
  ///   ranks. Throws InputError where a formula has no finite value.
  ///   Collective.
  dealii::Vector<double>
  estimate_error(const LinearElasticity &elasticity,
                 const ContactSurface &surface,
                 const LA::Vector &u,
                 const Eigen::VectorXd &lambda);
} // namespace stiction

#endif
