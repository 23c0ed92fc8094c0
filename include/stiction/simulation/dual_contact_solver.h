#ifndef stiction_simulation_dual_contact_solver_h
#define stiction_simulation_dual_contact_solver_h

#include <stiction/simulation/contact_solver.h>

namespace stiction
{
  class DualMethod;

  /// Solves for contact forces: a dual method on Q = B K⁻¹ Bᵀ, and a search
  /// around it where forces press obstacles on.
  class DualContactSolver : public ContactSolver
  {
  public:
    explicit DualContactSolver(const Setting &setting);
    ~DualContactSolver() override;

    ContactSolution solve(const Observer &observer) override;

    const DualOperator *dual_operator() const override { return Q_.get(); }

    nlohmann::json to_json() const override;

  private:
    void set_up_stiffness_solver();
    void set_up_dual_operator();

    /// With the obstacles where they are.
    ContactSolution solve_there(double tolerance, const Eigen::VectorXd &start,
                                const Observer &observer);

    std::unique_ptr<DualOperator> Q_;
    std::unique_ptr<DualMethod> method_; ///< of the last solve
  };
} // namespace stiction

#endif
