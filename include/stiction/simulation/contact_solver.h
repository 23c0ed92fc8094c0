#ifndef stiction_simulation_contact_solver_h
#define stiction_simulation_contact_solver_h

#include <stiction/qp/certified_solve.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>

namespace stiction
{
  class BodyVerifier;
  class ContactSurface;
  class DualOperator;
  class ForceControl;
  class LinearElasticity;
  class Log;
  class Parameters;
  class Phases;
  class StiffnessSolver;

  /// Solves the contact problem on one mesh and has its answer certified,
  /// whatever it takes for unknowns: set up once, solves as often as loads and
  /// obstacles change.
  class ContactSolver
  {
  public:
    using Observer = std::function<void(const ContactStep &)>;

    /// What a solver works on and reports to; all must outlive it.
    struct Setting
    {
      const Parameters &parameters;
      const LinearElasticity &elasticity;
      ContactSurface &surface; ///< the obstacles of which it may move
      ForceControl *control;   ///< of pressed obstacles, or null
      Log &log;
      Phases &phases;
    };

    /// The solver that the parameters ask for, set up. Collective.
    static std::unique_ptr<ContactSolver> create(const Setting &setting);

    virtual ~ContactSolver();

    /// Solves until the certificate is reached or nothing helps any more.
    /// Collective.
    ///
    /// @param observer called after every step; may throw Interrupted on all
    ///   ranks, which ends the iteration with what is reached.
    virtual ContactSolution solve(const Observer &observer) = 0;

    /// Completes the certificate of the solution, which is at the latest made
    /// here. Collective.
    void certify(ContactSolution &solution);

    /// The displacement of the last solution and its certificate.
    BodyVerifier &verifier() const;

    /// Q and h, if the solver has them; otherwise null.
    virtual const DualOperator *dual_operator() const;

    /// The section "solver" of summary.json, as far as it is the solver's.
    virtual nlohmann::json to_json() const = 0;

  protected:
    explicit ContactSolver(const Setting &setting);

    /// Has a solution judged that was not yet.
    virtual void verify(ContactSolution &) {}

    /// Whether the duality gap may be left out if its elastic solve fails.
    virtual bool may_lack_duality_gap() const { return false; }

    /// What to choose where the method comes no closer.
    std::string other_method() const;

    void print_progress(const std::string &line) const;

    const Setting setting_;
    std::unique_ptr<StiffnessSolver> stiffness_solver_;
    std::unique_ptr<BodyVerifier> verifier_;

  private:
    void compute_duality_gap(const ContactSolution &solution);
  };
} // namespace stiction

#endif
