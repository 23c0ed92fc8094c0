#pragma once

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
    double softness; ///< E of the other one over that of this one
    std::string reason;

    SlaveSide other(const std::string &its_reason) const
    {
      return {!is_first, 1. / softness, its_reason};
    }

    bool is_much_softer() const { return softness >= much; }

    /// So that newton multigrid takes many iterations, or factorises its systems.
    bool is_much_stiffer() const { return softness <= 1. / much; }

    static constexpr double much = 30.;
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

  /// Whether a surface ends within another one, which goes on beyond its edges: flat
  /// ones, and round ones that fit, as a hub on its shaft. Collective.
  bool ends_within(const LinearElasticity &elasticity,
                   const std::vector<SurfaceFace> &inner,
                   const std::vector<SurfaceFace> &outer);

  /// As choose_slave_side() but for a surface that ends within the other one: forces act
  /// at nodes of the slave side, so that contact ends where it should if that is the side
  /// with the edge. They act along its normals, though, so that it is not one that stands
  /// on an edge on the other, unless it is much softer. Collective.
  SlaveSide automatic_slave_side(const LinearElasticity &elasticity,
                                 const std::vector<SurfaceFace> &first,
                                 const std::vector<SurfaceFace> &second);
} // namespace stiction
