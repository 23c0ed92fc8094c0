#include <stiction/contact/pairs/mortar.h>
#include <stiction/contact/pairs/slave_side.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of E/h, and of h: less is the same.
    constexpr double softer = 2., finer = 1.001;

    // Of the area of a surface: more than the first is all of it, less than the second is
    // a smaller one. Facets of round surfaces do not cover each other to the last digit.
    constexpr double all_of_it = 0.999, all_of_facets = 0.98, smaller = 0.99;

    // Of a cosine: normals within it are those of a flat surface, whose area stays what
    // it is when the mesh is refined.
    constexpr double flat = 0.99;

    // Of a sine: surfaces that are more inclined to each other touch at an edge.
    constexpr double tilted = 0.05;

    bool is_flat(const std::vector<SurfaceFace> &faces)
    {
      return std::all_of(faces.begin(), faces.end(), [&](const SurfaceFace &face) {
        return face.normal() * faces.front().normal() > flat;
      });
    }

    double area(const std::vector<SurfaceFace> &faces)
    {
      double sum = 0.;
      for (const SurfaceFace &face : faces)
        sum += face.area();
      return sum;
    }

    // Whether both are flat, inclined to each other, and the slave ends before the master
    // does where the gap closes: the face of a punch that is tilted.
    bool stands_on_edge(const std::vector<SurfaceFace> &slave,
                        const std::vector<SurfaceFace> &master)
    {
      if (!is_flat(slave) || !is_flat(master))
        return false;
      const Tensor<1, 3> n = slave.front().normal(), opposite = master.front().normal();
      // along it the gap closes
      Tensor<1, 3> t = (opposite * n) * n - opposite;
      if (opposite * n > 0. || t.norm() < tilted)
        return false;
      t /= t.norm();
      const auto end_of = [&](const std::vector<SurfaceFace> &faces) {
        double end = std::numeric_limits<double>::lowest();
        for (const SurfaceFace &face : faces)
          for (unsigned int i = 0; i < face.n_nodes(); ++i)
            end = std::max(end, t * face.node(i));
        return end;
      };
      return end_of(slave) < end_of(master) - (1. - smaller) * slave.front().surface_size;
    }

    // Of the size of cells before they were refined, so that a side stays the slave when
    // a mesh is refined in the middle of a history.
    struct Means
    {
      explicit Means(const std::vector<SurfaceFace> &faces)
      {
        double area = 0.;
        for (const SurfaceFace &face : faces)
          {
            const double weight = face.diameter() * face.diameter();
            const double h      = face.coarse_diameter;
            area += weight;
            size += weight * h;
            stiffness += weight * face.youngs_modulus / h;
            modulus += weight * face.youngs_modulus;
          }
        size /= area;
        stiffness /= area;
        modulus /= area;
      }

      double size = 0., stiffness = 0., modulus = 0.;
    };
  } // namespace

  bool SlaveOrder::closes_circle(const Bodies &slaves, const Bodies &masters) const
  {
    Bodies reached = masters;
    std::vector<unsigned int> next(masters.begin(), masters.end());
    while (!next.empty())
      {
        const auto of = masters_of_.find(next.back());
        next.pop_back();
        if (of != masters_of_.end())
          for (const unsigned int body : of->second)
            if (reached.insert(body).second)
              next.push_back(body);
      }
    return std::any_of(slaves.begin(), slaves.end(),
                       [&](const unsigned int body) { return reached.count(body) > 0; });
  }

  void SlaveOrder::add(const Bodies &slaves, const Bodies &masters)
  {
    for (const unsigned int slave : slaves)
      masters_of_[slave].insert(masters.begin(), masters.end());
  }

  SlaveSide choose_slave_side(const std::vector<SurfaceFace> &first,
                              const std::vector<SurfaceFace> &second)
  {
    const Means a(first), b(second);
    SlaveSide side{true, b.modulus / a.modulus, a.size / b.size, "the first side"};
    if (softer * a.stiffness > b.stiffness && softer * b.stiffness > a.stiffness)
      {
        if (finer * b.size < a.size)
          return side.other("the finer side");
        if (finer * a.size < b.size)
          side.reason = "the finer side";
        return side;
      }
    if (a.stiffness > b.stiffness)
      side = side.other("");
    side.reason = side.softness >= softer ? "the softer side" : "the one of larger cells";
    return side;
  }

  bool ends_within(const LinearElasticity &elasticity,
                   const std::vector<SurfaceFace> &inner,
                   const std::vector<SurfaceFace> &outer)
  {
    if (area(inner) >= smaller * area(outer))
      return false;
    const auto covered = [&](const Mortar &mortar, const std::vector<SurfaceFace> &of) {
      return mortar.areas.sum() / area(of);
    };
    const Mortar mortar(elasticity, inner, outer);
    if (is_flat(inner) && is_flat(outer))
      return covered(mortar, inner) > all_of_it;
    // coarse facets have less area than fine ones of the same surface
    return covered(mortar, inner) > all_of_facets &&
           mortar.largest_gap() < mean_diameter(inner) &&
           covered(Mortar(elasticity, outer, inner), outer) < smaller;
  }

  SlaveSide automatic_slave_side(const LinearElasticity &elasticity,
                                 const std::vector<SurfaceFace> &first,
                                 const std::vector<SurfaceFace> &second,
                                 const bool is_tied)
  {
    SlaveSide side        = choose_slave_side(first, second);
    const SlaveSide inner = side.other("the side that ends within the other");
    const bool may_bear =
      is_tied || !inner.wavers() || elasticity.body().n_first_dofs() <= max_for_newton;
    if (may_bear && (side.is_first ? ends_within(elasticity, second, first)
                                   : ends_within(elasticity, first, second)))
      side = inner;
    if (!side.is_much_softer() &&
        (side.is_first ? stands_on_edge(first, second) : stands_on_edge(second, first)))
      side = side.other("the side that does not stand on an edge");
    return side;
  }
} // namespace stiction
