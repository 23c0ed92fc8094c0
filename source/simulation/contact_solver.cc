#include <stiction/base/log.h>
#include <stiction/base/phases.h>
#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/parameters/parameters.h>
#include <stiction/simulation/contact_solver.h>
#include <stiction/simulation/dual_contact_solver.h>
#include <stiction/simulation/primal_contact_solver.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <stdexcept>

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

  void ContactSolver::certify(ContactSolution &solution)
  {
    const auto phase = setting_.phases.scope("certificate");
    verify(solution);
    compute_duality_gap(solution);
  }

  BodyVerifier &ContactSolver::verifier() const
  {
    return *verifier_;
  }

  const DualOperator *ContactSolver::dual_operator() const
  {
    return nullptr;
  }

  std::string ContactSolver::other_method() const
  {
    return advice_on_method(setting_.parameters,
                            setting_.surface.slip_bound().is_coulomb(), true);
  }

  void ContactSolver::print_progress(const std::string &line) const
  {
    if (setting_.parameters.output.print_progress)
      setting_.log.line(line);
  }

  void ContactSolver::compute_duality_gap(const ContactSolution &solution)
  {
    if (!solution.lambda.allFinite())
      return;
    if (solution.interrupted && !solution.converged)
      return; // a figure that only informs, and an elastic solve
    try
      {
        verifier_->certificate().compute_duality_gap(verifier_->displacement(),
                                                     *stiffness_solver_);
      }
    catch (const std::runtime_error &)
      {
        if (!may_lack_duality_gap())
          throw;
        setting_.log.line("The duality gap was not computed: its elastic solve "
                          "did not converge.");
      }
  }
} // namespace stiction
