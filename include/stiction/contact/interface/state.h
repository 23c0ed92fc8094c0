#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/types.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>

#include <vector>

namespace stiction
{
  class ContactSurface;

  /// What friction remembers of the steps before. Empty: nothing, the body was as it
  /// is made.
  struct SlipHistory
  {
    /// The contact nodes it is about, by their first unknowns.
    std::vector<dealii::types::global_dof_index> nodes;
    /// U − u of the contact nodes at the end of the last step, U being the
    /// displacement of their obstacles but for what they turned: the slip of a step is
    /// counted from there, see ContactSurface::slip_origin(). Length 3m by Cartesian
    /// components, m.
    Eigen::VectorXd origin;
    /// The length of the way on which each contact node has slipped, counted in
    /// steps after which it was closed, length m, m.
    Eigen::VectorXd path;
    /// By how much the obstacles of all boundaries had turned, radians.
    std::vector<double> angles;
  };

  /// All that a computation has found: from it and the data of the problem
  /// follow the certificate and every result.
  struct State
  {
    LA::Vector u;              ///< displacement, m; hanging nodes have theirs
    Eigen::VectorXd lambda;    ///< contact forces, N, length 3m
    Eigen::VectorXd distances; ///< δ of pressed obstacles, m, see ObstacleMotion
    SlipHistory history;

    /// The largest S and uᵀKu of the certificates of the steps before, N and J. Beside
    /// them a body that was let go is judged, whose own forces are rounding.
    struct Scales
    {
      double force = 0., energy = 0.;

      /// Less is nothing beside them.
      Scales least() const { return {1e-6 * force, 1e-6 * energy}; }
    } scales = {};
  };

  /// What was found at a time.
  struct StepEnd
  {
    double time;
    State state;
  };

  /// The history in the order of the surface's nodes. An obstacle that moves by a
  /// formula may make others contact nodes than in the step before: those have none,
  /// and count slip from the undeformed body.
  SlipHistory on_nodes(const SlipHistory &history, const ContactSurface &surface);

  /// Contact forces on other frames of the contact nodes, which may be others as well, N.
  Eigen::VectorXd on_frames(const Eigen::VectorXd &lambda, const ContactSurface &before,
                            const ContactSurface &now);

  /// How far each contact node has slipped with the step that ends with this state, in
  /// which one that is open then does not slip, m, length m. Collective.
  Eigen::VectorXd slip_path(const State &state, const ContactSurface &surface);

  /// The history after a step that ended with this state. Collective.
  SlipHistory history_after(const State &state, const ContactSurface &surface);
} // namespace stiction
