#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/pairs/slave_side.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/solvers/multigrid_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/run_result.h>
#include <stiction/simulation/parameters/memory_estimates.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/solvers/coarser_meshes.h>
#include <stiction/simulation/solvers/dual_contact_solver.h>
#include <stiction/simulation/solvers/primal_contact_solver.h>

namespace stiction
{
  namespace
  {
    // The duality gap needs a few digits of one more elastic solve only.
    constexpr double duality_gap_accuracy = 1e-6;

    // An iterate with a larger residual is a worse start for it than none: a body that
    // contact alone holds may have left.
    constexpr double residual_of_start = 0.1;

    // Up to here the dual method newton, which factorises once, is the faster one, above
    // all in load steps.
    constexpr unsigned int small_body = 10000, small_contact = 2000;

    // Up to here it is where multigrid is no good: the other one factorises in each step.
    constexpr unsigned int medium_contact = 6000;

    const std::set<std::string> both_methods = {"newton", "newton multigrid"};
  } // namespace

  PrimalContactSolver::PrimalContactSolver(const Setting &setting)
    : ContactSolver(setting)
    , can_hand_over_(can_hand_over())
  {
    if (const std::string why = why_not_at_all(); !why.empty())
      {
        print_progress(why);
        dual_ =
          std::make_unique<DualContactSolver>(setting_, std::set<std::string>{"newton"});
        return;
      }
    const auto phase             = setting_.phases.scope("stiffness_setup");
    const Parameters &parameters = setting_.parameters;
    print_progress("Newton method in displacements: " +
                   parameters.stiffness_solver_type());
    LevelNewton::Options options;
    options.other_method = other_method();
    if (parameters.dual_operator.form == "assembled" &&
        !has_memory_to_hand_over(
          parameters, static_cast<double>(setting_.surface.B().all_dofs().size()),
          setting_.elasticity.body().communicator()))
      options.other_method += " with 'Dual operator/Form = by solves', as there is no "
                              "memory for its matrix";
    if (setting_.surface.has_wavering_side())
      options.hard_systems =
        "the forces of a pair are on its stiffer side, whose cells are not larger by a "
        "quarter, see 'Slave side'; " +
        options.hard_systems;
    // Where systems are hard since a material hardly changes its volume, contact states
    // are found in few steps; flexible bodies are better off with factors than with
    // 'newton'.
    const bool is_flexible = parameters.material.largest_poisson_ratio() <=
                             MaterialParameters::locking_poisson_ratio;
    if (can_hand_over_)
      options.factorizes = !parameters.contact_solver.is_automatic ||
                           (is_flexible && setting_.elasticity.mesh().n_dofs() <=
                                             Multigrid::max_factorized) ||
                           3 * setting_.surface.n_nodes() > medium_contact ||
                           setting_.elasticity.free_motions().n() > 0;
    try
      {
        newton_ = std::make_unique<NewtonMultigrid>(setting_.elasticity, setting_.surface,
                                                    parameters.is_matrix_free(), options);
        if (newton_->finest_level() == 0 && CoarserMeshes::are_there(setting_))
          coarser_meshes_ = std::make_unique<CoarserMeshes>(setting_);
      }
    catch (const CircleOfSlaves &)
      {
        if (can_hand_over_)
          {
            print_progress("Bodies follow each other in a circle, which 'newton' takes:");
            dual_ = std::make_unique<DualContactSolver>(setting_, both_methods);
            return;
          }
        parameters.source.refuse(
          "Boundary conditions/Slave side",
          "makes bodies follow each other in a circle where contact pairs meet at a "
          "node, must say 'boundary' or 'obstacle' for each pair so that they do not, "
          "for 'Contact solver/Method = newton multigrid'; the method 'newton' takes "
          "these");
      }
  }

  PrimalContactSolver::~PrimalContactSolver() = default;

  SolveStatus PrimalContactSolver::solve_for_displacements(State &state,
                                                           ContactStep &last,
                                                           const Observer &observer)
  {
    const auto phase = setting_.phases.scope("displacement_iteration");
    const ContactSolverParameters &chosen = setting_.parameters.contact_solver;
    const auto on_coarser_meshes          = [&](ContactStep &step) {
      print_progress("Newton steps come no closer: the problem is solved on coarser "
                                       "meshes to begin with.");
      State start = coarser_meshes_->find(state, step, observer);
      last.step   = step.step; // the residual remains that of this mesh
      if (start.u.size() == 0)
        print_progress("They are of no use: it goes on where it was.");
      return start;
    };
    const SolveStatus status = newton_->solve(
      state, chosen.tolerance, chosen.maximum_iterations,
      [&](const ContactStep &step) {
        last = step;
        observer(step);
      },
      coarser_meshes_ && state.u.size() == 0
        ? NewtonMultigrid::OtherStart(on_coarser_meshes)
        : nullptr);
    setting_.elasticity.distribute(state.u);
    return status;
  }

