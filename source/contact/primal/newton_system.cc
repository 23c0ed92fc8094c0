#include <stiction/contact/primal/contact_level.h>
#include <stiction/contact/primal/newton_system.h>
#include <stiction/elasticity/linear_algebra/long_vectors.h>
#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/multigrid/multigrid.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // Beyond that, motions are too far from each other to be told apart.
    constexpr double singular = 1e-12;

    // The part of a spring that is symmetric and pulls back; those of Newton steps are
    // nothing else.
    Eigen::Matrix3d symmetric_part(const Eigen::Matrix3d &spring)
    {
      if (spring == spring.transpose())
        return spring;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(
        0.5 * (spring + spring.transpose()));
      return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.).asDiagonal() *
             eigen.eigenvectors().transpose();
    }
  } // namespace

  NewtonSystem::NewtonSystem(const ContactLevel &problem, const unsigned int level,
                             Multigrid &preconditioner, const bool factorizes)
    : problem_(problem)
    , level_(level)
    , preconditioner_(preconditioner)
    , factorizes_(factorizes)
    , residual_(problem.mesh().zero_vector<double>())
    , step_(residual_)
  {
  }

  void NewtonSystem::set_supports(const PrimalActiveSet &linearization)
  {
    const bool is_direct = preconditioner_.is_direct(level_);
    NodalSupports supports;
    for (Eigen::Index i = 0; i < problem_.n_nodes(); ++i)
      {
        const PrimalActiveSet::Node &node = linearization.nodes[i];
        supports.push_back(
          problem_.support(i, is_direct, node.projection, symmetric_part(node.spring)));
      }
    preconditioner_.set_supports(level_, supports);
  }

  Eigen::VectorXd NewtonSystem::contact_rows(const PrimalActiveSet &linearization,
                                             const Eigen::VectorXd &force,
                                             const Eigen::VectorXd &displacement) const
  {
    return by_nodes(problem_.n_nodes(), [&](const Eigen::Index i) -> Eigen::Vector3d {
      return linearization.nodes[i].test * at_node(force, i) +
             linearization.nodes[i].spring * at_node(displacement, i);
    });
  }

  Eigen::VectorXd NewtonSystem::held_displacement(const PrimalActiveSet &linearization,
                                                  const Eigen::VectorXd &distances) const
  {
    return held_part(linearization, problem_.motion().displacement(distances));
  }

  Eigen::VectorXd NewtonSystem::held_part(const PrimalActiveSet &linearization,
                                          const Eigen::VectorXd &moved)
  {
    return by_nodes(moved.size() / 3, [&](const Eigen::Index i) -> Eigen::Vector3d {
      return at_node(moved, i) - linearization.nodes[i].projection * at_node(moved, i);
    });
  }

  std::vector<Eigen::Index> NewtonSystem::felt_obstacles(
    const PrimalActiveSet &linearization) const
  {
    const auto n = problem_.motion().n_pressed();
    std::vector<Eigen::Index> felt;
    for (Eigen::Index j = 0; j < n; ++j)
      {
        const Eigen::VectorXd column = problem_.motion().directions().col(j);
        bool is_felt =
          !held_displacement(linearization, Eigen::VectorXd::Unit(n, j)).isZero(0.);
        for (Eigen::Index i = 0; i < problem_.n_nodes() && !is_felt; ++i)
          is_felt = !(linearization.nodes[i].spring * at_node(column, i)).isZero(0.);
        if (is_felt)
          felt.push_back(j);
      }
    return felt;
  }

  void NewtonSystem::apply(const PrimalActiveSet &linearization, Direction &d)
  {
    const bool moves_obstacles = !d.distances.isZero(0.);
    const std::size_t N        = step_.locally_owned_size();
    const auto take            = [&](const auto *const z) {
      for (std::size_t k = 0; k < N; ++k)
        step_.begin()[k] = d.factor * z[k];
    };
    d.is_exact ? take(d.solution.begin()) : take(d.z.begin());
    if (moves_obstacles)
      problem_.B().add_displacement(1., held_displacement(linearization, d.distances),
                                    step_);
    problem_.apply_stiffness(d.v, step_);
    d.displacement = problem_.B().apply(step_);
    if (moves_obstacles)
      d.displacement -= problem_.motion().displacement(d.distances);
    d.force         = problem_.B().contact_forces(d.v);
    d.contact_rows  = contact_rows(linearization, d.force, d.displacement);
    d.obstacle_rows = problem_.motion().forces_along(d.force - d.contact_rows);
    d.reaction      = problem_.prescribed_entries(d.v);
    problem_.clear_prescribed(d.v);
    problem_.B().set_transpose(d.contact_rows, d.v);
  }

  void NewtonSystem::precondition(Direction &d, const LA::Vector &v, const double sign)
  {
    d.is_exact = preconditioner_.is_direct(level_);
    if (d.is_exact)
      {
        d.solution.reinit(v, true);
        preconditioner_.solve(level_, d.solution, v);
        d.factor = sign;
      }
    else
      d.factor = sign * preconditioner_.vmult(level_, d.z, v);
  }

  void NewtonSystem::move_obstacle(const PrimalActiveSet &linearization,
                                   const Eigen::Index obstacle, Direction &d)
  {
    d.distances = Eigen::VectorXd::Unit(problem_.motion().n_pressed(), obstacle);
    d.z         = 0.F;
    d.factor    = 0.;
    d.is_exact  = false;
    apply(linearization, d);
    precondition(d, d.v, -1.);
  }

  void NewtonSystem::take_loose_motions(const PrimalActiveSet &linearization)
  {
    const Eigen::Index n = problem_.loose_motions().cols();
    for (Eigen::Index j = 0; j < n; ++j)
      {
        loose_.push_back(std::make_unique<Direction>());
        Direction &d = *loose_.back();
        d.v          = problem_.mesh().zero_vector<double>();
        d.solution   = d.v;
        problem_.add_loose_motion(j, d.solution);
        const Eigen::VectorXd moved = problem_.B().apply(d.solution);
        problem_.B().add_displacement(-1., held_part(linearization, moved), d.solution);
        d.distances = Eigen::VectorXd::Zero(problem_.motion().n_pressed());
        d.is_exact  = true;
        apply(linearization, d);
      }
    Eigen::MatrixXd stiffness(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      stiffness.col(j) = work_of_loose_motions(loose_[j]->v);
    if (n == 0)
      return;
    loose_stiffness_.compute(stiffness);
    if (!(loose_stiffness_.rcond() > singular))
      loose_.clear();
  }

  Eigen::VectorXd NewtonSystem::work_of_loose_motions(const LA::Vector &v) const
  {
    std::vector<const double *> motions;
    for (const auto &d : loose_)
      motions.push_back(d->solution.begin());
    std::vector<double> work = multiple_dot(motions, v.begin(), v.locally_owned_size());
    sum_over_ranks(work, problem_.mesh().communicator());
    return Eigen::Map<Eigen::VectorXd>(work.data(),
                                       static_cast<Eigen::Index>(work.size()));
  }

  Eigen::VectorXd NewtonSystem::loose_part(const LA::Vector &v) const
  {
    return loose_.empty() ? Eigen::VectorXd()
                          : loose_stiffness_.solve(work_of_loose_motions(v)).eval();
  }

  void NewtonSystem::deflate(Direction &d) const
  {
    d.loose = loose_part(d.v);
    for (Eigen::Index j = 0; j < d.loose.size(); ++j)
      {
        d.v.add(-d.loose(j), loose_[j]->v);
        d.subtract(d.loose(j), *loose_[j]);
      }
  }

  void NewtonSystem::Direction::subtract(const double h, const Direction &other)
  {
    displacement -= h * other.displacement;
    force -= h * other.force;
    contact_rows -= h * other.contact_rows;
    obstacle_rows -= h * other.obstacle_rows;
    for (std::size_t k = 0; k < reaction.size(); ++k)
      reaction[k] -= h * other.reaction[k];
  }

  double NewtonSystem::orthogonalize(const unsigned int n, Eigen::MatrixXd &H,
                                     const Eigen::VectorXd &obstacle_r)
  {
    const MPI_Comm communicator = problem_.mesh().communicator();
    const std::size_t N         = residual_.locally_owned_size();
    Direction &d                = *directions_[n];
    std::vector<const double *> images;
    for (unsigned int j = 0; j < n; ++j)
      images.push_back(directions_[j]->v.begin());

    std::vector<double> h = multiple_dot(images, d.v.begin(), N);
    sum_over_ranks(h, communicator);
    for (unsigned int j = 0; j < n; ++j)
      {
        const Direction &other = *directions_[j];
        h[j]    = (h[j] + other.obstacle_rows.dot(d.obstacle_rows)) / other.square;
        H(j, n) = h[j];
      }
    for (unsigned int j = 0; j < n; ++j) // after all products with them
      d.subtract(h[j], *directions_[j]);
    std::vector<double> products =
      subtract_all(d.v.begin(), images, h, residual_.begin(), N);
    sum_over_ranks(products, communicator);
    d.square = products[0] + d.obstacle_rows.squaredNorm();
    return products[1] + d.obstacle_rows.dot(obstacle_r);
  }

  unsigned int NewtonSystem::solve(ContactState &state,
                                   const PrimalActiveSet &linearization,
                                   const std::function<bool(const Progress &)> &stop,
                                   const bool is_near)
  {
    const Eigen::Index m = problem_.n_nodes();
    set_supports(linearization);

    const Eigen::VectorXd shift =
      by_nodes(m, [&](const Eigen::Index i) { return linearization.nodes[i].shift; });
    const Eigen::VectorXd load =
      by_nodes(m, [&](const Eigen::Index i) { return linearization.nodes[i].load; });
    problem_.B().add_displacement(1., shift, state.u);
    state.update(problem_);

    const MPI_Comm communicator = problem_.mesh().communicator();
    LA::Vector &r               = residual_;
    r                           = state.R;
    problem_.clear_prescribed(r);
    Eigen::VectorXd contact_r =
      contact_rows(linearization, state.lambda, -state.w) - load;
    problem_.B().set_transpose(contact_r, r);
    Eigen::VectorXd obstacle_r =
      problem_.motion().missing_forces(state.lambda - contact_r);
    const auto advance = [&](const double amount, const Direction &d) {
      obstacle_r -= amount * d.obstacle_rows;
      contact_r -= amount * d.contact_rows;
      state.w += amount * d.displacement;
      state.lambda -= amount * d.force;
      problem_.add_prescribed_entries(-amount, d.reaction, state.R);
    };

    loose_.clear();
    if (is_near)
      take_loose_motions(linearization);
    Eigen::VectorXd ways = loose_part(r);
    for (Eigen::Index j = 0; j < ways.size(); ++j)
      {
        r.add(-ways(j), loose_[j]->v);
        advance(ways(j), *loose_[j]);
      }

    double square       = r.norm_sqr() + obstacle_r.squaredNorm();
    const double start  = std::sqrt(square);
    const std::size_t N = r.locally_owned_size();

    const std::vector<Eigen::Index> felt = felt_obstacles(linearization);
    const auto capacity     = max_directions() + static_cast<unsigned int>(felt.size());
    Eigen::MatrixXd H       = Eigen::MatrixXd::Identity(capacity, capacity);
    Eigen::VectorXd amounts = Eigen::VectorXd::Zero(capacity);
    unsigned int n = 0, n_imprecise = 0;
    bool is_finished = square == 0., turns = false;
    while (n < capacity && !is_finished && !turns)
      {
        Direction &d = new_direction(n);
        if (n < felt.size())
          move_obstacle(linearization, felt[n], d);
        else
          {
            d.distances = Eigen::VectorXd::Zero(obstacle_r.size());
            precondition(d, r, 1.);
          }
        if (!d.is_exact && !preconditioner_.is_precise())
          ++n_imprecise;
        apply(linearization, d);
        deflate(d);
        const double product = orthogonalize(n, H, obstacle_r);
        if (!(d.square > 0.))
          break;

        amounts(n)                = product / d.square;
        std::vector<double> norms = subtract(r.begin(), amounts(n), d.v.begin(), N);
        sum_over_ranks(norms, communicator);
        advance(amounts(n), d);
        square = norms[0] + obstacle_r.squaredNorm();
        ++n;
        is_finished = n >= felt.size() && (stop({n, norms[1], contact_r, state.lambda,
                                                 state.w, std::sqrt(square) / start}) ||
                                           square == 0.);
        turns       = n_imprecise == max_unfinished && turns_to_factors();
      }
    left_unfinished_ = !is_finished;
    if (!is_finished && !turns && ++n_unfinished_ >= max_unfinished)
      turns_to_factors();

    // u is moved along the preconditioned vectors, R is the residual wherever
    // nothing was replaced in it
    const Eigen::VectorXd y =
      H.topLeftCorner(n, n).triangularView<Eigen::UnitUpper>().solve(amounts.head(n));
    for (unsigned int k = 0; k < n; ++k)
      ways -= y(k) * directions_[k]->loose;
    add_all(state, linearization, y);
    for (Eigen::Index j = 0; j < ways.size(); ++j)
      state.u.add(ways(j), loose_[j]->solution);
    problem_.B().set_transpose(state.lambda, r);
    problem_.set_prescribed_entries(problem_.prescribed_entries(state.R), r);
    state.R.swap(r);
    return n;
  }

  unsigned int NewtonSystem::max_directions() const
  {
    constexpr unsigned int small_level = 20000; // unknowns
    return problem_.mesh().n_dofs() <= small_level ? 20 : 40;
  }

  bool NewtonSystem::turns_to_factors()
  {
    is_too_hard_ = !factorizes_;
    if (is_too_hard_)
      return true;
    if (!preconditioner_.factorize(level_))
      return false;
    is_factorized_ = true;
    n_unfinished_  = 0;
    return true;
  }

  NewtonSystem::Direction &NewtonSystem::new_direction(const unsigned int n)
  {
    if (n == directions_.size())
      {
        directions_.push_back(std::make_unique<Direction>());
        directions_[n]->z = problem_.mesh().zero_vector<float>();
        directions_[n]->v = problem_.mesh().zero_vector<double>();
      }
    return *directions_[n];
  }

  void NewtonSystem::add_all(ContactState &state, const PrimalActiveSet &linearization,
                             const Eigen::VectorXd &y) const
  {
    double *const u        = state.u.begin();
    const std::size_t size = state.u.locally_owned_size();
    for (std::size_t b = 0; b < size; b += piece_size)
      {
        const std::size_t end = std::min(b + piece_size, size);
        for (Eigen::Index j = 0; j < y.size(); ++j)
          {
            const Direction &d = *directions_[j];
            const double a     = y(j) * d.factor;
            const auto add     = [&](const auto *const z) {
              for (std::size_t k = b; k < end; ++k)
                u[k] += a * z[k];
            };
            d.is_exact ? add(d.solution.begin()) : add(d.z.begin());
          }
      }

    if (problem_.motion().n_pressed() == 0)
      return;
    Eigen::VectorXd distances = Eigen::VectorXd::Zero(problem_.motion().n_pressed());
    for (Eigen::Index j = 0; j < y.size(); ++j)
      distances += y(j) * directions_[j]->distances;
    state.distances += distances;
    problem_.B().add_displacement(1., held_displacement(linearization, distances),
                                  state.u);
  }
} // namespace stiction
