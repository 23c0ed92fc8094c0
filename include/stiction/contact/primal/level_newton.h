#pragma once

#include <stiction/contact/primal/contact_state.h>
#include <stiction/contact/primal/newton_system.h>
#include <stiction/contact/primal/primal_interior_point.h>
#include <stiction/qp/solvers/solver_run.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace stiction
{
  class ContactLevel;
  class Multigrid;

  /// The semismooth Newton method for the contact problem on one level of the
  /// mesh, Coulomb's law or given friction.
  ///
  /// The residual of the certificate is what has to fall. When it does not, ρ
  /// is changed, which no solution depends on; when that does not help, it takes turns
  /// with an interior point method, which knows no contact states that could be the
  /// wrong ones. Before that it begins once more from another start, if it is given one.
  class LevelNewton
  {
  public:
    /// What no user has to set. The answer does not depend on it.
    struct Options
    {
      /// ρ over E√A, at the start.
      double first_c = 0.1;
      /// How often it falls back before it counts as standing still.
      unsigned int max_fallbacks = 2;
      /// Whether systems that take too many iterations are factorised, not the end.
      bool factorizes = true;
      /// Whether to do without Newton steps for Coulomb's law or given friction
      /// altogether, to test what they fall back to.
      bool only_fallback = false;
      /// Called once where Newton steps come no closer: assigns another one to the state
      /// that solve() was given, and returns the contact forces to sort nodes by; of size
      /// 0 if there is none. May throw Interrupted on all ranks.
      std::function<Eigen::VectorXd()> other_start = {};
      /// What to choose where this method comes no closer, a part of a
      /// sentence.
      std::string other_method = "choose another 'Contact solver/Method'";
      /// Why linear systems may take many iterations, a part of a sentence.
      std::string hard_systems = "are cells or bodies flat, is a Poisson ratio near 0.5?";
    };

    /// What was done so far.
    struct Statistics : qp::IterationCounts
    {
      /// Of either method.
      unsigned int n_steps() const { return newton_steps + interior_point_steps; }

      unsigned int rho_changes = 0;
      /// The step from which on its systems are solved by factorisation, 0 if
      /// none.
      unsigned int factorized_from = 0;

      /// Adds what was done in another solve.
      Statistics &operator+=(const Statistics &other)
      {
        IterationCounts::operator+=(other);
        rho_changes += other.rho_changes;
        if (factorized_from == 0)
          factorized_from = other.factorized_from;
        return *this;
      }
    };

    /// A step of either method: its Krylov iterations, the residual after it.
    using Observer = std::function<void(const Statistics &, const ContactResidual &)>;

    /// @param level the number of the problem's level for the preconditioner.
    ///   All arguments must outlive the object.
    LevelNewton(const ContactLevel &problem, unsigned int level,
                Multigrid &preconditioner, const Options &options);

    /// Improves the state until its residual is at most the tolerance.
    /// Collective.
    ///
    /// @param first_lambda the contact forces by which the first step sorts the
    ///   nodes; those of an interpolated state are not smooth.
    /// @return why it stopped before; empty if it did not.
    std::string solve(ContactState &state, Eigen::VectorXd first_lambda, double tolerance,
                      unsigned int max_steps, const Observer &observer);

    const Statistics &statistics() const { return statistics_; }

    /// Whether solve() stopped because neither Newton steps nor what they fall back to
    /// came closer.
    bool stands_still() const { return stands_still_; }

  private:
    /// Enters into the statistics that systems are factorised from now on.
    void note_factorization();

    /// The number of steps in which the residual has to fall, after so many times in
    /// which it did not.
    std::size_t fall_horizon(unsigned int stalls, double residual) const;

    /// The residual; where it is small enough, of a state made anew from u, without what
    /// the linear solver carried along. What K u leaves by rounding at open nodes of next
    /// to no area, above the tolerance there, is left to the equilibrium, as the
    /// certificate measures it, where it is far below.
    ContactResidual measure(ContactState &state, double tolerance) const;

    /// If the body is only moved and touches nothing, so that all forces are the rounding
    /// of K u: takes the contact forces away; the verifier has the last word. Collective.
    ///
    /// @return whether it is so.
    bool drop_rounding(ContactState &state, const ContactResidual &residual) const;

    /// Whether no contact node is inside of its obstacle, but for rounding.
    bool touches_only(const ContactState &state) const;

    /// Whether pressures have settled at which friction does not bear the loads of a body
    /// that contact alone holds: it slides, and no step changes that. Collective.
    bool slides(const ContactResidual &residual) const;

    /// solve(), which may leave a state that is worse than the best of the path.
    std::string iterate(ContactState &state, Eigen::VectorXd lambda, double tolerance,
                        unsigned int max_steps, const Observer &observer);

    /// Asks for the other start, if that was not done and steps are left, and solves the
    /// problem from there, all over again.
    ///
    /// @return what solve() does; nothing if there is no other start.
    std::optional<std::string> solve_from_elsewhere(ContactState &state, double tolerance,
                                                    unsigned int max_steps,
                                                    const Observer &observer);

    /// Whether most linear systems take more iterations than they are given.
    bool has_hard_systems() const;

    /// What it says where nothing comes closer to a solution, and what may
    /// help.
    std::string why_no_closer() const;

    /// Keeps the first state with contact forces of bodies that these alone hold: Newton
    /// steps may throw them away.
    void keep_first(const ContactState &state);

    /// One Newton step with the present ρ, from the states that λ sorts nodes into.
    void step(ContactState &state, Eigen::VectorXd lambda,
              const ContactResidual &residual, double tolerance);

    /// The interior point method, from this displacement on or where it was left. Leaves
    /// its best state if that has a smaller residual than the one that is given.
    void fall_back(ContactState &state, double residual, double tolerance,
                   unsigned int max_steps, const Observer &observer);

    const ContactLevel &problem_;
    const unsigned int level_;
    Multigrid &preconditioner_;
    Options options_;
    NewtonSystem system_;
    double c_;
    double fine_above_ = std::numeric_limits<double>::infinity(); // residual, see step()
    bool was_unfinished_ = false;         // the linear system of the last Newton step
    std::unique_ptr<ContactState> first_; // of keep_first()
    std::unique_ptr<PrimalInteriorPoint> path_; // while it can be followed on
    bool stands_still_ = false;

    Statistics statistics_;
  };
} // namespace stiction
