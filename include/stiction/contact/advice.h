#ifndef stiction_contact_advice_h
#define stiction_contact_advice_h

#include <string>

namespace stiction
{
  namespace qp
  {
    class SlipBound;
  }

  /// What there is to say of the friction of a problem that no method comes
  /// closer to solving: ", or lower ..." where the coefficient is so large that
  /// there may be no solution or several, otherwise nothing.
  std::string
  advice_on_friction(const qp::SlipBound &slip_bound);
} // namespace stiction

#endif
