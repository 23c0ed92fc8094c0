#pragma once

#include <stiction/contact/primal/contact_level.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/qp/contact_conditions.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>

namespace stiction
{
  /// A displacement on a level of the mesh and what follows from it, in the basis of
  /// ContactLevel.
  struct ContactState
  {
    /// Room for one on this level, all zero.
    explicit ContactState(const ContactLevel &problem);

    LA::Vector u;              ///< m
    Eigen::VectorXd distances; ///< δ of pressed obstacles, m
    LA::Vector R;              ///< f − Ku, N
    Eigen::VectorXd lambda;    ///< the contact forces y, Bᵀy = R, N
    Eigen::VectorXd w;         ///< Bu − e = (penetration; slip), m

    /// Sets R, λ and w from u and δ by a product with K. Collective.
    void update(const ContactLevel &problem);

    /// Takes away forces at nodes whose gap is larger than their pressure, in these
    /// scales, and where no friction acts without pressure. They are then missing in the
    /// equilibrium of the certificate; that of ContactResidual leaves these nodes out.
    ///
    /// @return the sum of their norms, N.
    double release_open_nodes(const ContactLevel &problem, const qp::Scaling &scaling);

    /// Goes back to a part of the way to here from another state of this level.
    void go_back(const ContactState &before, double part);
  };

  /// How far a state is from being the solution, in the figures and scales of
  /// the certificate.
  struct ContactResidual
  {
    /// @param slip_bound that of the problem, or another one. Collective.
    ContactResidual(const ContactLevel &problem, const ContactState &state,
                    const qp::SlipBound &slip_bound);

    double force_scale;           ///< S, N
    ContactConditions conditions; ///< with their scales
    double equilibrium;           ///< Σ‖R_j‖/S, contact and fixed nodes left out
    double obstacle_force;        ///< relative error of the prescribed forces

    /// The largest figure that decides.
    double value() const;

  private:
    ContactResidual(const ContactLevel &problem, const ContactState &state,
                    const qp::SlipBound &slip_bound, const ContactLevel::Scales &scales);
  };
} // namespace stiction
