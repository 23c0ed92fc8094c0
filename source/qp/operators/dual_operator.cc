#include <stiction/qp/operators/dual_operator.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stiction
{
  namespace
  {
    // Of the largest entry of h.
    constexpr double rounding_of_h = 1e-12;

    unsigned long thirds(const DualBlock block)
    {
      switch (block)
        {
          case DualBlock::normal:
            return 1;
          case DualBlock::tangential:
            return 2;
          default:
            return 3;
        }
    }
  } // namespace

  DualOperator::DualOperator(const Eigen::Index n_nodes)
    : n_nodes_(n_nodes)
  {
  }

  void DualOperator::set_right_hand_side(Eigen::VectorXd h) { h_ = std::move(h); }

  void DualOperator::vmult(const DualBlock rows, const DualBlock columns,
                           Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    n_ninths_ += thirds(rows) * thirds(columns);
    apply(rows, columns, dst, src);
  }

  qp::SymmetricOperator DualOperator::diagonal_block(const DualBlock block) const
  {
    return {length(block),
            [this, block](Eigen::VectorXd &dst, const Eigen::VectorXd &src) {
              vmult(block, block, dst, src);
            }};
  }

  Eigen::Index DualOperator::begin(const DualBlock block) const
  {
    return block == DualBlock::tangential ? n_nodes_ : 0;
  }

  Eigen::Index DualOperator::length(const DualBlock block) const
  {
    return static_cast<Eigen::Index>(thirds(block)) * n_nodes_;
  }

  const Eigen::VectorXd &DualOperator::nodal_compliance() const
  {
    if (nodal_compliance_.size() == 0)
      nodal_compliance_ = compute_nodal_compliance();
    return nodal_compliance_;
  }

  Eigen::VectorXd DualOperator::estimated_compliance(const Eigen::VectorXd &shape) const
  {
    // with random signs zᵀQz is the trace of Q, but for a few per cent
    Eigen::VectorXd z(3 * n_nodes_), Qz;
    unsigned int random = 1;
    for (double &sign : z)
      {
        random = 1664525u * random + 1013904223u; // the same on all ranks
        sign   = random >> 31 != 0 ? 1. : -1.;
      }
    vmult(DualBlock::all, DualBlock::all, Qz, z);
    return shape * (z.dot(Qz) / (3. * shape.sum()));
  }

  DecoupledScales decoupled_scales(const DualOperator &Q, const qp::SlipBound &slip_bound)
  {
    const Eigen::Index m     = Q.n_nodes();
    const Eigen::VectorXd &h = Q.right_hand_side();
    const Eigen::VectorXd &c = Q.nodal_compliance();
    DecoupledScales result;
    const double rounding = rounding_of_h * (m > 0 ? h.lpNorm<Eigen::Infinity>() : 0.);
    // nothing has to undo an open gap
    const Eigen::VectorXd normal =
      (h.head(m).array() > rounding).select(h.head(m), 0.).cwiseQuotient(c);
    const Eigen::VectorXd bound = slip_bound.at(normal);
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const double slip = std::hypot(h(i + m), h(i + 2 * m)) / c(i);
        const double size = slip_bound.is_tied(i)
                              ? std::hypot(h(i) / c(i), slip)
                              : std::hypot(normal(i), std::min(slip, bound(i)));
        result.force += size;
        result.work += size * size * c(i);
      }
    return result;
  }

  // ---------------------------------------------------- DenseDualOperator

  DenseDualOperator::DenseDualOperator(Eigen::MatrixXd Q, Eigen::VectorXd h)
    : DualOperator(Q.rows() / 3)
    , Q_(std::move(Q))
  {
    eigen_assert(Q_.rows() == Q_.cols() && Q_.rows() == h.size());
    set_right_hand_side(std::move(h));
  }

  Eigen::VectorXd DenseDualOperator::compute_nodal_compliance() const
  {
    const Eigen::Index m = n_nodes();
    return (Q_.diagonal().head(m) + Q_.diagonal().segment(m, m) + Q_.diagonal().tail(m)) /
           3.;
  }

  void DenseDualOperator::apply(const DualBlock rows, const DualBlock columns,
                                Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    const auto block =
      Q_.block(begin(rows), begin(columns), length(rows), length(columns));
    if (rows == columns) // reads half of the block, and memory is what it costs
      dst.noalias() = block.selfadjointView<Eigen::Lower>() * src;
    else
      dst.noalias() = block * src;
  }
} // namespace stiction
