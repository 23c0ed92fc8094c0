#include <stiction/simulation/discretization.h>

#include <utility>

namespace stiction
{
  void Discretization::set_time(const ContactParameters &contact, const double time,
                                const SlipHistory &history, const State *const there)
  {
    if (time == elasticity->time() && history.origin.size() == 0 &&
        !surface->slides_far())
      return;
    elasticity->set_time(time);
    place_obstacles(contact, history, there);
  }

  ContactSurface Discretization::place_obstacles(const ContactParameters &contact,
                                                 const SlipHistory &history,
                                                 const State *const there)
  {
    ContactSurface before(*elasticity, contact, history, there, surface.get());
    std::swap(before, *surface);
    if (!surface->B().is_turned(before.B()))
      solver.reset();
    else if (solver)
      solver->update();
    return before;
  }
} // namespace stiction
