#ifndef stiction_contact_pairs_slave_side_h
#define stiction_contact_pairs_slave_side_h

#include <stiction/contact/pairs/surface_face.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace stiction
{
  /// Which of two surfaces carries the contact forces, and why: "the softer side".
  struct SlaveSide
  {
    bool is_first;
    bool is_much_softer; ///< so that on the other one iterations are many more
    std::string reason;
  };

  /// Which bodies are slaves of which. Where pairs meet at a node, slaves must not follow
  /// themselves in a circle.
  class SlaveOrder
  {
  public:
    using Bodies = std::set<unsigned int>;

    /// Whether one of the masters is a slave, over any number of pairs, of the slaves.
    bool closes_circle(const Bodies &slaves, const Bodies &masters) const;

    void add(const Bodies &slaves, const Bodies &masters);

  private:
    std::map<unsigned int, Bodies> masters_of_;
  };

  /// The softer one if E/h of its cells, h being their size along the surface before
  /// refinement, is less by a factor of two or more, otherwise the finer one; of equals
  /// the first.
  SlaveSide choose_slave_side(const std::vector<SurfaceFace> &first,
                              const std::vector<SurfaceFace> &second);
} // namespace stiction

#endif
