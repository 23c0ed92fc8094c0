#include <stiction/qp/anderson.h>

#include <Eigen/QR>

namespace stiction::qp
{
  namespace
  {
    // Older pairs belong to another contact set.
    constexpr std::size_t memory = 3;
  } // namespace



  Eigen::VectorXd
  Anderson::next(const Eigen::VectorXd &g, const Eigen::VectorXd &image)
  {
    images_.push_back(image);
    residuals_.emplace_back(image - g);
    if (images_.size() > memory)
      {
        images_.pop_front();
        residuals_.pop_front();
      }
    const auto n = static_cast<Eigen::Index>(images_.size()) - 1;
    if (n == 0)
      return image;

    Eigen::MatrixXd differences(g.size(), n);
    for (Eigen::Index j = 0; j < n; ++j)
      differences.col(j) = residuals_[j + 1] - residuals_[j];
    const Eigen::VectorXd weights =
      differences.colPivHouseholderQr().solve(residuals_.back());
    Eigen::VectorXd extrapolated = image;
    for (Eigen::Index j = 0; j < n; ++j)
      extrapolated -= weights(j) * (images_[j + 1] - images_[j]);
    return extrapolated.allFinite() ? extrapolated : image;
  }



  void
  Anderson::restart()
  {
    images_.clear();
    residuals_.clear();
  }
} // namespace stiction::qp
