#include <stiction/qp/slip_bound.h>

#include <utility>

namespace stiction::qp
{
  SlipBound::SlipBound(Eigen::VectorXd data, const bool is_coulomb)
    : data_(std::move(data))
    , is_coulomb_(is_coulomb)
  {
  }



  SlipBound
  SlipBound::given(Eigen::VectorXd g)
  {
    return SlipBound(std::move(g), false);
  }



  SlipBound
  SlipBound::coulomb(Eigen::VectorXd F)
  {
    return SlipBound(std::move(F), true);
  }



  Eigen::VectorXd
  SlipBound::at(const Eigen::VectorXd &lambda) const
  {
    if (!is_coulomb_)
      return data_;
    return data_.cwiseProduct(lambda.head(n_nodes()).cwiseMax(0.));
  }
} // namespace stiction::qp
