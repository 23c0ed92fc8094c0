#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/sets/nonnegative_amounts.h>
#include <stiction/qp/unbalanced_load.h>

#include <Eigen/SVD>

#include <cmath>
#include <utility>
#include <vector>

namespace stiction::qp
{
  namespace
  {
    // Of the load: less is balanced.
    constexpr double balanced = 1e-8;

    // A force gains nothing if the cosine of its work with what is left is below this.
    constexpr double least_gain = 1e-9;

    // Of what a force could do at its node at best: with less it would have to be a
    // million times as large as what it bears. Normals of a mesh are no better known.
    constexpr double least_work = 1e-6;

    // Of all motions of all nodes: less is none.
    constexpr double rounding = 1e-10;

    constexpr unsigned int max_forces = 500;

    // Contact forces with some amount, and Gᵀ of them. The last entry of that is 1 for
    // those of which there are at most one in all.
    struct Candidate
    {
      Eigen::VectorXd work;
      std::vector<std::pair<Eigen::Index, Eigen::Vector3d>> forces;
      double amount = 0.;
    };

    // Σ amount × work is as near to b as amounts ≥ 0 can bring it; those of no use go.
    void find_amounts(std::vector<Candidate> &candidates, const Eigen::VectorXd &b)
    {
      const auto n = static_cast<Eigen::Index>(candidates.size());
      Eigen::MatrixXd A(b.size(), n);
      Eigen::VectorXd amounts(n);
      for (Eigen::Index k = 0; k < n; ++k)
        {
          A.col(k)   = candidates[k].work;
          amounts(k) = candidates[k].amount;
        }
      qp::find_amounts(A, b, amounts);
      for (Eigen::Index k = 0; k < n; ++k)
        candidates[k].amount = amounts(k);
      std::vector<Candidate> kept;
      for (Candidate &candidate : candidates)
        if (candidate.amount > 0.)
          kept.push_back(std::move(candidate));
      candidates = std::move(kept);
    }

    Eigen::Vector3d along(const Eigen::Vector3d &v, const double normal,
                          const double tangential)
    {
      const double size = v.tail<2>().norm();
      return size > 0. ? Eigen::Vector3d(normal, tangential * v(1) / size,
                                         tangential * v(2) / size)
                       : Eigen::Vector3d(normal, 0., 0.);
    }

    // What contact forces can do against a load that is left, along the motion of the
    // nodes that it is.
    class ForceSearch
    {
    public:
      ForceSearch(const Eigen::MatrixXd &G, const SlipBound &slip_bound,
                  const double size)
        : G_(G)
        , slip_bound_(slip_bound)
        , m_(slip_bound.n_nodes())
        , size_(size)
      {
      }

      // No given friction. That acts as a whole or in part: the amounts of all its
      // candidates add up to one with this one's.
      Candidate none() const { return candidate({}, size_); }

      // The one that gains most, without work if none does.
      Candidate best(const Eigen::VectorXd &left) const
      {
        const Eigen::VectorXd motion = G_ * left.head(G_.cols());
        double gain                  = least_gain * left.norm();
        Candidate next               = best_of_node(motion, gain);
        if (!slip_bound_.has_given())
          return next;
        Candidate given = given_against(motion);
        return given.work.dot(left) > gain * given.work.norm() ? given : next;
      }

    private:
      Candidate candidate(std::vector<std::pair<Eigen::Index, Eigen::Vector3d>> forces,
                          const double share) const
      {
        const Eigen::Index n = G_.cols();
        Candidate all{Eigen::VectorXd::Zero(n + 1), std::move(forces)};
        for (const auto &[i, force] : all.forces)
          all.work.head(n) += work(i, force);
        all.work(n) = share;
        return all;
      }

      Eigen::VectorXd work(const Eigen::Index i, const Eigen::Vector3d &force) const
      {
        return force(0) * G_.row(i) + force(1) * G_.row(i + m_) +
               force(2) * G_.row(i + 2 * m_);
      }

      // Of those that grow without end the one that does most work.
      Eigen::Vector3d largest_force(const Eigen::Index i,
                                    const Eigen::Vector3d &motion) const
      {
        return slip_bound_.is_tied(i) ? motion.normalized()
                                      : along(motion, 1., slip_bound_.coefficient()(i));
      }

