#include <stiction/contact/dual/schur_complement.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <utility>

namespace stiction
{
  namespace
  {
    // What Q gets on its diagonal where nodes are held: of the size of the
    // entries at other nodes.
    Eigen::VectorXd held_compliance(const LinearElasticity &elasticity,
                                    const ContactSurface &surface)
    {
      const Eigen::VectorXd stiffness =
        surface.B().dofs().restriction(elasticity.stiffness_diagonal());
      return surface.B().held().cwiseQuotient(stiffness);
    }
  } // namespace

  std::unique_ptr<DualOperator> SchurComplement::create(
    const std::string &form, const LinearElasticity &elasticity,
    const ContactSurface &surface, StiffnessSolver &solver)
  {
    if (form == "by solves")
      return std::make_unique<SchurComplement>(elasticity, surface, solver);

    return assembled(compliance(elasticity, surface, solver), elasticity, surface,
                     solver);
  }

  Eigen::MatrixXd SchurComplement::compliance(const LinearElasticity &elasticity,
                                              const ContactSurface &surface,
                                              StiffnessSolver &solver)
  {
    const DofSubset traces = surface.B().all_dofs();
    Eigen::MatrixXd C      = solver.compliance(traces);
    const auto &dofs       = traces.dofs();
    for (const auto anchor : elasticity.anchors())
      if (const auto place = std::find(dofs.begin(), dofs.end(), anchor);
          place != dofs.end())
        {
          C.row(place - dofs.begin()).setZero();
          C.col(place - dofs.begin()).setZero();
        }
    return C;
  }

  std::unique_ptr<DualOperator> SchurComplement::assembled(
    Eigen::MatrixXd compliance, const LinearElasticity &elasticity,
    const ContactSurface &surface, StiffnessSolver &solver)
  {
    Eigen::MatrixXd Q = surface.B().compliance(std::move(compliance));
    Q.diagonal() += held_compliance(elasticity, surface);
    return std::make_unique<DenseDualOperator>(
      std::move(Q), right_hand_side_of(elasticity, surface, solver));
  }

  Eigen::VectorXd SchurComplement::right_hand_side_of(const LinearElasticity &elasticity,
                                                      const ContactSurface &surface,
                                                      StiffnessSolver &solver)
  {
    LA::Vector u = elasticity.zero_vector();
    solver.solve(u, elasticity.constrained_load());
    return surface.B().apply(u) - surface.motion().offset_at_start();
  }

  SchurComplement::SchurComplement(const LinearElasticity &elasticity,
                                   const ContactSurface &surface, StiffnessSolver &solver)
    : DualOperator(surface.n_nodes())
    , elasticity_(elasticity)
    , surface_(surface)
    , solver_(solver)
    , held_compliance_(held_compliance(elasticity, surface))
  {
    set_right_hand_side(right_hand_side_of(elasticity, surface, solver));
  }

  Eigen::VectorXd SchurComplement::compute_nodal_compliance() const
  {
    const Eigen::Index m = n_nodes();
    const Eigen::VectorXd stiffness =
      surface_.B().dofs().restriction(elasticity_.stiffness_diagonal());
    return estimated_compliance(
      (stiffness.head(m) + stiffness.segment(m, m) + stiffness.tail(m)).cwiseInverse());
  }

  void SchurComplement::apply(const DualBlock rows, const DualBlock columns,
                              Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(3 * n_nodes());
    lambda.segment(begin(columns), length(columns)) = src;

    LA::Vector force = elasticity_.zero_vector();
    LA::Vector u     = elasticity_.zero_vector();
    surface_.B().add_load(1., lambda, force);
    solver_.solve(u, force);
    dst = (surface_.B().apply(u) + held_compliance_.cwiseProduct(lambda))
            .segment(begin(rows), length(rows));
  }
} // namespace stiction
