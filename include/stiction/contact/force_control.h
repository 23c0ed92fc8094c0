#ifndef stiction_contact_force_control_h
#define stiction_contact_force_control_h

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <string>

namespace stiction
{
  class ContactSurface;

  /// Finds how far obstacles have to move until they press on the body with
  /// the forces that are prescribed.
  ///
  /// The force on an obstacle at rest is a function of its distance alone, the
  /// contact problem being solved for every distance that is tried: none as
  /// long as it is away, then growing. Its root is found by the secant method,
  /// for one obstacle safeguarded by an interval around the root, for several
  /// in Broyden's form. There is nothing to tune: the first distance comes from
  /// Hertz' formula for the part of the surface that the obstacle would cut.
  class ForceControl
  {
  public:
    /// @param youngs_modulus of the body, Pa: for the first distance only.
    ForceControl(const ContactSurface &surface, double youngs_modulus);

    /// Where the obstacles are to be.
    const Eigen::VectorXd &
    distances() const
    {
      return distances_;
    }

    /// Before the same obstacles press on another mesh of the body: the
    /// distances and how the forces change with them are kept.
    void
    begin_mesh();

    /// What came out at the present distances.
    struct Outcome
    {
      Eigen::VectorXd forces;    ///< on the body, N
      Eigen::VectorXd clearance; ///< how far it is to contact, m; 0 in contact
    };

    /// Takes note of what came out, and moves the obstacles on unless every
    /// force is the prescribed one but for @p tolerance (N).
    ///
    /// @return whether they were moved. If not, and reason() says something,
    ///   the forces cannot be reached.
    bool
    advance(const Outcome &outcome, double tolerance);

    /// Why the forces were not reached, and what to change; empty otherwise.
    const std::string &
    reason() const
    {
      return reason_;
    }

    /// Distances that were tried so far, on all meshes.
    unsigned int
    n_trials() const
    {
      return n_trials_;
    }

  private:
    void
    learn(const Eigen::VectorXd &forces);

    Eigen::VectorXd
    next_step(const Outcome &outcome) const;

    void
    stay_within_interval(double force, double &next);

    const Eigen::VectorXd prescribed_;
    double size_; ///< of the contact boundary, m: no obstacle goes further

    Eigen::VectorXd distances_;
    Eigen::VectorXd touch_; ///< where the undeformed body is met
    Eigen::VectorXd reach_; ///< how far beyond that the search has come

    struct Trial
    {
      Eigen::VectorXd distances, forces;
    };
    std::optional<Trial>
      last_; ///< on this mesh, with every obstacle in contact
    std::optional<Eigen::MatrixXd> slope_; ///< d forces/d distances, N/m

    // of one obstacle alone
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    double too_near_ = infinity, too_far_ = -infinity;
    unsigned int n_on_one_side_ = 0;

    unsigned int n_trials_ = 0, n_trials_on_mesh_ = 0;
    std::string reason_;
  };



  /// What pressed obstacles do in a solution of the contact problem.
  ///
  /// @param directions C of ObstacleMotion, 3m × n.
  /// @param lambda, gradient contact forces and r = (remaining gap; −slip).
  ForceControl::Outcome
  outcome_of(const Eigen::MatrixXd &directions,
             const Eigen::VectorXd &lambda,
             const Eigen::VectorXd &gradient);
} // namespace stiction

#endif
