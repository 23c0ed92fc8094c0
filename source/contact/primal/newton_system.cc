#include <stiction/contact/primal/contact_level.h>
#include <stiction/contact/primal/newton_system.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>
#include <stiction/elasticity/stiffness/stiffness_preconditioner.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // Long vectors are worked on in pieces that stay in the cache: all that is
    // to be done with a piece is done at once.
    constexpr std::size_t block_size = 1536;

    // So many systems left unfinished, and the next are factorised.
    constexpr unsigned int max_unfinished = 3;

    using Piece      = Eigen::Map<Eigen::VectorXd>;
    using ConstPiece = Eigen::Map<const Eigen::VectorXd>;

    Eigen::Index piece_size(const std::size_t begin, const std::size_t size)
    {
      return static_cast<Eigen::Index>(std::min(block_size, size - begin));
    }

    // v_j · v for all j, of this rank.
    std::vector<double> multiple_dot(const std::vector<const double *> &vectors,
                                     const double *const v, const std::size_t size)
    {
      std::vector<double> products(vectors.size(), 0.);
      for (std::size_t b = 0; b < size; b += block_size)
        {
          const Eigen::Index n = piece_size(b, size);
          for (std::size_t j = 0; j < vectors.size(); ++j)
            products[j] += ConstPiece(vectors[j] + b, n).dot(ConstPiece(v + b, n));
        }
      return products;
    }

    // v -= Σ h_j v_j; returns v·v and v·r.
    std::vector<double> subtract_all(double *const v,
                                     const std::vector<const double *> &vectors,
                                     const std::vector<double> &h, const double *const r,
                                     const std::size_t size)
    {
      std::vector<double> products(2, 0.);
      for (std::size_t b = 0; b < size; b += block_size)
        {
          const Eigen::Index n = piece_size(b, size);
          Piece piece(v + b, n);
          for (std::size_t j = 0; j < vectors.size(); ++j)
            piece -= h[j] * ConstPiece(vectors[j] + b, n);
          products[0] += piece.squaredNorm();
          products[1] += piece.dot(ConstPiece(r + b, n));
        }
      return products;
    }

    // r -= a v; returns r·r and the sum of the norms at the nodes.
    std::vector<double> subtract(double *const r, const double a, const double *const v,
                                 const std::size_t size)
    {
      std::vector<double> sums(2, 0.);
      for (std::size_t k = 0; k < size; k += 3)
        {
          double square = 0.;
          for (std::size_t c = k; c < k + 3; ++c)
            {
              r[c] -= a * v[c];
              square += r[c] * r[c];
            }
          sums[0] += square;
          sums[1] += std::sqrt(square);
        }
      return sums;
    }

    void sum(std::vector<double> &values, MPI_Comm communicator)
    {
      dealii::Utilities::MPI::sum(
        dealii::ArrayView<const double>(values.data(), values.size()), communicator,
        dealii::ArrayView<double>(values.data(), values.size()));
    }
  } // namespace

  NewtonSystem::NewtonSystem(const ContactLevel &problem, const unsigned int level,
                             StiffnessPreconditioner &preconditioner)
    : problem_(problem)
    , level_(level)
    , preconditioner_(preconditioner)
    , residual_(problem.mesh().zero_vector<double>())
    , step_(residual_)
  {
  }

  void NewtonSystem::set_supports(const PrimalActiveSet &linearization)
  {
    NodalSupports supports(linearization.nodes.size());
    for (std::size_t i = 0; i < supports.size(); ++i)
      {
        const auto node = static_cast<Eigen::Index>(i);
        supports[i]     = problem_.support(node, linearization.nodes[i].projection,
                                           linearization.nodes[i].spring);
      }
    preconditioner_.set_supports(level_, supports);
  }

  Eigen::VectorXd NewtonSystem::contact_rows(const PrimalActiveSet &linearization,
                                             const Eigen::VectorXd &force,
                                             const Eigen::VectorXd &displacement) const
  {
    Eigen::VectorXd rows(force.size());
    for (Eigen::Index i = 0; i < problem_.n_nodes(); ++i)
      set_at_node(rows, i,
                  linearization.nodes[i].test * at_node(force, i) +
                    linearization.nodes[i].spring * at_node(displacement, i));
    return rows;
  }

  unsigned int NewtonSystem::solve(ContactState &state,
                                   const PrimalActiveSet &linearization,
                                   const std::function<bool(const Progress &)> &stop)
  {
    const Eigen::Index m = problem_.n_nodes();
    set_supports(linearization);

    Eigen::VectorXd shift(3 * m), load(3 * m);
    for (Eigen::Index i = 0; i < m; ++i)
      {
        set_at_node(shift, i, linearization.nodes[i].shift);
        set_at_node(load, i, linearization.nodes[i].load);
      }
    problem_.B().add_displacement(1., shift, state.u);
    state.update(problem_);

    const MPI_Comm communicator = problem_.mesh().communicator();
    LA::Vector &r               = residual_;
    r                           = state.R;
    problem_.clear_prescribed(r);
    Eigen::VectorXd contact_r =
      contact_rows(linearization, state.lambda, -state.w) - load;
    problem_.B().set_transpose(contact_r, r);
    double square           = r.norm_sqr();
    const double start      = std::sqrt(square);
    LA::Vector &z           = step_;
    const std::size_t N     = z.locally_owned_size();
    Eigen::MatrixXd H       = Eigen::MatrixXd::Identity(max_directions, max_directions);
    Eigen::VectorXd amounts = Eigen::VectorXd::Zero(max_directions);
    std::vector<const double *> images;
    unsigned int n   = 0;
    bool is_finished = square == 0.;
    while (n < max_directions && !is_finished)
      {
        Direction &d = new_direction(n);
        d.factor     = preconditioner_.vmult(level_, d.z, r);
        for (std::size_t k = 0; k < N; ++k)
          z.begin()[k] = d.factor * d.z.begin()[k];
        problem_.stiffness().vmult(d.v, z);
        d.displacement = problem_.B().apply(z);
        d.force        = problem_.B().contact_forces(d.v);
        d.contact_rows = contact_rows(linearization, d.force, d.displacement);
        d.reaction     = problem_.prescribed_entries(d.v);
        problem_.clear_prescribed(d.v);
        problem_.B().set_transpose(d.contact_rows, d.v);

        std::vector<double> h = multiple_dot(images, d.v.begin(), N);
        sum(h, communicator);
        for (unsigned int j = 0; j < n; ++j)
          {
            const Direction &other = *directions_[j];
            h[j] /= other.square;
            H(j, n) = h[j];
            d.displacement -= h[j] * other.displacement;
            d.force -= h[j] * other.force;
            d.contact_rows -= h[j] * other.contact_rows;
            for (std::size_t k = 0; k < d.reaction.size(); ++k)
              d.reaction[k] -= h[j] * other.reaction[k];
          }
        std::vector<double> products = subtract_all(d.v.begin(), images, h, r.begin(), N);
        sum(products, communicator);
        d.square = products[0];
        if (!(d.square > 0.))
          break;

        amounts(n)                = products[1] / d.square;
        std::vector<double> norms = subtract(r.begin(), amounts(n), d.v.begin(), N);
        sum(norms, communicator);
        square = norms[0];
        contact_r -= amounts(n) * d.contact_rows;
        state.w += amounts(n) * d.displacement;
        state.lambda -= amounts(n) * d.force;
        problem_.add_prescribed_entries(-amounts(n), d.reaction, state.R);
        images.push_back(d.v.begin());
        ++n;
        is_finished = stop({n, norms[1], contact_r, state.lambda, state.w,
                            std::sqrt(square) / start}) ||
                      square == 0.;
      }
    if (!is_finished && ++n_unfinished_ >= max_unfinished &&
        preconditioner_.factorize(level_))
      {
        is_factorized_ = true;
        n_unfinished_  = 0;
      }

    // u is moved along the preconditioned vectors, R is the residual wherever
    // nothing was replaced in it
    const Eigen::VectorXd y =
      H.topLeftCorner(n, n).triangularView<Eigen::UnitUpper>().solve(amounts.head(n));
    add_all(state.u.begin(), y, N);
    problem_.B().set_transpose(state.lambda, r);
    problem_.set_prescribed_entries(problem_.prescribed_entries(state.R), r);
    state.R.swap(r);
    return n;
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

  void NewtonSystem::add_all(double *const u, const Eigen::VectorXd &y,
                             const std::size_t size) const
  {
    for (std::size_t b = 0; b < size; b += block_size)
      {
        const std::size_t end = std::min(b + block_size, size);
        for (Eigen::Index j = 0; j < y.size(); ++j)
          {
            const float *const z = directions_[j]->z.begin();
            const double a       = y(j) * directions_[j]->factor;
            for (std::size_t k = b; k < end; ++k)
              u[k] += a * z[k];
          }
      }
  }
} // namespace stiction
