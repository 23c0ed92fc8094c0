#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>

#include <limits>
#include <utility>

namespace stiction::qp
{
  SlipBound::SlipBound(Eigen::VectorXd c, Eigen::VectorXd F, const bool is_coulomb)
    : constant_(std::move(c))
    , coefficient_(std::move(F))
    , is_coulomb_(is_coulomb)
  {
  }

  SlipBound SlipBound::given(Eigen::VectorXd g)
  {
    const Eigen::Index m = g.size();
    return {std::move(g), Eigen::VectorXd::Zero(m), false};
  }

  SlipBound SlipBound::coulomb(Eigen::VectorXd F)
  {
    const Eigen::Index m = F.size();
    return {Eigen::VectorXd::Zero(m), std::move(F), true};
  }

  SlipBound SlipBound::mixed(Eigen::VectorXd c, Eigen::VectorXd F)
  {
    return {std::move(c), std::move(F), true};
  }

  bool SlipBound::is_tied(const Eigen::Index node) const
  {
    return qp::is_tied(constant_(node));
  }

  bool SlipBound::has_tied() const { return (constant_.array() == tied).any(); }

  bool SlipBound::has_given() const
  {
    return (constant_.array() > 0. && constant_.array() != tied).any();
  }

  Eigen::VectorXd SlipBound::at(const Eigen::VectorXd &lambda) const
  {
    if (!is_coulomb_)
      return constant_;
    return constant_ + coefficient_.cwiseProduct(lambda.head(n_nodes()).cwiseMax(0.));
  }

  void project(Eigen::VectorXd &x, const SlipBound &slip_bound)
  {
    if (!x.allFinite())
      return;
    if (x.size() == 2 * slip_bound.n_nodes())
      Discs(slip_bound.at(x)).project(x);
    else
      HalfLinesTimesDiscs(slip_bound.at(x)).project(x);
  }

  double natural_residual(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                          const SlipBound &slip_bound, const Scaling &scaling)
  {
    const Eigen::VectorXd bound = slip_bound.at(x);
    if (!x.allFinite() || bound.hasNaN()) // no set has such radii
      return std::numeric_limits<double>::quiet_NaN();
    if (x.size() == 2 * slip_bound.n_nodes())
      return Discs(bound).natural_residual(x, gradient, scaling);
    return HalfLinesTimesDiscs(bound).natural_residual(x, gradient, scaling);
  }
} // namespace stiction::qp
