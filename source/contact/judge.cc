#include <stiction/contact/certificate.h>
#include <stiction/contact/contact_surface.h>
#include <stiction/contact/dual_operator.h>
#include <stiction/contact/judge.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/stiffness_solver.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>

namespace stiction
{
  BodyJudge::BodyJudge(const LinearElasticity &elasticity,
                       const ContactSurface &surface,
                       StiffnessSolver &solver)
    : elasticity_(elasticity)
    , surface_(surface)
    , solver_(solver)
  {
  }



  BodyJudge::~BodyJudge() = default;



  const ContactConditions &
  BodyJudge::judge(const Eigen::VectorXd &lambda)
  {
    LA::Vector force = elasticity_.constrained_load();
    surface_.add_transpose_B(-1., lambda, force);
    LA::Vector u = elasticity_.zero_vector();
    solver_.solve(u, force);
    return judge(u, lambda);
  }



  const ContactConditions &
  BodyJudge::judge(const LA::Vector &u, const Eigen::VectorXd &lambda)
  {
    u_ = std::make_unique<LA::Vector>(u);
    elasticity_.distribute(*u_);
    certificate_ =
      std::make_unique<Certificate>(elasticity_, surface_, *u_, lambda);
    return *certificate_;
  }



  DualProblemJudge::DualProblemJudge(const DualOperator &Q,
                                     const qp::SlipBound &slip_bound,
                                     const Eigen::VectorXd &areas)
    : Q_(Q)
    , slip_bound_(slip_bound)
    , share_(areas.size() > 0 ? Eigen::VectorXd(areas / areas.sum())
                              : Eigen::VectorXd::Constant(
                                  Q.n_nodes(),
                                  1. / static_cast<double>(Q.n_nodes())))
  {
  }



  const ContactConditions &
  DualProblemJudge::judge(const Eigen::VectorXd &lambda)
  {
    const Eigen::Index m = Q_.n_nodes();
    Eigen::VectorXd Q_lambda;
    Q_.vmult(DualBlock::all, DualBlock::all, Q_lambda, lambda);

    double force = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      force +=
        Eigen::Vector3d(lambda(i), lambda(i + m), lambda(i + 2 * m)).norm();
    double work = lambda.dot(Q_lambda);
    if (force == 0.)
      {
        const Undoing scales = undoing(Q_);
        force                = scales.force;
        work                 = scales.work;
      }
    qp::Scaling scaling;
    scaling.force        = share_ * (force > 0. ? force : 1.);
    scaling.displacement = force > 0. && work > 0. ? work / force : 1.;

    conditions_ = std::make_unique<ContactConditions>(
      lambda, Q_lambda - Q_.right_hand_side(), slip_bound_.at(lambda), scaling);
    if (const Eigen::MatrixXd *const Q = Q_.matrix())
      {
        double largest = 0.; // of |Q||λ|, by columns, as Q is symmetric
        for (Eigen::Index k = 0; k < Q->cols(); ++k)
          largest =
            std::max(largest, Q->col(k).cwiseAbs().dot(lambda.cwiseAbs()));
        conditions_->set_rounding(largest * unit_roundoff /
                                  scaling.displacement);
      }
    return *conditions_;
  }
} // namespace stiction
