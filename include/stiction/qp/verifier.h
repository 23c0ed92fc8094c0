#pragma once

#include <stiction/qp/contact_conditions.h>
#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/Core>

#include <memory>

namespace stiction
{
  class DualOperator;

  /// What decides whether contact forces solve the problem, whatever method
  /// found them.
  class Verifier
  {
  public:
    virtual ~Verifier() = default;

    /// The figures of these contact forces, computed afresh; valid until the
    /// next call. Collective.
    virtual const ContactConditions &verify(const Eigen::VectorXd &lambda) = 0;
  };

  /// The verifier of a problem that is known by Q and h alone: r = Qλ − h by a
  /// fresh product. There is no body whose equilibrium could be checked.
  class DualProblemVerifier : public Verifier
  {
  public:
    /// @param areas nodal areas, or empty: then all nodes count alike.
    DualProblemVerifier(const DualOperator &Q, const qp::SlipBound &slip_bound,
                        const Eigen::VectorXd &areas);

    /// Scales: S = Σ‖λ_i‖ shared out by areas, u0 = λᵀQλ/S.
    const ContactConditions &verify(const Eigen::VectorXd &lambda) override;

  private:
    const DualOperator &Q_;
    const qp::SlipBound &slip_bound_;
    Eigen::VectorXd share_; ///< of a node in the force, sum 1
    std::unique_ptr<ContactConditions> conditions_;
  };
} // namespace stiction