  SolveStatus PrimalContactSolver::solve(State &state, const Observer &observer)
  {
    ContactStep last;
    if (!newton_ || is_dual_alone_)
      return solve_dual(state, last, observer);

    const State before       = can_hand_over_ ? state : State();
    const SolveStatus status = solve_for_displacements(state, last, observer);
    if (status.converged && is_let_go(before, state))
      return look_whether_held(status, before, state, last, observer);
    if (status.stands_still && !status.interrupted && can_hand_over_)
      return hand_over(state, last, observer);
    return status;
  }

  SolveStatus PrimalContactSolver::solve_dual(State &state, ContactStep &last,
                                              const Observer &observer)
  {
    if (!dual_)
      dual_ = std::make_unique<DualContactSolver>(setting_, both_methods);
    return dual_->solve(state, [&, n_before = last.step](ContactStep step) {
      step.step += n_before;
      step.unknowns = setting_.elasticity.mesh().n_dofs();
      last.step     = step.step;
      observer(step);
    });
  }

  SolveStatus PrimalContactSolver::hand_over(State &state, ContactStep &last,
                                             const Observer &observer)
  {
    const auto n_dual = static_cast<unsigned int>(3 * setting_.surface.n_nodes());
    print_progress("Newton steps in displacements come no closer, 'newton' goes on" +
                   (n_dual > medium_contact
                      ? format(", which may take minutes with %u dual unknowns:", n_dual)
                      : ":"));
    const auto forget  = [&]() { state = {{}, {}, {}, state.history, state.scales}; };
    const bool is_warm = last.residual < residual_of_start;
    if (!is_warm)
      forget();
    const SolveStatus status = solve_dual(state, last, observer);
    is_dual_alone_           = status.converged && n_dual <= medium_contact;
    if (status.converged || status.interrupted || !is_warm)
      return status;
    print_progress("Once more, without what was found:");
    forget();
    return solve_dual(state, last, observer);
  }

  SolveStatus PrimalContactSolver::look_whether_held(SolveStatus status,
                                                     const State &before, State &state,
                                                     ContactStep &last,
                                                     const Observer &observer)
  {
    print_progress("Contact bears nothing any more, 'newton' looks whether friction "
                   "holds what it bore:");
    const State let_go     = std::exchange(state, before);
    const SolveStatus held = solve_dual(state, last, observer);
    if (held.converged && !is_let_go(before, state))
      return held;
    state              = let_go;
    status.interrupted = held.interrupted;
    return status;
  }

  bool PrimalContactSolver::is_let_go(const State &before, const State &after) const
  {
    const auto pressing = [&](const State &state) {
      return state.lambda.head(setting_.surface.n_nodes()).sum();
    };
    return setting_.elasticity.free_motions().n() > 0 &&
           before.lambda.size() == after.lambda.size() && pressing(before) > 0. &&
           pressing(after) <=
             setting_.parameters.contact_solver.tolerance * pressing(before);
  }

  std::string PrimalContactSolver::why_not_at_all() const
  {
    if (!setting_.parameters.contact_solver.is_automatic || !can_hand_over_)
      return "";
    if (setting_.surface.has_wavering_side())
      return "Method: newton, since forces of a pair are on its stiffer side, whose "
             "cells are not larger by a quarter";
    if (setting_.elasticity.free_motions().n() == 0 &&
        setting_.elasticity.mesh().n_dofs() <= small_body &&
        3 * setting_.surface.n_nodes() <= small_contact)
      return "Method: newton, since the body is small";
    return "";
  }

  bool PrimalContactSolver::can_hand_over() const
  {
    return setting_.elasticity.mesh().n_dofs() <= max_for_newton;
  }

  void PrimalContactSolver::update()
  {
    if (newton_ && !is_dual_alone_)
      newton_->update();
    if (dual_)
      dual_->update();
  }

  StiffnessSolver &PrimalContactSolver::stiffness_solver()
  {
    if (dual_)
      return dual_->stiffness_solver();
    if (setting_.surface.B().has_other_side()) // its levels are in another basis
      stiffness_solver_ =
        std::make_unique<MultigridSolver>(setting_.elasticity, duality_gap_accuracy);
    else
      stiffness_solver_ = std::make_unique<MultigridSolver>(
        setting_.elasticity, newton_->preconditioner(), newton_->finest_level(),
        newton_->free_supports(), duality_gap_accuracy);
    return *stiffness_solver_;
  }

  void PrimalContactSolver::add_to(RunResult &result) const
  {
    if (coarser_meshes_)
      result.solver = coarser_meshes_->statistics();
    if (newton_)
      add_method(result.solver, *newton_);
    if (!dual_)
      return;
    RunResult dual;
    dual_->add_to(dual);
    result.solver += dual.solver;
    result.solver.dual_multiplications = dual.solver.dual_multiplications;
    result.solver.stiffness_solves     = dual.solver.stiffness_solves;
    result.solver.handed_over_to       = "newton";
  }
} // namespace stiction
