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
    double softness;   ///< E of the other one over that of this one
    double coarseness; ///< size of its cells over that of the other's, both unrefined
    std::string reason;

    SlaveSide other(const std::string &its_reason) const
    {
      return {!is_first, 1. / softness, 1. / coarseness, its_reason};
    }

    bool is_much_softer() const { return softness >= much; }

    /// Much stiffer, and of no larger cells: such nodes move as a whole with what is
    /// opposite, whatever forces go from one to the next, so that pressures waver, and
    /// Newton steps are many.
    bool wavers() const { return softness <= 1. / much && coarseness < larger; }

    static constexpr double much = 30., larger = 1.25;
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

  /// Unknowns of the bodies up to which the method newton goes on where newton multigrid
  /// comes no closer: its one factorisation takes half a minute then, and three
  /// gigabytes.
  constexpr dealii::types::global_dof_index max_for_newton = 200000;

  /// As choose_slave_side() but for a surface that ends within the other one: forces act
  /// at nodes of the slave side, so that contact ends where it should if that is the side
  /// with the edge. That is nearer to the answer even where pressures waver, but not done
  /// then, ties excepted, if the bodies are too large for the method newton before
  /// adaptive refinement. Forces act along its normals, so that it is not a side that
  /// stands on an edge on the other, unless it is much softer. Collective.
  SlaveSide automatic_slave_side(const LinearElasticity &elasticity,
                                 const std::vector<SurfaceFace> &first,
                                 const std::vector<SurfaceFace> &second, bool is_tied);
} // namespace stiction
