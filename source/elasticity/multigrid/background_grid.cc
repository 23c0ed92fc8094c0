#include "background_grid.h"

#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>

#include "chebyshev.h"

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stiction
{
  namespace
  {
    // Rows whose entries beside the diagonal sum up to more than so many times it
    // would have larger eigenvalues than the others.
    constexpr float largest_row_sum = 4.5f;

    // Entries of the diagonal below this part of the largest are rounding.
    constexpr float no_stiffness = 1e-14f;

    // Functions of the last grid that depend on each other leave it singular.
    constexpr double regularization = 1e-7;
  } // namespace

  BackgroundMultigrid::Grid::Grid(BlockMatrix A, std::vector<unsigned int> touched,
                                  const Interpolation &to_finer, const bool is_last,
                                  MPI_Comm communicator)
    : x(BlockVector::Zero(A.n(), 3))
    , b(x)
    , communicator_(communicator)
    , A_(std::move(A))
    , touched_(std::move(touched))
    , to_finer_(to_finer)
    , springs_(touched_.size(), Eigen::Matrix3f::Zero())
    , direction_(x)
    , product_(x)
    , scratch_(x)
    , is_last_(is_last)
  {
    make_diagonal();
    if (is_last_)
      {
        dense_ = A_.dense().cast<double>();
        sum_over_ranks(dense_, communicator_);
        scale_ = Eigen::Map<const Eigen::VectorXf>(inverse_diagonal_.data(),
                                                   inverse_diagonal_.size())
                   .cast<double>()
                   .cwiseSqrt();
      }
    else
      estimate_largest_eigenvalue();
    set_springs(springs_, nullptr);
  }

  void BackgroundMultigrid::Grid::make_diagonal()
  {
    const Eigen::Index n = A_.n();
    BlockVector entries(n, 3), sums = A_.off_diagonal_sums();
    for (Eigen::Index i = 0; i < n; ++i)
      entries.row(i) = A_.diagonal_block(i).diagonal();
    for (const unsigned int i : touched_)
      blocks_.push_back(A_.diagonal_block(i));
    sum_over_ranks(entries, communicator_);
    sum_over_ranks(sums, communicator_);
    if (!blocks_.empty())
      {
        Eigen::Map<Eigen::VectorXf> all(blocks_.front().data(),
                                        9 * static_cast<Eigen::Index>(blocks_.size()));
        sum_over_ranks(all, communicator_);
      }
    diagonal_         = entries.cwiseMax((entries + sums) / largest_row_sum);
    const float tiny  = no_stiffness * diagonal_.maxCoeff();
    inverse_diagonal_ = (diagonal_.array() > tiny).select(diagonal_.cwiseInverse(), 0.f);
    for (std::size_t t = 0; t < touched_.size(); ++t)
      blocks_[t].diagonal() =
        diagonal_.row(touched_[t]).transpose().cwiseMax(std::max(tiny, 1e-30f));
  }

  void BackgroundMultigrid::Grid::estimate_largest_eigenvalue()
  {
    // conjugate gradients are a Lanczos process; the right-hand side has parts in
    // all eigenvectors
    constexpr int steps = 15;
    BlockVector r(A_.n(), 3), z(A_.n(), 3), p, q;
    for (Eigen::Index k = 0; k < r.size(); ++k)
      r.data()[k] = static_cast<float>(k % 11) - 5.f;
    std::vector<double> diagonal, beside;
    double rz = 0., beta = 0., alpha = 1.;
    for (int k = 0; k < steps; ++k)
      {
        z                 = inverse_diagonal_.cwiseProduct(r);
        const double next = static_cast<double>(r.cwiseProduct(z).sum());
        if (k > 0)
          {
            beta = next / rz;
            beside.push_back(std::sqrt(beta) / alpha);
            p = z + static_cast<float>(beta) * p;
          }
        else
          p = z;
        rz = next;
        vmult(q, p);
        const double pq = static_cast<double>(p.cwiseProduct(q).sum());
        if (!(rz > 0.) || !(pq > 0.))
          break;
        const double last = alpha;
        alpha             = rz / pq;
        diagonal.push_back(1. / alpha + (k > 0 ? beta / last : 0.));
        r -= static_cast<float>(alpha) * q;
      }
    const auto n = static_cast<Eigen::Index>(diagonal.size());
    if (n == 0)
      {
        largest_eigenvalue_ = 1.f;
        return;
      }
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), n),
                                  Eigen::Map<const Eigen::VectorXd>(beside.data(), n - 1),
                                  Eigen::EigenvaluesOnly);
    // the process sees it from below
    largest_eigenvalue_ = static_cast<float>(1.1 * solver.eigenvalues().maxCoeff());
  }

  void BackgroundMultigrid::Grid::set_springs(const Springs &springs,
                                              std::unique_ptr<BlockMatrix> between)
  {
    springs_ = springs;
    between_ = std::move(between);
    if (is_last_)
      {
        Eigen::MatrixXd matrix = dense_;
        const auto add         = [&](const std::size_t s, const std::size_t t,
                             const auto &block) {
          matrix.block<3, 3>(3 * Eigen::Index(touched_[s]),
                             3 * Eigen::Index(touched_[t])) +=
            block.template cast<double>();
        };
        for (std::size_t t = 0; t < touched_.size(); ++t)
          add(t, t, springs_[t]);
        if (between_)
          {
            const Eigen::MatrixXf all = between_->dense();
            for (std::size_t s = 0; s < touched_.size(); ++s)
              for (std::size_t t = 0; t < touched_.size(); ++t)
                add(s, t, all.block<3, 3>(3 * Eigen::Index(s), 3 * Eigen::Index(t)));
          }
        matrix = scale_.asDiagonal() * matrix * scale_.asDiagonal();
        matrix.diagonal().array() += regularization;
        factors_.compute(matrix);
        return;
      }
    const BlockVector sums = between_ ? between_->off_diagonal_sums() : BlockVector();
    inverses_.resize(touched_.size());
    for (std::size_t t = 0; t < touched_.size(); ++t)
      {
        Eigen::Matrix3f block = blocks_[t] + springs_[t];
        if (between_)
          {
            // so that these springs add no larger eigenvalues
            const auto row         = static_cast<Eigen::Index>(t);
            Eigen::Matrix3f spring = between_->diagonal_block(row);
            spring.diagonal()      = spring.diagonal().cwiseMax(
                   (spring.diagonal() + sums.row(row).transpose()) / largest_eigenvalue_);
            block += spring;
          }
        inverses_[t] = block.cast<double>().inverse().eval().cast<float>();
      }
  }

  void BackgroundMultigrid::Grid::vmult(BlockVector &y, const BlockVector &v) const
  {
    A_.vmult(y, v);
    sum_over_ranks(y, communicator_);
    for (std::size_t t = 0; t < touched_.size(); ++t)
      y.row(touched_[t]) += (springs_[t] * v.row(touched_[t]).transpose()).transpose();
    if (!between_)
      return;
    BlockVector moved(static_cast<Eigen::Index>(touched_.size()), 3), forces;
    for (std::size_t t = 0; t < touched_.size(); ++t)
      moved.row(static_cast<Eigen::Index>(t)) = v.row(touched_[t]);
    between_->vmult(forces, moved);
    for (std::size_t t = 0; t < touched_.size(); ++t)
      y.row(touched_[t]) += forces.row(static_cast<Eigen::Index>(t));
  }

  void BackgroundMultigrid::Grid::apply_inverse_diagonal(BlockVector &y,
                                                         const BlockVector &v) const
  {
    y = inverse_diagonal_.cwiseProduct(v);
    for (std::size_t t = 0; t < touched_.size(); ++t)
      y.row(touched_[t]) = (inverses_[t] * v.row(touched_[t]).transpose()).transpose();
  }

  void BackgroundMultigrid::Grid::smoothing_step(const unsigned int k,
                                                 const bool is_first)
  {
    const ChebyshevStep step(k, largest_eigenvalue_);
    if (is_first)
      apply_inverse_diagonal(scratch_, b);
    else
      {
        vmult(product_, x);
        product_ = b - product_;
        apply_inverse_diagonal(scratch_, product_);
      }
    if (k == 0)
      direction_ = step.take * scratch_;
    else
      direction_ = step.keep * direction_ + step.take * scratch_;
    if (is_first)
      x = direction_;
    else
      x += direction_;
  }

  void BackgroundMultigrid::Grid::smooth_from_zero()
  {
    for (unsigned int k = 0; k < ChebyshevStep::degree; ++k)
      smoothing_step(k, k == 0);
  }

  void BackgroundMultigrid::Grid::smooth()
  {
    for (unsigned int k = 0; k < ChebyshevStep::degree; ++k)
      smoothing_step(k, false);
  }

  const BlockVector &BackgroundMultigrid::Grid::residual()
  {
    vmult(product_, x);
    product_ = b - product_;
    return product_;
  }

  void BackgroundMultigrid::Grid::solve()
  {
    const Eigen::Map<const Eigen::VectorXf> right(b.data(), b.size());
    const Eigen::VectorXd y = scale_.cwiseProduct(right.cast<double>());
    const Eigen::VectorXd z = scale_.cwiseProduct(factors_.solve(y));
    Eigen::Map<Eigen::VectorXf>(x.data(), x.size()) = z.cast<float>();
  }
} // namespace stiction
