#ifndef stiction_simulation_dual_contact_solver_h
#define stiction_simulation_dual_contact_solver_h

#include <stiction/qp/solvers/solver_run.h>
#include <stiction/simulation/contact_solver.h>

#include <Eigen/Core>

namespace stiction
{
  class AugmentedOperator;
  class BodyVerifier;
  class DualMethod;

  /// Solves for contact forces: a dual method on Q = B K⁻¹ Bᵀ, newton where 'newton
  /// multigrid' hands over. Forces that press obstacles on are equality constraints,
  /// which the method of multipliers meets: any dual method works on the augmented
  /// operator.
  class DualContactSolver : public ContactSolver
  {
  public:
    explicit DualContactSolver(const Setting &setting);
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

    /// With forces that press obstacles on.
    SolveStatus solve_pressed(State &state, const Observer &observer);

    void print_places(const State &state) const;

    /// With this operator in place of Q.
    SolveStatus solve_with(const DualOperator &Q, BodyVerifier &verifier,
                           double tolerance, const Observer &observer,
                           Eigen::VectorXd &lambda);

    /// Has the next solve make the method anew; what this one did still counts.
    void forget_method();

    /// How far the obstacles go under these contact forces, one column each, m.
    Eigen::VectorXd yielding(const Eigen::MatrixXd &lambda) const;

    std::unique_ptr<DualOperator> Q_;
    std::unique_ptr<AugmentedOperator> augmented_; ///< of pressed obstacles
    std::unique_ptr<DualMethod> method_;           ///< of the last solve
    qp::IterationCounts earlier_;                  ///< of methods before it
    double earlier_multiplications_ = 0.;          ///< of augmented operators before
  };
} // namespace stiction

#endif
