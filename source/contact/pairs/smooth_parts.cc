#include <stiction/contact/pairs/smooth_parts.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace stiction
{
  namespace
  {
    // 50 degrees: between the 45 of a circle of eight facets and the 60 of a hexagon.
    constexpr double sharp_cosine = 0.6427876096865394;
  } // namespace

  std::vector<unsigned int> smooth_parts(const std::vector<SurfaceFace> &faces)
  {
    std::vector<unsigned int> joined(faces.size()); // to one of the part before it
    std::iota(joined.begin(), joined.end(), 0u);
    const auto first_of = [&](unsigned int f) {
      while (joined[f] != f)
        f = joined[f] = joined[joined[f]];
      return f;
    };
    std::map<dealii::types::global_dof_index, std::vector<unsigned int>> at_node;
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (unsigned int i = 0; i < faces[f].n_nodes(); ++i)
        {
          std::vector<unsigned int> &others = at_node[faces[f].dofs[i]];
          for (const unsigned int g : others)
            if ((faces[f].is_round && faces[g].is_round) ||
                faces[f].normal() * faces[g].normal() > sharp_cosine)
              {
                const unsigned int a = first_of(f), b = first_of(g);
                joined[std::max(a, b)] = std::min(a, b);
              }
          others.push_back(f);
        }
    std::map<unsigned int, unsigned int> number;
    std::vector<unsigned int> parts;
    for (unsigned int f = 0; f < faces.size(); ++f)
      parts.push_back(
        number.emplace(first_of(f), static_cast<unsigned int>(number.size()))
          .first->second);
    return parts;
  }

  std::set<dealii::types::global_dof_index> rim_of(const std::vector<SurfaceFace> &faces)
  {
    using Dof = dealii::types::global_dof_index;
    std::map<std::pair<Dof, Dof>, unsigned int> n_beside; // edges
    for (const SurfaceFace &face : faces)
      {
        const unsigned int n = face.degree + 1;
        const Dof corners[]  = {face.dofs[0], face.dofs[n - 1], face.dofs[n * n - 1],
                                face.dofs[n * (n - 1)]};
        for (unsigned int e = 0; e < 4; ++e)
          ++n_beside[std::minmax({corners[e], corners[(e + 1) % 4]})];
      }
    std::set<Dof> rim;
    for (const auto &[corners, n] : n_beside)
      if (n == 1)
        rim.insert({corners.first, corners.second});
    return rim;
  }
} // namespace stiction
