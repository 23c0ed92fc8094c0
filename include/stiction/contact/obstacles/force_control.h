#ifndef stiction_contact_obstacles_force_control_h
#define stiction_contact_obstacles_force_control_h

#include <Eigen/Core>

#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace stiction
{
  /// Finds how far obstacles have to move until they press on the body with
  /// the forces that are prescribed.
  ///
  /// The force on an obstacle at rest is a function of its distance alone, the
  /// contact problem being solved for every distance that is tried: none as
  /// long as it is away, then growing. The distance of one obstacle is found by
  /// the secant method in logarithms, where punch, sphere and cone are straight
  /// lines, safeguarded by an interval around it. The forces of several are,
  /// without friction, the gradient of a convex function, the least energy for
  /// given distances, minus forces times distances, which is minimised by the
  /// BFGS method with a search along lines.
  class ForceControl
  {
  public:
    /// Where the search begins and ends, one entry an obstacle.
    struct Range
    {
      Eigen::VectorXd touch; ///< the distance of first contact, m
      Eigen::VectorXd reach; ///< how far beyond it to begin, m, > 0
      double largest_reach;  ///< m: beyond that there is no use in going on
    };

    /// @param prescribed forces, N, > 0.
    ForceControl(Eigen::VectorXd prescribed, Range range);

    /// Where the obstacles are to be.
    const Eigen::VectorXd &distances() const { return distances_; }

    /// What came out at some distances.
    struct Outcome
    {
      Eigen::VectorXd forces;    ///< on the body, N
      Eigen::VectorXd clearance; ///< how far it is to contact, m; 0 in contact
      double force_scale = 1.;   ///< S of the certificate, N
      std::string reason;        ///< if the contact problem was not solved: why not
    };

    /// Solves the contact problem with the obstacles at distances() to an
    /// accuracy, in the figures of the certificate.
    using Solve = std::function<Outcome(double accuracy)>;

    /// Moves the obstacles until the relative error of every force is below the
    /// tolerance, and the contact problem is solved to @p finest_accuracy, or
    /// to as much less as the forces are smaller than the others. On another
    /// mesh of the body it goes on from the distances found before.
    ///
    /// @return why that was not reached, and what to change; empty: it was.
    std::string press(const Solve &solve, double tolerance, double finest_accuracy);

    /// Contact problems that were solved so far, on all meshes.
    unsigned int n_trials() const { return n_trials_; }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    void begin_mesh();

    /// @param noise of the forces, N.
    /// @return why there is no use in going on; empty: the obstacles moved.
    std::string advance(const Outcome &outcome, double noise);

    Eigen::VectorXd place_after(const Outcome &outcome, double noise);

    Eigen::MatrixXd first_compliance(const Eigen::VectorXd &forces) const;

    double place_of_one(double force, double noise);

    Eigen::VectorXd places_of_several(const Eigen::VectorXd &forces, double noise);

    double interpolate() const;

    /// Of one obstacle alone: notes on which side of the root it is, and keeps
    /// the next distance between both.
    void stay_within_interval(double error, double noise, double &next);

    const Eigen::VectorXd prescribed_;
    Range range_; ///< its reach: as far as the search has come
    const Eigen::VectorXd first_reach_;
    Eigen::VectorXd distances_;

    struct Trial
    {
      Eigen::VectorXd distances, forces;
    };
    /// The last places on this mesh that were worth going on from.
    std::optional<Trial> last_, before_last_;
    std::optional<Eigen::MatrixXd> compliance_; ///< d distances/d forces, m/N

    // of several obstacles: a line from last_
    struct Line
    {
      Line() = default;
      Line(Eigen::VectorXd along, const Eigen::VectorXd &error);

      // The next place on it, from the slope at the present one.
      double next(double slope);

      Eigen::VectorXd direction;
      double slope_at_start = 0.; // error · direction, < 0
      double at = 1., below = 0., above = infinity;
      double slope_below = 0., slope_above = 0.;
    };
    Line line_;

    // of one obstacle alone
    double too_near_ = infinity, too_far_ = -infinity;
    double last_error_ = infinity, error_before_ = infinity; ///< N

    unsigned int n_trials_ = 0;
  };

  /// max_j |F_j − P_j|/P_j of forces F and prescribed ones P.
  double largest_relative_error(const Eigen::VectorXd &forces,
                                const Eigen::VectorXd &prescribed);
} // namespace stiction

#endif
