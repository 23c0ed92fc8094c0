#pragma once

#include <deal.II/base/types.h>

#include <Eigen/Core>

#include <vector>

namespace stiction
{
  class ContactSurface;
  struct State;

  /// What friction remembers of the steps before. Empty: nothing, the body was as it
  /// is made.
  struct SlipHistory
  {
    /// The contact nodes it is about, by their first unknowns.
    std::vector<dealii::types::global_dof_index> nodes;
    /// U − u of the contact nodes at the end of the last step, U being the
    /// displacement of their obstacles: the slip of a step is counted from there.
    /// Length 3m by Cartesian components, m.
    Eigen::VectorXd origin;
    /// The length of the way on which each contact node has slipped, counted in
    /// steps after which it was closed, length m, m.
    Eigen::VectorXd path;
  };

  /// The history in the order of the surface's nodes. An obstacle that moves by a
  /// formula may make others contact nodes than in the step before: those have none,
  /// and count slip from the undeformed body.
  SlipHistory on_nodes(const SlipHistory &history, const ContactSurface &surface);

  /// How far each contact node has slipped with the step that ends with this state, in
  /// which one that is open then does not slip, m, length m. Collective.
  Eigen::VectorXd slip_path(const State &state, const ContactSurface &surface);

  /// The history after a step that ended with this state. Collective.
  SlipHistory history_after(const State &state, const ContactSurface &surface);
} // namespace stiction
