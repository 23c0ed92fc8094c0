#ifndef stiction_contact_pairs_slave_side_h
#define stiction_contact_pairs_slave_side_h

#include <stiction/contact/pairs/surface_face.h>

#include <string>
#include <vector>

namespace stiction
{
  /// Which of two surfaces carries the contact forces, and why: "the softer side".
  struct SlaveSide
  {
    bool is_first;
    bool is_softer; ///< by a factor of two or more
    std::string reason;
  };

  /// The softer one if E/h of its cells, h being their size along the surface, is less
  /// by a factor of two or more, otherwise the finer one; of equals the first. On the
  /// stiff side of a large contrast the iterations would be many times more.
  SlaveSide choose_slave_side(const std::vector<SurfaceFace> &first,
                              const std::vector<SurfaceFace> &second);
} // namespace stiction

#endif
