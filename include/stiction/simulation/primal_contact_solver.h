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

    SolveStatus solve(State &state, const Observer &observer) override;

    void update() override;

    StiffnessSolver &stiffness_solver() override;

    void add_to(RunResult &result) const override;

  private:
    std::unique_ptr<NewtonMultigrid> newton_;
  };
} // namespace stiction

#endif
