#include <stiction/contact/certificate/body_verifier.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <utility>

namespace stiction
{
  BodyVerifier::BodyVerifier(const LinearElasticity &elasticity,
                             const ContactSurface &surface, StiffnessSolver &solver,
                             State &state, PlacesOf places)
    : elasticity_(elasticity)
    , surface_(surface)
    , solver_(solver)
    , state_(state)
    , places_(std::move(places))
  {
  }

  BodyVerifier::~BodyVerifier() = default;

  const ContactConditions &BodyVerifier::verify(const Eigen::VectorXd &lambda)
  {
    LA::Vector force    = elasticity_.constrained_load();
    const Places places = places_(lambda);
    surface_.B().add_load(-1., lambda, force);
    if (places.lacking.size() > 0)
      surface_.B().add_load(-1., places.lacking, force);
    state_.u = elasticity_.zero_vector();
    solver_.solve(state_.u, force);
    elasticity_.distribute(state_.u);
    elasticity_.add_free_motion(places.free_motion, state_.u);
    state_.lambda    = lambda;
    state_.distances = places.distances;
    certificate_     = std::make_unique<Certificate>(elasticity_, surface_, state_);
    return *certificate_;
  }
} // namespace stiction
