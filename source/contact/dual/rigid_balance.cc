#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/dual/rigid_balance.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/unbalanced_load.h>

#include <Eigen/Cholesky>

#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of what a displacement changes: what is farther away is not met on the way back.
    constexpr double far_away = 4.;

    // Those that nothing resists with the forces of a state. Friction resists where a
    // node is pressed, and nowhere once all pressure is gone, of which the certificates
    // of earlier steps leave a little.
    Eigen::MatrixXd unresisted_motions(const LinearElasticity &elasticity,
                                       const ContactSurface &surface, const State &state,
                                       const double tolerance, const double moved)
    {
      Eigen::MatrixXd G =
        rigid_balance(elasticity, surface).G.rightCols(elasticity.free_motions().n());
      Eigen::VectorXd bound   = surface.slip_bound().at(state.lambda);
      const Eigen::VectorXd r = surface.gap_and_slip(state);
      const auto m            = static_cast<double>(surface.n_nodes());
      const double pressing   = tolerance * state.scales.force / m;
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        {
          if (state.lambda(i) > pressing || surface.slip_bound().is_tied(i))
            continue;
          if (surface.boundary_of(surface.nodes()[i]).friction().law() ==
              FrictionLaw::coulomb)
            bound(i) = 0.;
          if (r(i) > far_away * moved)
            G.row(i).setZero();
        }
      return qp::resisted_and_others(G, qp::SlipBound::given(std::move(bound))).second;
    }
  } // namespace

  EqualityConstraint rigid_balance(const LinearElasticity &elasticity,
                                   const ContactSurface &surface)
  {
    const ObstacleMotion &obstacles = surface.motion();
    const Eigen::Index n = elasticity.free_motions().n(), p = obstacles.n_pressed();
    EqualityConstraint balance{Eigen::MatrixXd(3 * surface.n_nodes(), p + n),
                               Eigen::VectorXd(p + n)};
    balance.G.leftCols(p) = obstacles.directions();
    balance.e.head(p)     = -obstacles.forces();
    balance.e.tail(n)     = -elasticity.work_of_loads_along_free_motions();
    for (Eigen::Index j = 0; j < n; ++j)
      {
        LA::Vector u = elasticity.zero_vector();
        elasticity.add_free_motion(Eigen::VectorXd::Unit(n, j), u);
        balance.G.col(p + j) = -surface.B().apply_to_motion(u);
      }
    return balance;
  }

  Eigen::MatrixXd unresisted_motions(const LinearElasticity &elasticity,
                                     const ContactSurface &surface)
  {
    const Eigen::Index n = elasticity.free_motions().n();
    if (n == 0 || surface.has_friction_of_state())
      return Eigen::MatrixXd::Zero(n, 0);
    return qp::resisted_and_others(rigid_balance(elasticity, surface).G.rightCols(n),
                                   surface.slip_bound())
      .second;
  }

  void leave_in_place(const LinearElasticity &elasticity, const ContactSurface &surface,
                      const LA::Vector &before, const double tolerance, State &state)
  {
    if (elasticity.free_motions().n() == 0 || state.lambda.size() == 0)
      return;
    LA::Vector moved = state.u;
    moved -= before;
    const Eigen::MatrixXd motions =
      unresisted_motions(elasticity, surface, state, tolerance, moved.linfty_norm());
    const Eigen::Index n = motions.cols();
    if (n == 0)
      return;
    const Eigen::VectorXd along =
      motions.transpose() * elasticity.work_along_free_motions(moved);
    Eigen::MatrixXd size(n, n); // what a unit of each motion has
    for (Eigen::Index j = 0; j < n; ++j)
      {
        moved = 0.;
        elasticity.add_free_motion(motions.col(j), moved);
        size.col(j) = motions.transpose() * elasticity.work_along_free_motions(moved);
      }
    elasticity.add_free_motion(-motions * size.ldlt().solve(along), state.u);
  }
} // namespace stiction
