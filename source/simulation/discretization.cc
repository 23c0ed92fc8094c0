#include <stiction/simulation/discretization.h>

namespace stiction
{
  void Discretization::set_time(const ContactParameters &contact, const double time,
                                const SlipHistory &history)
  {
    if (time == elasticity->time() && history.origin.size() == 0)
      return;
    elasticity->set_time(time);
    ContactSurface then(*elasticity, contact);
    then.count_slip_from(on_nodes(history, then).origin);
    const bool is_same_map = then.B() == surface->B();
    *surface               = std::move(then);
    if (!is_same_map)
      solver.reset();
    else if (solver)
      solver->update();
  }
} // namespace stiction
