#include <stiction/contact/contact_level.h>
#include <stiction/contact/supported_system.h>
#include <stiction/elasticity/mesh_level.h>
#include <stiction/elasticity/stiffness_operator.h>
#include <stiction/elasticity/stiffness_preconditioner.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace stiction
{
  namespace
  {
    // The directions kept take 12 bytes an unknown each.
    constexpr unsigned int max_directions = 20;

    Eigen::Vector3d
    at(const Eigen::VectorXd &v, const Eigen::Index i)
    {
      const Eigen::Index m = v.size() / 3;
      return {v(i), v(i + m), v(i + 2 * m)};
    }

    void
    put(Eigen::VectorXd &v, const Eigen::Index i, const Eigen::Vector3d &x)
    {
      const Eigen::Index m = v.size() / 3;
      v(i)                 = x(0);
      v(i + m)             = x(1);
      v(i + 2 * m)         = x(2);
    }
  } // namespace



  SupportedSystem::SupportedSystem(const ContactLevel &problem,
                                   const unsigned int level,
                                   StiffnessPreconditioner &preconditioner)
    : problem_(problem)
    , level_(level)
    , preconditioner_(preconditioner)
  {
  }



  void
  SupportedSystem::set_supports(const PrimalLinearization &linearization)
  {
    NodalSupports supports(linearization.nodes.size());
    for (std::size_t i = 0; i < supports.size(); ++i)
      {
        const auto node = static_cast<Eigen::Index>(i);
        supports[i].projection =
          problem_.to_cartesian(node, linearization.nodes[i].projection);
        supports[i].spring =
          problem_.to_cartesian(node, linearization.nodes[i].spring);
      }
    preconditioner_.set_supports(level_, supports);
  }



  Eigen::VectorXd
  SupportedSystem::contact_rows(const PrimalLinearization &linearization,
                                const Eigen::VectorXd &force,
                                const Eigen::VectorXd &displacement) const
  {
    Eigen::VectorXd rows(force.size());
    for (Eigen::Index i = 0; i < problem_.n_nodes(); ++i)
      put(rows,
          i,
          linearization.nodes[i].test * at(force, i) +
            linearization.nodes[i].spring * at(displacement, i));
    return rows;
  }



  unsigned int
  SupportedSystem::solve(ContactState &state,
                         const PrimalLinearization &linearization,
                         const std::function<bool(const Progress &)> &stop)
  {
    const Eigen::Index m = problem_.n_nodes();
    set_supports(linearization);

    Eigen::VectorXd shift(3 * m), load(3 * m);
    for (Eigen::Index i = 0; i < m; ++i)
      {
        put(shift, i, linearization.nodes[i].shift);
        put(load, i, linearization.nodes[i].load);
      }
    problem_.add_transpose_B(shift, state.u);
    state.update(problem_);

    LA::Vector r = state.R;
    problem_.clear_prescribed(r);
    Eigen::VectorXd contact_r =
      contact_rows(linearization, state.lambda, -state.w) - load;
    problem_.set_transpose_B(contact_r, r);
    const double start = r.l2_norm();

    std::vector<double> amounts;
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(max_directions, max_directions);
    LA::Vector z      = problem_.mesh().zero_vector<double>();
    unsigned int n    = 0;
    while (n < max_directions && start > 0.)
      {
        if (n == directions_.size())
          directions_.push_back(std::make_unique<Direction>(
            Direction{problem_.mesh().zero_vector<float>(),
                      problem_.mesh().zero_vector<double>(),
                      {},
                      {},
                      {}}));
        Direction &d = *directions_[n];

        preconditioner_.vmult(level_, z, r);
        for (unsigned int k = 0; k < z.locally_owned_size(); ++k)
          {
            d.z.local_element(k) = static_cast<float>(z.local_element(k));
            z.local_element(k)   = d.z.local_element(k);
          }
        problem_.stiffness().vmult(d.v, z);
        d.displacement = problem_.apply_B(z);
        d.force        = problem_.apply_B(d.v);
        d.reaction     = problem_.prescribed_entries(d.v);
        problem_.clear_prescribed(d.v);
        problem_.set_transpose_B(
          contact_rows(linearization, d.force, d.displacement), d.v);

        for (unsigned int j = 0; j < n; ++j)
          {
            const Direction &other = *directions_[j];
            H(j, n)                = other.v * d.v;
            d.v.add(-H(j, n), other.v);
            d.displacement -= H(j, n) * other.displacement;
            d.force -= H(j, n) * other.force;
            for (std::size_t k = 0; k < d.reaction.size(); ++k)
              d.reaction[k] -= H(j, n) * other.reaction[k];
          }
        H(n, n) = d.v.l2_norm();
        if (!(H(n, n) > 0.))
          break;
        const double inverse = 1. / H(n, n);
        d.v *= inverse;
        d.displacement *= inverse;
        d.force *= inverse;
        for (double &x : d.reaction)
          x *= inverse;

        const double amount = d.v * r;
        amounts.push_back(amount);
        r.add(-amount, d.v);
        contact_r -= amount * problem_.apply_B(d.v);
        state.w += amount * d.displacement;
        state.lambda -= amount * d.force;
        problem_.add_prescribed_entries(-amount, d.reaction, state.R);
        ++n;
        if (stop({n, r, contact_r, state.lambda, state.w, r.l2_norm() / start}))
          break;
      }

    // u is moved along the preconditioned vectors, R is the residual wherever
    // nothing was replaced in it
    const Eigen::VectorXd y =
      H.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(
        Eigen::Map<const Eigen::VectorXd>(amounts.data(), n));
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int k = 0; k < state.u.locally_owned_size(); ++k)
        state.u.local_element(k) += y(j) * directions_[j]->z.local_element(k);
    problem_.set_prescribed_entries(problem_.prescribed_entries(state.R), r);
    problem_.set_transpose_B(state.lambda, r);
    state.R = r;
    return n;
  }
} // namespace stiction
