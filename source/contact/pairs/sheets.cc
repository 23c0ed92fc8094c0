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
    // Of what is covered of a face, or by one face around a node: what covers less does
    // not decide what else counts.
    constexpr double least_part = 0.1;

    // Of a sheet: what hides as much of it is in front of it.
    constexpr double hidden_part = 0.25;

    // Of a face: parts that sheets cover side by side add up to no more.
    constexpr double once = 1.05;

    // Faces that hang together: how far away they are, and what they cover of a face.
    struct Sheet
    {
      double nearest = 1e300, farthest = 0., part = 0.;
      unsigned int piece = 0;
      bool is_kept       = false;

      void add(const CoveredPoint &point)
      {
        nearest  = std::min(nearest, std::abs(point.at.gap));
        farthest = std::max(farthest, std::abs(point.at.gap));
        part += point.at.part;
        piece = point.master->piece;
      }
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
        if (numbers.emplace(point.master, n).second)
          {
            std::vector<const SurfaceFace *> faces = {point.master};
            for (std::size_t k = 0; k < faces.size(); ++k)
              for (unsigned int i = 0; i < faces[k]->n_nodes(); ++i)
                for (const SurfaceFace *const next : at_node[faces[k]->dofs[i]])
                  if (numbers.emplace(next, n).second)
                    faces.push_back(next);
            ++n;
          }
      return numbers;
    }
  } // namespace

  void keep_nearest_sheets(const double diameter, std::vector<CoveredPoint> &points)
  {
    Sheet all;
    for (const CoveredPoint &point : points)
      all.add(point);
    if (all.farthest <= all.nearest + diameter && all.part <= once)
      return;
    const Numbers numbers = sheet_numbers(points);
    std::vector<Sheet> sheets(numbers.size());
    for (const CoveredPoint &point : points)
      sheets[numbers.at(point.master)].add(point);
    std::vector<Sheet *> in_order;
    for (Sheet &sheet : sheets)
      in_order.push_back(&sheet);
    std::stable_sort(
      in_order.begin(), in_order.end(),
      [](const auto *const a, const auto *const b) { return a->nearest < b->nearest; });

    double limit = 1e300;
    std::map<unsigned int, double> covered; // by each body
    for (Sheet *const sheet : in_order)
      {
        double &part        = covered[sheet->piece];
        const double hidden = part + sheet->part - 1.;
        sheet->is_kept = sheet->nearest <= limit && !(hidden > hidden_part * sheet->part);
        if (!sheet->is_kept)
          continue;
        part += sheet->part;
        if (limit == 1e300 && sheet->part >= least_part * all.part)
          limit = sheet->farthest + diameter;
      }
    points.erase(std::remove_if(points.begin(), points.end(),
                                [&](const CoveredPoint &point) {
                                  return !sheets[numbers.at(point.master)].is_kept;
                                }),
                 points.end());
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
    const auto counts = [&](const FaceShare &share) {
      return share.is_own() && std::abs(share.value) >= least_part * largest[share.slave];
    };
    struct Nearest
    {
      double distance = 1e300, limit = 0.;
    };
    std::map<types::global_dof_index, Nearest> nearest;
    for (const FaceShare &share : shares)
      if (counts(share))
        {
          double &distance = nearest[share.slave].distance;
          distance         = std::min(distance, share.nearest());
        }
    for (const FaceShare &share : shares)
      if (counts(share) && share.nearest() <= nearest[share.slave].distance)
        {
          double &limit = nearest[share.slave].limit;
          limit         = std::max(limit, share.farthest() + share.diameter);
        }
    shares.erase(std::remove_if(shares.begin(), shares.end(),
                                [&](const FaceShare &share) {
                                  return share.nearest() > nearest[share.slave].limit;
                                }),
                 shares.end());
  }
} // namespace stiction
