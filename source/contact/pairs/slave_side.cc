#include <stiction/contact/pairs/slave_side.h>

namespace stiction
{
  namespace
  {
    // Of E/h, and of h: less is the same.
    constexpr double much_softer = 2., finer = 1.001;

    struct Means
    {
      explicit Means(const std::vector<SurfaceFace> &faces)
      {
        for (const SurfaceFace &face : faces)
          {
            size += face.diameter() / faces.size();
            stiffness += face.youngs_modulus / face.diameter() / faces.size();
          }
      }

      double size = 0., stiffness = 0.;
    };
  } // namespace

  SlaveSide choose_slave_side(const std::vector<SurfaceFace> &first,
                              const std::vector<SurfaceFace> &second)
  {
    const Means a(first), b(second);
    if (much_softer * a.stiffness <= b.stiffness)
      return {true, true, "the softer side"};
    if (much_softer * b.stiffness <= a.stiffness)
      return {false, true, "the softer side"};
    if (finer * a.size < b.size)
      return {true, false, "the finer side"};
    if (finer * b.size < a.size)
      return {false, false, "the finer side"};
    return {true, false, "the first side"};
  }
} // namespace stiction
