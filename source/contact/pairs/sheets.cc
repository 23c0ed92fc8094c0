#include "sheets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of what is covered of a face, or around a node: less may be rounding, which hides
    // nothing.
    constexpr double sliver = 1e-3;

    // Faces that hang together, how far away they are, and how much of a face they cover.
    struct Sheet
    {
      std::vector<const SurfaceFace *> faces;
      double nearest = 1e300, farthest = 0., area = 0.;
    };

    using Numbers = std::map<const SurfaceFace *, std::size_t>;

    // Which masters are of the same sheet: those with a common node.
    Numbers sheet_numbers(const std::vector<CoveredPoint> &points)
    {
      std::map<types::global_dof_index, std::vector<const SurfaceFace *>> at_node;
      std::set<const SurfaceFace *> masters;
      for (const CoveredPoint &point : points)
        if (masters.insert(point.master).second)
          for (unsigned int i = 0; i < point.master->n_nodes(); ++i)
            at_node[point.master->dofs[i]].push_back(point.master);
      Numbers numbers;
      std::size_t n = 0;
      for (const CoveredPoint &point : points)
        if (numbers.count(point.master) == 0)
          {
            std::vector<const SurfaceFace *> faces = {point.master};
            numbers[point.master]                  = n;
            for (std::size_t k = 0; k < faces.size(); ++k)
              for (unsigned int i = 0; i < faces[k]->n_nodes(); ++i)
                for (const SurfaceFace *const next : at_node[faces[k]->dofs[i]])
                  if (numbers.emplace(next, n).second)
                    faces.push_back(next);
            ++n;
          }
      return numbers;
    }

    // The nearest first.
    std::vector<Sheet> sheets_of(const std::vector<CoveredPoint> &points)
    {
      const Numbers numbers = sheet_numbers(points);
      std::vector<Sheet> sheets(numbers.size());
      for (const auto &[master, n] : numbers)
        sheets[n].faces.push_back(master);
      for (const CoveredPoint &point : points)
        {
          Sheet &sheet   = sheets[numbers.at(point.master)];
          sheet.nearest  = std::min(sheet.nearest, std::abs(point.at.gap));
          sheet.farthest = std::max(sheet.farthest, std::abs(point.at.gap));
          sheet.area += point.at.weight;
        }
      sheets.erase(std::remove_if(sheets.begin(), sheets.end(),
                                  [](const Sheet &sheet) { return sheet.faces.empty(); }),
                   sheets.end());
      std::stable_sort(sheets.begin(), sheets.end(), [](const auto &a, const auto &b) {
        return a.nearest < b.nearest;
      });
      return sheets;
    }
  } // namespace

  void keep_nearest_sheets(const FaceOverlap &overlap, const double diameter,
                           std::vector<CoveredPoint> &points)
  {
    const std::vector<Sheet> sheets = sheets_of(points);
    if (sheets.size() < 2)
      return;
    double area = 0.;
    for (const Sheet &sheet : sheets)
      area += sheet.area;
    std::vector<const SurfaceFace *> in_front;
    double farthest = 1e300;
    for (const Sheet &sheet : sheets)
      {
        const std::set<const SurfaceFace *> faces(sheet.faces.begin(), sheet.faces.end());
        const bool is_left_out =
          sheet.area < sliver * area || sheet.nearest > farthest + diameter;
        points.erase(
          std::remove_if(points.begin(), points.end(),
                         [&](const CoveredPoint &point) {
                           return faces.count(point.master) > 0 &&
                                  (is_left_out ||
                                   std::any_of(in_front.begin(), in_front.end(),
                                               [&](const SurfaceFace *const face) {
                                                 return overlap.covers(*face, point.at);
                                               }));
                         }),
          points.end());
        if (is_left_out)
          continue;
        farthest = in_front.empty() ? sheet.farthest : std::max(farthest, sheet.farthest);
        in_front.insert(in_front.end(), sheet.faces.begin(), sheet.faces.end());
      }
  }

  void keep_nearest_sheets(std::vector<FaceShare> &shares)
  {
    std::map<types::global_dof_index, double> largest; // share of D
    for (const FaceShare &share : shares)
      if (share.is_own())
        {
          double &value = largest[share.slave];
          value         = std::max(value, std::abs(share.value));
        }
    std::map<types::global_dof_index, const FaceShare *> nearest;
    for (const FaceShare &share : shares)
      if (share.is_own() && std::abs(share.value) >= sliver * largest[share.slave])
        {
          const auto at = nearest.emplace(share.slave, &share).first;
          if (share.nearest() < at->second->nearest())
            at->second = &share;
        }
    std::map<types::global_dof_index, double> limits;
    for (const auto &[slave, share] : nearest)
      limits[slave] = share->farthest() + share->diameter;
    shares.erase(std::remove_if(shares.begin(), shares.end(),
                                [&](const FaceShare &share) {
                                  return share.nearest() > limits[share.slave];
                                }),
                 shares.end());
  }
} // namespace stiction
