#pragma once

#include <Eigen/Core>

namespace stiction
{
  /// Where to try obstacles next that forces press on, from the places tried so far
  /// and what the forces lacked there: a secant step for each obstacle, between a place
  /// where it presses too much and one where it presses too little.
  class PlaceSearch
  {
  public:
    /// @param forces prescribed, N, > 0.
    explicit PlaceSearch(const Eigen::VectorXd &forces);

    /// The next places, m.
    ///
    /// @param place where the obstacles are, m. @param missing by what the forces fall
    ///   short there, N. @param accuracy of these, relative to the prescribed forces.
    Eigen::VectorXd next(const Eigen::VectorXd &place, const Eigen::VectorXd &missing,
                         double accuracy);

  private:
    void add_secant_step(Eigen::VectorXd &next, const Eigen::VectorXd &place,
                         const Eigen::VectorXd &missing,
                         const Eigen::VectorXd &noise) const;

    void stay_between(Eigen::VectorXd &next, const Eigen::VectorXd &place,
                      const Eigen::VectorXd &missing);

    const Eigen::VectorXd forces_;
    Eigen::VectorXd last_place_, last_missing_; ///< empty at the start
    Eigen::VectorXd too_near_, too_far_;        ///< infinite if there is none
  };
} // namespace stiction
