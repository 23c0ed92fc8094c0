#ifndef stiction_simulation_primal_contact_solver_h
#define stiction_simulation_primal_contact_solver_h

#include <stiction/simulation/contact_solver.h>

namespace stiction
{
  class NewtonMultigrid;

  /// Solves for displacements, by NewtonMultigrid.
  class PrimalContactSolver : public ContactSolver
  {
  public:
    explicit PrimalContactSolver(const Setting &setting);
    ~PrimalContactSolver() override;

    ContactSolution solve(const Observer &observer) override;

    nlohmann::json to_json() const override;

  private:
    void verify(ContactSolution &solution) override;

    /// On very flat cells conjugate gradients may fail where the method itself
    /// did not.
    bool may_lack_duality_gap() const override { return true; }

    std::unique_ptr<NewtonMultigrid> newton_;
  };
} // namespace stiction

#endif
