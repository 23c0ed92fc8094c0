#include <stiction/qp/sets/nonnegative_amounts.h>

#include <Eigen/QR>

#include <vector>

namespace stiction::qp
{
  void find_amounts(const Eigen::MatrixXd &A, const Eigen::VectorXd &b,
                    Eigen::VectorXd &amounts)
  {
    std::vector<Eigen::Index> used;
    for (Eigen::Index k = 0; k < A.cols(); ++k)
      if (amounts(k) > 0. || k + 1 == A.cols())
        used.push_back(k);
    while (true)
      {
        // the amounts of these alone, whatever their signs
        Eigen::MatrixXd columns(A.rows(), static_cast<Eigen::Index>(used.size()));
        for (std::size_t j = 0; j < used.size(); ++j)
          columns.col(static_cast<Eigen::Index>(j)) = A.col(used[j]);
        const Eigen::VectorXd wanted = columns.completeOrthogonalDecomposition().solve(b);

        // as far towards them as all stay positive
        double part = 1.;
        auto last   = used.end();
        for (auto k = used.begin(); k != used.end(); ++k)
          {
            const double now = amounts(*k), z = wanted(k - used.begin());
            if (z < 0. && now / (now - z) < part)
              {
                part = now / (now - z);
                last = k;
              }
          }
        for (std::size_t j = 0; j < used.size(); ++j)
          {
            double &amount = amounts(used[j]);
            amount += part * (wanted(static_cast<Eigen::Index>(j)) - amount);
          }
        if (last == used.end())
          return;
        amounts(*last) = 0.;
        used.erase(last);
      }
  }
} // namespace stiction::qp
