#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/unbalanced_load.h>

#include <Eigen/QR>
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
      // the amounts of these alone, whatever their signs
      std::vector<bool> is_used(candidates.size());
      for (std::size_t k = 0; k < candidates.size(); ++k)
        is_used[k] = candidates[k].amount > 0.;
      is_used.back() = true; // the new one, which gains
      while (true)
        {
          std::vector<std::size_t> used;
          for (std::size_t k = 0; k < candidates.size(); ++k)
            if (is_used[k])
              used.push_back(k);
          Eigen::MatrixXd A(b.size(), static_cast<Eigen::Index>(used.size()));
          for (std::size_t j = 0; j < used.size(); ++j)
            A.col(static_cast<Eigen::Index>(j)) = candidates[used[j]].work;
          const Eigen::VectorXd wanted = A.completeOrthogonalDecomposition().solve(b);

          // as far towards them as all stay positive
          double part      = 1.;
          std::size_t last = candidates.size();
          for (std::size_t j = 0; j < used.size(); ++j)
            {
              const double now = candidates[used[j]].amount;
              const double z   = wanted(static_cast<Eigen::Index>(j));
              if (z < 0. && now / (now - z) < part)
                {
                  part = now / (now - z);
                  last = used[j];
                }
            }
          for (std::size_t j = 0; j < used.size(); ++j)
            {
              double &amount = candidates[used[j]].amount;
              amount += part * (wanted(static_cast<Eigen::Index>(j)) - amount);
            }
          if (last == candidates.size())
            break;
          candidates[last].amount = 0.;
          is_used[last]           = false;
        }
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
  } // namespace

  UnbalancedLoad unbalanced_load(const EqualityConstraint &constraint,
                                 const SlipBound &slip_bound)
  {
    const auto &[G, e]    = constraint;
    const Eigen::Index n  = e.size();
    const Eigen::Index m  = slip_bound.n_nodes();
    const double size     = e.norm();
    UnbalancedLoad result = {e, Eigen::VectorXd::Zero(3 * m), 1.};
    bool has_constant     = false;
    for (Eigen::Index i = 0; i < m; ++i)
      has_constant = has_constant || slip_bound.is_given(i);
    if (!(size > 0.))
      return {Eigen::VectorXd::Zero(n), result.lambda, 0.};

    const auto candidate =
      [&, &G = G](std::vector<std::pair<Eigen::Index, Eigen::Vector3d>> forces,
                  const double share) {
        Candidate all{Eigen::VectorXd::Zero(n + 1), std::move(forces)};
        for (const auto &[i, force] : all.forces)
          for (Eigen::Index c = 0; c < 3; ++c)
            all.work.head(n) += force(c) * G.row(i + c * m).transpose();
        all.work(n) = share;
        return all;
      };
    // of those that grow without end the one that does most work
    const auto largest_force = [&](const Eigen::Index i, const Eigen::Vector3d &motion) {
      return slip_bound.is_tied(i) ? motion.normalized()
                                   : along(motion, 1., slip_bound.coefficient()(i));
    };
    const auto size_at = [&, &G = G](const Eigen::Index i) {
      return std::sqrt(G.row(i).squaredNorm() + G.row(i + m).squaredNorm() +
                       G.row(i + 2 * m).squaredNorm());
    };
    // given friction acts as a whole or in part: the parts and what is left are one
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 1);
    b.head(n)         = e;
    std::vector<Candidate> used;
    if (has_constant)
      {
        b(n) = size;
        used.push_back(candidate({}, size));
        used.back().amount = 1.;
      }
    Eigen::VectorXd left = b;
    left(n)              = 0.;
    for (unsigned int k = 0; k < max_forces; ++k)
      {
        const Eigen::VectorXd v = G * left.head(n); // the nodes' motion
        // the best of single nodes, by the work that a force does for its own length
        double most       = least_gain * left.norm();
        Eigen::Index best = -1;
        Eigen::VectorXd work(n);
        for (Eigen::Index i = 0; i < m; ++i)
          {
            const Eigen::Vector3d motion = at_node(v, i);
            const Eigen::Vector3d force  = largest_force(i, motion);
            if (force.dot(motion) <= 0.)
              continue;
            work =
              force(0) * G.row(i) + force(1) * G.row(i + m) + force(2) * G.row(i + 2 * m);
            const double all = force.norm() * size_at(i);
            if (work.norm() > least_work * all && force.dot(motion) > most * work.norm())
              {
                most = force.dot(motion) / work.norm();
                best = i;
              }
          }
        Candidate next;
        if (best >= 0)
          next = candidate({{best, largest_force(best, at_node(v, best))}}, 0.);
        if (has_constant)
          {
            std::vector<std::pair<Eigen::Index, Eigen::Vector3d>> forces;
            for (Eigen::Index i = 0; i < m; ++i)
              if (slip_bound.is_given(i))
                forces.emplace_back(i,
                                    along(at_node(v, i), 0., slip_bound.constant()(i)));
            Candidate together = candidate(std::move(forces), size);
            const double gain  = together.work.dot(left) / together.work.norm();
            if (gain > most)
              next = std::move(together);
          }
        if (next.work.size() == 0)
          break; // no force can do more
        used.push_back(std::move(next));
        find_amounts(used, b);
        left = b;
        for (const Candidate &one : used)
          left -= one.amount * one.work;
        if (left.norm() <= balanced * size)
          {
            left.setZero();
            break;
          }
        if (k + 1 == max_forces)
          left.setZero(); // nothing is proved
      }
    result.rho   = left.head(n);
    result.part  = result.rho.norm() / size;
    double share = 0.; // of given friction that acts, more than all where it lacks some
    for (const Candidate &one : used)
      share += one.amount * one.work(n) / size;
    for (Candidate &one : used)
      if (one.work(n) > 0. && share > 1.)
        one.amount /= share;
    for (const Candidate &one : used)
      for (const auto &[i, force] : one.forces)
        set_at_node(result.lambda, i, at_node(result.lambda, i) + one.amount * force);
    return result;
  }

  Eigen::MatrixXd unresisted_motions(const Eigen::MatrixXd &G,
                                     const SlipBound &slip_bound)
  {
    const Eigen::Index n = G.cols(), m = slip_bound.n_nodes();
    if (m == 0)
      return Eigen::MatrixXd::Identity(n, n);
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
    return svd.matrixV().rightCols(n - rank);
  }
} // namespace stiction::qp
