#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

namespace stiction
{
  BodyVerifier::BodyVerifier(const LinearElasticity &elasticity,
                             const ContactSurface &surface, StiffnessSolver &solver)
    : elasticity_(elasticity)
    , surface_(surface)
    , solver_(solver)
  {
  }

  BodyVerifier::~BodyVerifier() = default;

  const ContactConditions &BodyVerifier::verify(const Eigen::VectorXd &lambda)
  {
    LA::Vector force = elasticity_.constrained_load();
    surface_.B().add_transpose(-1., lambda, force);
    LA::Vector u = elasticity_.zero_vector();
    solver_.solve(u, force);
    return verify(u, lambda);
  }

  const ContactConditions &BodyVerifier::verify(const LA::Vector &u,
                                                const Eigen::VectorXd &lambda)
  {
    u_ = std::make_unique<LA::Vector>(u);
    elasticity_.distribute(*u_);
    certificate_ = std::make_unique<Certificate>(elasticity_, surface_, *u_, lambda);
    return *certificate_;
  }
} // namespace stiction
