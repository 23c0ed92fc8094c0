#include <stiction/contact/dual/motion_search.h>

#include <Eigen/QR>

#include <algorithm>
#include <utility>

namespace stiction
{
  namespace
  {
    // Of a step: what lies further is not in sight.
    constexpr double farthest = 1000.;

    // A column more, in front, of as many as there are rows.
    void add(Eigen::MatrixXd &columns, const Eigen::VectorXd &column)
    {
      const Eigen::Index kept = std::min(columns.cols(), column.size() - 1);
      Eigen::MatrixXd all(column.size(), kept + 1);
      all.col(0) = column;
      if (kept > 0)
        all.rightCols(kept) = columns.leftCols(kept);
      columns = std::move(all);
    }
  } // namespace

  Eigen::VectorXd MotionSearch::next(const Eigen::VectorXd &tried,
                                     const Eigen::VectorXd &made)
  {
    const Eigen::VectorXd step = made - tried;
    Eigen::VectorXd next       = made;
    if (last_step_.size() > 0 && step.norm() > last_step_.norm())
      changes_ = changes_of_step_ = Eigen::MatrixXd(); // other nodes touch or slip
    else if (last_step_.size() > 0)
      {
        add(changes_, made - last_made_);
        add(changes_of_step_, step - last_step_);
        const Eigen::VectorXd further =
          changes_ * changes_of_step_.colPivHouseholderQr().solve(step);
        if (further.norm() <= farthest * step.norm())
          next -= further;
      }
    last_step_ = step;
    last_made_ = made;
    return next;
  }
} // namespace stiction
