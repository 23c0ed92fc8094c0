#include <stiction/contact/certificate/duality_gap.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The prox step of the duality gap is valid with any stiffness, and best
    // with that of a node on the body: its own diagonal entry of K counts the
    // neighbours as fixed. On the reference brick the bound is 3.3 times the
    // error with 0.1, 3.1 with 0.03, 7 with 0.3 and with 0.01.
    constexpr double prox_stiffness = 0.1;
  } // namespace

  double duality_gap(const LinearElasticity &elasticity, const ContactSurface &surface,
                     const State &state, StiffnessSolver &solver)
  {
    const Eigen::Index m = surface.n_nodes();

    // The frozen bound, and the forces made feasible.
    Eigen::VectorXd feasible = state.lambda;
    const qp::HalfLinesTimesDiscs feasible_set(surface.slip_bound().at(feasible));
    feasible_set.project(feasible);

    // One prox step with a part k of the stiffness of the node itself,
    // λ̂ = P(λ + k w), p = w − (λ̂ − λ)/k with w = Bu − (d; 0; 0). By the
    // projection p is normal to the feasible set at λ̂: p_ν ≤ 0, λ̂_ν p_ν = 0,
    // g‖p_t‖ = λ̂_t·p_t.
    const Eigen::VectorXd K_diagonal =
      surface.B().dofs().restriction(elasticity.stiffness_diagonal());
    const Eigen::VectorXd k = prox_stiffness * K_diagonal.head(m)
                                                 .cwiseMax(K_diagonal.segment(m, m))
                                                 .cwiseMax(K_diagonal.tail(m))
                                                 .replicate(3, 1);
    const Eigen::VectorXd w =
      surface.B().apply(state.u) - surface.motion().offset(state.distances);
    Eigen::VectorXd lambda_hat = feasible + k.cwiseProduct(w);
    feasible_set.project(lambda_hat);
    const Eigen::VectorXd shift = (lambda_hat - feasible).cwiseQuotient(k); // w − p

    // What is left of the gap is ½ sᵀK⁻¹s with s = f − Bᵀλ̂ − Kû and
    // û = u − M⁻¹(w − p), so that Bû is p but for the gap: K⁻¹s is M⁻¹(w − p)
    // plus what u lacks to be in equilibrium with λ̂.
    LA::Vector lacking = elasticity.load();
    surface.B().add_transpose(-1., lambda_hat, lacking);
    lacking -= elasticity.internal_force(state.u);
    for (const auto dof : elasticity.body().locally_owned_dofs())
      if (elasticity.is_prescribed(dof))
        lacking(dof) = 0.;
    lacking.compress(VectorOperation::insert);

    LA::Vector correction = elasticity.zero_vector();
    if (lacking.l2_norm() > 0.)
      solver.solve(correction, lacking);
    surface.B().add_displacement(1., shift, correction);
    const double gap = 0.5 * (correction * elasticity.internal_force(correction));

    LA::Vector u_hat = state.u;
    surface.B().add_displacement(-1., shift, u_hat);
    return std::sqrt(2. * std::max(gap, 0.) /
                     nonzero(u_hat * elasticity.internal_force(u_hat)));
  }
} // namespace stiction
