#ifndef stiction_contact_dual_motion_search_h
#define stiction_contact_dual_motion_search_h

#include <Eigen/Core>

namespace stiction
{
  /// Which multipliers of the balance of a body to try next, from those that the method
  /// of multipliers made of the last ones: Anderson's mixing of a fixed point (H. F.
  /// Walker and P. Ni, Anderson acceleration for fixed-point iterations, 2011), of up to
  /// as many steps as there are multipliers, which finds that of a linear map.
  class MotionSearch
  {
  public:
    /// The next multipliers. @param tried, @param made of the same length in every call.
    Eigen::VectorXd next(const Eigen::VectorXd &tried, const Eigen::VectorXd &made);

  private:
    Eigen::VectorXd last_step_, last_made_;     ///< empty at the start
    Eigen::MatrixXd changes_of_step_, changes_; ///< of the calls before, the last first
  };
} // namespace stiction

#endif
