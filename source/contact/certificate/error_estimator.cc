#include "cell_error.h"
#include "trilinear_cell.h"

#include <stiction/base/errors.h>
#include <stiction/contact/certificate/error_estimator.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using AnyCell    = DoFHandler<3>::cell_iterator;
    using ActiveCell = DoFHandler<3>::active_cell_iterator;

    // The same on all ranks. Two cells with one number do no harm.
    std::uint64_t number_of(const AnyCell &cell)
    {
      std::uint64_t number = 0;
      for (const unsigned int part : cell->id().to_binary<3>())
        number = 0x100000001b3u * number + part;
      return number;
    }

    // One of the active cells in a cell, and how many it stands for: 1/p if it
    // is taken with probability p, so that the sum is right on average whatever
    // p is. Cells at the boundary, where more of the error is, are taken more
    // often. Chance depends on the number of the cell and that of the draw.
    std::pair<AnyCell, double> drawn_from(AnyCell cell, const unsigned int draw)
    {
      if (cell->is_active())
        return {cell, 1.};
      std::minstd_rand chance((number_of(cell) * 0x9e3779b97f4a7c15u >> 33) + draw);
      chance.discard(2); // the first ones show that seeds are alike
      std::array<bool, 6> at_boundary;
      for (unsigned int f = 0; f < 6; ++f)
        at_boundary[f] = cell->at_boundary(f);
      double weight = 1.;
      while (!cell->is_active())
        {
          // child c is at the faces 0 or 1, 2 or 3, 4 or 5 by the bits of c
          std::array<unsigned int, 8> up_to; // sums of odds
          unsigned int sum = 0;
          for (unsigned int c = 0; c < 8; ++c)
            {
              sum += 1;
              for (unsigned int d = 0; d < 3; ++d)
                sum += at_boundary[2 * d + (c >> d & 1)] ? 2 : 0;
              up_to[c] = sum;
            }
          const unsigned int c =
            std::upper_bound(up_to.begin(), up_to.end(), chance() % sum) - up_to.begin();
          weight *= 1. * sum / (c == 0 ? up_to[0] : up_to[c] - up_to[c - 1]);
          for (unsigned int d = 0; d < 3; ++d) // the others are inside now
            at_boundary[2 * d + 1 - (c >> d & 1)] = false;
          cell = cell->child(c);
        }
      return {cell, weight};
    }

    void for_each_owned(const AnyCell &cell,
                        const std::function<void(const ActiveCell &)> &callback)
    {
      if (!cell->is_active())
        for (const auto &child : cell->child_iterators())
          for_each_owned(child, callback);
      else if (cell->is_locally_owned())
        callback(cell);
    }

    // How much the strain changes within a cell, as energy: what is known of
    // the error without looking at other cells.
    double roughness(const ActiveCell &cell, const LA::Vector &u,
                     const Material &material)
    {
      const TrilinearCell trilinear(cell, u);
      double sum = 0.;
      for (const unsigned int f : {0, 2, 4})
        {
          const auto here = trilinear.at(f, 0), there = trilinear.at(f + 1, 3);
          const auto change = here.strain - there.strain;
          sum += change * change * here.height * here.JxW;
        }
      return material.youngs_modulus * sum;
    }

    // Calls back with the cells of a level, and active ones that are coarser.
    void for_each_family(const Body &body, const unsigned int level,
                         const std::function<void(const AnyCell &)> &callback)
    {
      const auto &cells = body.dof_handler();
      for (unsigned int l = 0; l <= level && l < body.triangulation().n_levels(); ++l)
        for (const auto &cell : cells.cell_iterators_on_level(l))
          if (l == level || cell->is_active())
            callback(cell);
    }

    // The numbers of the families that seem to have the largest errors, one
    // cell of each being looked at.
    std::set<std::uint64_t> roughest_families(const LinearElasticity &elasticity,
                                              const State &state,
                                              const unsigned int level)
    {
      const LA::Vector u = elasticity.body().with_ghosts(state.u);
      // float: rounding of u is not to decide between cells that are alike
      using Family = std::pair<float, std::uint64_t>;
      std::vector<Family> own, all;
      for_each_family(elasticity.body(), level, [&](const AnyCell &family) {
        const auto drawn = drawn_from(family, 1);
        if (drawn.first->is_locally_owned())
          own.emplace_back(drawn.second * roughness(drawn.first, u,
                                                    elasticity.materials().of(
                                                      drawn.first->material_id())),
                           number_of(family));
      });
      for (const auto &part :
           Utilities::MPI::all_gather(elasticity.body().communicator(), own))
        all.insert(all.end(), part.begin(), part.end());
      std::sort(all.rbegin(), all.rend());

      constexpr std::size_t cells_of_family = 64; // or eight, then it is less
      std::set<std::uint64_t> numbers;
      for (std::size_t i = 0; i < all.size() / cells_of_family; ++i)
        numbers.insert(all[i].second);
      return numbers;
    }
  } // namespace

  Vector<double> estimate_error(const LinearElasticity &elasticity,
                                const ContactSurface &surface, const State &state)
  {
    const Body &body = elasticity.body();
    Vector<double> squares(body.triangulation().n_active_cells());
    const auto error = cell_error(elasticity, surface, state);
    throw_on_all_ranks(body.communicator(), [&]() {
      for (const auto &cell : body.locally_owned_cells())
        squares[cell->active_cell_index()] = error(cell);
    });
    return squares;
  }

  MeshError estimate_mesh_error(const LinearElasticity &elasticity,
                                const ContactSurface &surface, const State &state,
                                const unsigned long long all_up_to)
  {
    const Body &body          = elasticity.body();
    const auto &triangulation = body.triangulation();
    const auto n_cells        = triangulation.n_global_active_cells();
    const unsigned int finest = triangulation.n_global_levels() - 1;
    const unsigned int up = n_cells <= all_up_to ? 0 : n_cells <= 4 * all_up_to ? 1 : 2;
    const unsigned int level = finest - std::min(up, finest);

    const auto error = cell_error(elasticity, surface, state);
    const auto whole = level < finest ? roughest_families(elasticity, state, level)
                                      : std::set<std::uint64_t>();
    MeshError sum;
    throw_on_all_ranks(body.communicator(), [&]() {
      for_each_family(body, level, [&](const AnyCell &family) {
        const auto add = [&](const AnyCell &cell, const double weight) {
          sum.square += weight * error(cell);
          ++sum.n_cells;
        };
        if (level == finest || whole.count(number_of(family)) > 0)
          return for_each_owned(family, [&](const ActiveCell &cell) { add(cell, 1.); });
        const auto drawn = drawn_from(family, 2);
        if (drawn.first->is_locally_owned())
          add(drawn.first, drawn.second);
      });
    });
    sum.square     = Utilities::MPI::sum(sum.square, body.communicator());
    sum.n_cells    = Utilities::MPI::sum(sum.n_cells, body.communicator());
    sum.is_sampled = sum.n_cells < n_cells;
    return sum;
  }
} // namespace stiction
