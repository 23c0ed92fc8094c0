#include <stiction/contact/advice.h>
#include <stiction/qp/slip_bound.h>

#include <sstream>

namespace stiction
{
  namespace
  {
    // Solutions are proved to exist and to be unique for small coefficients
    // only; examples of none or several are known from about 1 on.
    constexpr double large_coefficient = 1.;
  } // namespace



  std::string
  advice_on_friction(const qp::SlipBound &slip_bound)
  {
    const double coefficient = slip_bound.largest_coefficient();
    if (coefficient < large_coefficient)
      return {};
    std::ostringstream out;
    out << ", or lower 'Friction/Coefficient': with " << coefficient
        << " there may be no solution or several";
    return out.str();
  }
} // namespace stiction
