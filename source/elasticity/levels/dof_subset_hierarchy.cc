#include <stiction/base/all_gather.h>
#include <stiction/elasticity/levels/dof_subset_hierarchy.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Dofs = std::vector<types::global_dof_index>;

    // A vector that holds 1 + its place in the list at every node of the list,
    // ghosts included.
    LA::VectorOf<double> places(const MeshLevel &level, const Dofs &first_dofs)
    {
      auto v = level.zero_vector<double>();
      for (std::size_t i = 0; i < first_dofs.size(); ++i)
        if (v.in_local_range(first_dofs[i]))
          v(first_dofs[i]) = static_cast<double>(i + 1);
      v.update_ghost_values();
      return v;
    }

    template<typename T>
    std::vector<T> gather_sorted(const std::vector<T> &mine, MPI_Comm communicator)
    {
      std::vector<T> all = all_gather(mine, communicator);
      std::sort(all.begin(), all.end());
      return all;
    }
  } // namespace

  DofSubsetHierarchy::DofSubsetHierarchy(const MeshHierarchy &hierarchy,
                                         const Dofs &first_dofs)
    : first_dofs_(hierarchy.n_levels())
    , on_finer_level_(hierarchy.n_levels())
    , prolongation_(hierarchy.n_levels() - 1)
  {
    first_dofs_.back() = first_dofs;
    for (unsigned int l = hierarchy.n_levels() - 1; l > 0; --l)
      {
        const MeshLevel &fine   = hierarchy.level(l);
        const MeshLevel &coarse = hierarchy.level(l - 1);
        const MPI_Comm comm     = fine.communicator();

        const auto on_fine = places(fine, first_dofs_[l]);

        // which fine nodes are coarse vertices, sorted by their place
        using Vertex = std::array<types::global_dof_index, 2>;
        std::vector<Vertex> vertices;
        hierarchy.transfer(l).for_each_row(
          [&](const unsigned int i, const unsigned int *nodes, const unsigned int n) {
            const double place = on_fine.local_element(3 * i);
            if (n == 1 && place > 0.)
              vertices.push_back({{static_cast<types::global_dof_index>(place) - 1,
                                   coarse.first_dof(nodes[0])}});
          });
        for (const Vertex &vertex : gather_sorted(vertices, comm))
          {
            on_finer_level_[l - 1].push_back(vertex[0]);
            first_dofs_[l - 1].push_back(vertex[1]);
          }

        const auto on_coarse = places(coarse, first_dofs_[l - 1]);
        using Entry          = std::array<unsigned int, 3>;
        std::vector<Entry> entries; // row, column, 1/weight
        hierarchy.transfer(l).for_each_row(
          [&](const unsigned int i, const unsigned int *nodes, const unsigned int n) {
            const double place = on_fine.local_element(3 * i);
            for (unsigned int k = 0; place > 0. && k < n; ++k)
              {
                const double coarse_place = on_coarse.local_element(3 * nodes[k]);
                if (coarse_place > 0.)
                  entries.push_back({{static_cast<unsigned int>(place) - 1,
                                      static_cast<unsigned int>(coarse_place) - 1, n}});
              }
          });
        std::vector<Eigen::Triplet<double>> triplets;
        for (const Entry &entry : gather_sorted(entries, comm))
          triplets.emplace_back(entry[0], entry[1], 1. / entry[2]);
        prolongation_[l - 1].resize(static_cast<Eigen::Index>(first_dofs_[l].size()),
                                    static_cast<Eigen::Index>(first_dofs_[l - 1].size()));
        prolongation_[l - 1].setFromTriplets(triplets.begin(), triplets.end());
      }
  }
} // namespace stiction
