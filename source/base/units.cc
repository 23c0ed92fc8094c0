#include <stiction/base/units.h>

namespace stiction
{
  const char *Units::choices() { return "none|SI|mm, N, MPa"; }

  Units Units::named(const std::string &name)
  {
    if (name == "SI")
      return {"m", "m^2", "N", "N m", "Pa", "J", "kg/m^3"};
    if (name == "mm, N, MPa")
      return {"mm", "mm^2", "N", "N mm", "MPa", "mJ", "t/mm^3"};
    return {};
  }

  std::string label(const std::string &quantity, const std::string &unit)
  {
    return unit.empty() ? quantity : quantity + " [" + unit + "]";
  }

  std::string with_unit(const std::string &number, const std::string &unit)
  {
    return unit.empty() ? number : number + " " + unit;
  }
} // namespace stiction
