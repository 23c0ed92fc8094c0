#include <stiction/base/log.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/solvers/contact_solver.h>
#include <stiction/simulation/solvers/dual_contact_solver.h>
#include <stiction/simulation/solvers/primal_contact_solver.h>

namespace stiction
{
  ContactSolver::ContactSolver(const Setting &setting)
    : setting_(setting)
  {
  }

  ContactSolver::~ContactSolver() = default;

  std::unique_ptr<ContactSolver> ContactSolver::create(const Setting &setting)
  {
    if (setting.parameters.contact_solver.is_primal())
      return std::make_unique<PrimalContactSolver>(setting);
    return std::make_unique<DualContactSolver>(setting);
  }

  const DualOperator *ContactSolver::dual_operator() const { return nullptr; }

  std::string ContactSolver::other_method(const std::set<std::string> &tried) const
  {
    return setting_.parameters.advice_on_method(
      setting_.surface.slip_bound().is_coulomb(), true, tried);
  }

  void ContactSolver::print_progress(const std::string &line) const
  {
    if (setting_.parameters.output.print_progress)
      setting_.log.line(line);
  }
} // namespace stiction
