#pragma once

#include <stiction/qp/certified_solve.h>

#include <functional>
#include <memory>
#include <set>
#include <string>

namespace stiction
{
  class ContactSurface;
  class DualOperator;
  class LinearElasticity;
  class Log;
  class Parameters;
  class Phases;
  struct State;
  class StiffnessSolver;
  struct RunResult;

  /// Solves the contact problem on one mesh, whatever it takes for unknowns: set
  /// up once, solves as often as loads and obstacles change.
  class ContactSolver
  {
  public:
    using Observer = std::function<void(const ContactStep &)>;

    /// What a solver works on and reports to; all must outlive it.
    struct Setting
    {
      const Parameters &parameters;
      const LinearElasticity &elasticity;
      const ContactSurface &surface;
      Log &log;
      Phases &phases;
    };

    /// The solver that the parameters ask for, set up. Collective.
    static std::unique_ptr<ContactSolver> create(const Setting &setting);

    virtual ~ContactSolver();

    /// Solves until the tolerance is reached or nothing helps any more.
    /// Collective.
    ///
    /// @param state in: what is known of the solution, or nothing; out: the
    ///   solution.
    /// @param observer called after every step; may throw Interrupted on all
    ///   ranks, which ends the iteration with what is reached.
    /// @return how it ended, as far as the solver knows; the certificate decides.
    virtual SolveStatus solve(State &state, const Observer &observer) = 0;

    /// Takes loads, supports, gaps, frames and friction afresh; B must be what it was, or
    /// is_turned(). Factorises nothing. Collective.
    virtual void update() = 0;

    /// K⁻¹, to some digits, until the next solve(). Collective.
    virtual StiffnessSolver &stiffness_solver() = 0;

    /// Q and h, if the solver has them; otherwise null.
    virtual const DualOperator *dual_operator() const;

    /// Enters what the solver did.
    virtual void add_to(RunResult &result) const = 0;

  protected:
    explicit ContactSolver(const Setting &setting);

    /// What to choose where the method comes no closer, of methods that were not tried.
    std::string other_method(const std::set<std::string> &tried = {}) const;

    void print_progress(const std::string &line) const;

    const Setting setting_;
    std::unique_ptr<StiffnessSolver> stiffness_solver_;
  };
} // namespace stiction
