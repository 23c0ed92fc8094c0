#include <stiction/contact/obstacles/place_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
  } // namespace

  PlaceSearch::PlaceSearch(const Eigen::VectorXd &forces)
    : forces_(forces)
    , too_near_(Eigen::VectorXd::Constant(forces.size(), infinity))
    , too_far_(-too_near_)
  {
  }

  Eigen::VectorXd PlaceSearch::next(const Eigen::VectorXd &place,
                                    const Eigen::VectorXd &missing, const double accuracy)
  {
    Eigen::VectorXd next = place;
    if (last_place_.size() > 0)
      add_secant_step(next, place, missing, accuracy * forces_);
    stay_between(next, place, missing);
    last_place_   = place;
    last_missing_ = missing;
    return next;
  }

  void PlaceSearch::add_secant_step(Eigen::VectorXd &next, const Eigen::VectorXd &place,
                                    const Eigen::VectorXd &missing,
                                    const Eigen::VectorXd &noise) const
  {
    const Eigen::VectorXd way = place - last_place_, change = last_missing_ - missing;
    for (Eigen::Index j = 0; j < next.size(); ++j)
      if (std::abs(change(j)) > noise(j) && way(j) * change(j) > 0.)
        next(j) += way(j) / change(j) * missing(j);
  }

  void PlaceSearch::stay_between(Eigen::VectorXd &next, const Eigen::VectorXd &place,
                                 const Eigen::VectorXd &missing)
  {
    for (Eigen::Index j = 0; j < next.size(); ++j)
      {
        // others that move shift the interval: an end that is contradicted goes
        if (missing(j) > 0.)
          {
            too_far_(j) = std::max(too_far_(j), place(j));
            if (place(j) >= too_near_(j))
              too_near_(j) = infinity;
          }
        else
          {
            too_near_(j) = std::min(too_near_(j), place(j));
            if (place(j) <= too_far_(j))
              too_far_(j) = -infinity;
          }
        const bool has_no_force = missing(j) >= forces_(j);
        if (std::isfinite(too_near_(j)) && std::isfinite(too_far_(j)) &&
            (has_no_force || next(j) <= too_far_(j) || next(j) >= too_near_(j)))
          next(j) = 0.5 * (too_near_(j) + too_far_(j));
      }
  }
} // namespace stiction
