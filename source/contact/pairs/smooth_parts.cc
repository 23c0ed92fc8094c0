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

    using Dof = dealii::types::global_dof_index;

    std::array<Dof, 4> in_order(std::array<Dof, 4> corners)
    {
      std::sort(corners.begin(), corners.end());
      return corners;
    }
  } // namespace

  std::vector<std::vector<SurfaceFace>> SmoothParts::split(
    const std::vector<SurfaceFace> &faces)
  {
    std::vector<unsigned int> joined(faces.size()); // to one of the part before it
    std::iota(joined.begin(), joined.end(), 0u);
    const auto first_of = [&](unsigned int f) {
      while (joined[f] != f)
        f = joined[f] = joined[joined[f]];
      return f;
    };
    std::map<Dof, std::vector<unsigned int>> at_node;
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
    std::vector<std::vector<SurfaceFace>> parts;
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        const unsigned int part =
          number.emplace(first_of(f), static_cast<unsigned int>(number.size()))
            .first->second;
        parts.resize(number.size());
        parts[part].push_back(faces[f]);
        if (part > 0)
          part_[in_order(faces[f].corner_dofs())] = part;
      }
    parts.resize(std::max<std::size_t>(1, parts.size()));
    return parts;
  }

  unsigned int SmoothParts::of(const dealii::DoFHandler<3>::face_iterator &face) const
  {
    std::array<Dof, 4> corners;
    for (unsigned int v = 0; v < corners.size(); ++v)
      corners[v] = face->vertex_dof_index(v, 0);
    const auto part = part_.find(in_order(corners));
    return part == part_.end() ? 0 : part->second;
  }

  std::set<Dof> rim_of(const std::vector<SurfaceFace> &faces)
  {
    std::map<std::pair<Dof, Dof>, unsigned int> n_beside; // edges
    for (const SurfaceFace &face : faces)
      {
        const auto corners = face.corner_dofs();
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
