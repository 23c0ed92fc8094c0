#include <stiction/qp/operators/nodal_scaling.h>
#include <stiction/qp/sets/feasible_set.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace stiction::qp
{
  NodalScaling::NodalScaling(Eigen::VectorXd scales)
    : scales_(std::move(scales))
  {
    for (const double scale : scales_)
      if (!(scale > 0. && std::isfinite(scale)))
        throw std::invalid_argument("the scale of a node must be > 0");
  }

  NodalScaling NodalScaling::from_diagonal(const Eigen::VectorXd &diagonal,
                                           const Eigen::Index n_nodes)
  {
    if (n_nodes == 0)
      return NodalScaling(Eigen::VectorXd());
    eigen_assert(diagonal.size() % n_nodes == 0);
    const Eigen::Map<const Eigen::MatrixXd> by_component(diagonal.data(), n_nodes,
                                                         diagonal.size() / n_nodes);
    const Eigen::VectorXd mean = by_component.rowwise().mean();
    return NodalScaling(mean.cwiseSqrt().cwiseInverse());
  }

  Eigen::VectorXd NodalScaling::times(const Eigen::VectorXd &v) const
  {
    const Eigen::Index m = n_nodes();
    eigen_assert(m > 0 ? v.size() % m == 0 : v.size() == 0);
    Eigen::VectorXd result(v.size());
    for (Eigen::Index first = 0; first < v.size(); first += m)
      result.segment(first, m) = v.segment(first, m).cwiseProduct(scales_);
    return result;
  }

  Eigen::VectorXd NodalScaling::divide(const Eigen::VectorXd &v) const
  {
    const Eigen::Index m = n_nodes();
    eigen_assert(m > 0 ? v.size() % m == 0 : v.size() == 0);
    Eigen::VectorXd result(v.size());
    for (Eigen::Index first = 0; first < v.size(); first += m)
      result.segment(first, m) = v.segment(first, m).cwiseQuotient(scales_);
    return result;
  }

  Scaling NodalScaling::scaled(const Scaling &scaling) const
  {
    const Eigen::VectorXd weight =
      scaling.weight.size() == 0 ? scales_ : times(scaling.weight);
    return {divide(scaling.force), scaling.displacement, weight};
  }
} // namespace stiction::qp
