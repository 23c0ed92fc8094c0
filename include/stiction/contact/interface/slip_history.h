#ifndef stiction_contact_interface_slip_history_h
#define stiction_contact_interface_slip_history_h

#include <Eigen/Core>

namespace stiction
{
  class ContactSurface;
  struct State;

  /// What friction remembers of the steps before. Empty: nothing, the body was as it
  /// is made.
  struct SlipHistory
  {
    /// U − u of the contact nodes at the end of the last step, U being the
    /// displacement of their obstacles: the slip of a step is counted from there.
    /// Length 3m by Cartesian components, m.
    Eigen::VectorXd origin;
    /// The length of the way on which each contact node has slipped, counted in
    /// steps after which it was closed, length m, m.
    Eigen::VectorXd path;
  };

  /// The history after a step that ended with this state. Collective.
  SlipHistory history_after(const State &state, const ContactSurface &surface);
} // namespace stiction

#endif
