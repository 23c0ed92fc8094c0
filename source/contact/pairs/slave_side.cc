#include <stiction/contact/pairs/slave_side.h>

#include <algorithm>

namespace stiction
{
  namespace
  {
    // Of E/h, and of h: less is the same.
    constexpr double softer = 2., finer = 1.001;

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
    SlaveSide side{true, b.modulus / a.modulus, "the first side"};
    if (softer * a.stiffness <= b.stiffness)
      return {true, side.softness, "the softer side"};
    if (softer * b.stiffness <= a.stiffness)
      return side.other("the softer side");
    if (finer * a.size < b.size)
      return {true, side.softness, "the finer side"};
    if (finer * b.size < a.size)
      return side.other("the finer side");
    return side;
  }
} // namespace stiction
