#pragma once

#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/interface/contact_operator.h>
#include <stiction/qp/rigid_place.h>
#include <stiction/simulation/solvers/contact_solver.h>

#include <Eigen/Core>

#include <set>
#include <string>

namespace stiction
{
  class AugmentedOperator;
  class DeflatedOperator;
  class DualMethod;
  struct EqualityConstraint;

  /// Solves for contact forces: a dual method on Q = B K⁻¹ Bᵀ, newton where 'newton
  /// multigrid' hands over. Forces that press obstacles on, and the balance of a body
  /// that contact alone holds, are equality constraints, which the method of multipliers
  /// meets: any dual method works on the augmented operator.
  class DualContactSolver : public ContactSolver
  {
  public:
    /// @param tried the methods that count as tried if this one comes no closer, none:
    ///   the one that the parameters say.
    explicit DualContactSolver(const Setting &setting, std::set<std::string> tried = {});
    ~DualContactSolver() override;

    SolveStatus solve(State &state, const Observer &observer) override;

    void update() override;

    StiffnessSolver &stiffness_solver() override { return *stiffness_solver_; }

    const DualOperator *dual_operator() const override { return Q_.get(); }

    void add_to(RunResult &result) const override;

  private:
    std::string stiffness_solver_type() const;
    void set_up_stiffness_solver();
    void set_up_dual_operator();

    /// With forces that press obstacles on, or a body that contact alone holds.
    SolveStatus solve_balanced(State &state, const Observer &observer);

    /// Where obstacles and a body with free motions are at the start, with contact
    /// forces: as is known, or as rigid ones come to rest.
    qp::RigidPlace first_guess(const State &state,
                               const EqualityConstraint &balance) const;

    /// Makes the augmented operator. @param start, lambda where the solve begins.
    void augment(const EqualityConstraint &balance, const Eigen::VectorXd &start,
                 const Eigen::VectorXd &lambda);

    /// Multipliers of the augmented operator as places.
    BodyVerifier::Places places(const Eigen::VectorXd &multipliers,
                                const Eigen::VectorXd &lambda) const;

    /// From the multipliers of the augmented operator: Newton's step on Gᵀλ(α) = e.
    Eigen::VectorXd newton_step(const Eigen::VectorXd &lambda) const;

    void print_places(const State &state) const;

    /// With this operator in place of Q.
    SolveStatus solve_with(const DualOperator &Q, BodyVerifier &verifier,
                           double tolerance, const Observer &observer,
                           Eigen::VectorXd &lambda);

    /// What methods work on: Q, or what augments it.
    const DualOperator &present_operator() const;

    /// Has the next solve make the method anew; what this one did still counts.
    void forget_method();

    /// How far the obstacles go under these contact forces, one column each, m.
    Eigen::VectorXd yielding(const DualOperator &Q, const Eigen::MatrixXd &lambda) const;

    std::unique_ptr<DualOperator> Q_;
    ContactOperator B_;          ///< of Q
    Eigen::MatrixXd compliance_; ///< of which Q is made, once frames turned
    std::unique_ptr<DeflatedOperator> deflated_; ///< of a body with free motions
    std::unique_ptr<AugmentedOperator> augmented_;
    const std::set<std::string> tried_;
    std::unique_ptr<DualMethod> method_;  ///< of the last solve
    DualMethodStatistics earlier_;        ///< of methods before it
    double earlier_multiplications_ = 0.; ///< of augmented operators before
  };
} // namespace stiction