      // The best of single nodes, by the work that a force does for its own length, if
      // that is more than the gain, which it sets.
      Candidate best_of_node(const Eigen::VectorXd &motion, double &gain) const
      {
        Eigen::Index best = -1;
        for (Eigen::Index i = 0; i < m_; ++i)
          {
            const Eigen::Vector3d v     = at_node(motion, i);
            const Eigen::Vector3d force = largest_force(i, v);
            if (force.dot(v) <= 0.)
              continue;
            const double done = work(i, force).norm();
            const double could =
              force.norm() *
              std::sqrt(G_.row(i).squaredNorm() + G_.row(i + m_).squaredNorm() +
                        G_.row(i + 2 * m_).squaredNorm());
            if (done > least_work * could && force.dot(v) > gain * done)
              {
                gain = force.dot(v) / done;
                best = i;
              }
          }
        return best < 0
                 ? Candidate()
                 : candidate({{best, largest_force(best, at_node(motion, best))}}, 0.);
      }

      Candidate given_against(const Eigen::VectorXd &motion) const
      {
        std::vector<std::pair<Eigen::Index, Eigen::Vector3d>> forces;
        for (Eigen::Index i = 0; i < m_; ++i)
          if (slip_bound_.is_given(i))
            forces.emplace_back(i,
                                along(at_node(motion, i), 0., slip_bound_.constant()(i)));
        return candidate(std::move(forces), size_);
      }

      const Eigen::MatrixXd &G_;
      const SlipBound &slip_bound_;
      Eigen::Index m_;
      double size_;
    };

    // λ, with no more than all of the given friction.
    Eigen::VectorXd sum_of(const std::vector<Candidate> &used, const Eigen::Index m,
                           const double size)
    {
      double share = 0.; // of given friction that acts, more than all where it lacks some
      for (const Candidate &one : used)
        share += one.amount * one.work.tail<1>()(0) / size;
      Eigen::VectorXd lambda = Eigen::VectorXd::Zero(3 * m);
      for (const Candidate &one : used)
        for (const auto &[i, force] : one.forces)
          {
            const bool is_part = one.work.tail<1>()(0) > 0. && share > 1.;
            set_at_node(lambda, i,
                        at_node(lambda, i) + one.amount / (is_part ? share : 1.) * force);
          }
      return lambda;
    }
  } // namespace

  UnbalancedLoad unbalanced_load(const EqualityConstraint &constraint,
                                 const SlipBound &slip_bound)
  {
    const auto &[G, e]   = constraint;
    const Eigen::Index n = e.size();
    const Eigen::Index m = slip_bound.n_nodes();
    const double size    = e.norm();
    if (!(size > 0.))
      return {Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(3 * m), 0.};

    const ForceSearch search(G, slip_bound, size);
    Eigen::VectorXd b    = Eigen::VectorXd::Zero(n + 1);
    b.head(n)            = e;
    Eigen::VectorXd left = b;
    std::vector<Candidate> used;
    if (slip_bound.has_given())
      {
        b(n) = size;
        used.push_back(search.none());
        used.back().amount = 1.;
      }
    for (unsigned int k = 0; k < max_forces; ++k)
      {
        Candidate next = search.best(left);
        if (next.work.size() == 0)
          break; // no force can do more
        used.push_back(std::move(next));
        find_amounts(used, b);
        left = b;
        for (const Candidate &one : used)
          left -= one.amount * one.work;
        // ... or nothing is proved
        if (left.norm() <= balanced * size || k + 1 == max_forces)
          {
            left.setZero();
            break;
          }
      }
    return {left.head(n), sum_of(used, m, size), left.head(n).norm() / size};
  }

  std::pair<Eigen::MatrixXd, Eigen::MatrixXd> resisted_and_others(
    const Eigen::MatrixXd &G, const SlipBound &slip_bound)
  {
    const Eigen::Index n = G.cols(), m = slip_bound.n_nodes();
    if (m == 0)
      return {Eigen::MatrixXd(n, 0), Eigen::MatrixXd::Identity(n, n)};
    Eigen::MatrixXd felt = G;
    for (Eigen::Index i = 0; i < m; ++i)
      if (slip_bound.is_frictionless(i))
        felt.row(i + m) = felt.row(i + 2 * m) = Eigen::RowVectorXd::Zero(n);
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(felt,
                                             Eigen::ComputeThinU | Eigen::ComputeFullV);
    Eigen::Index rank = 0;
    while (rank < svd.singularValues().size() &&
           svd.singularValues()(rank) > rounding * G.norm())
      ++rank;
    return {svd.matrixV().leftCols(rank), svd.matrixV().rightCols(n - rank)};
  }
} // namespace stiction::qp
