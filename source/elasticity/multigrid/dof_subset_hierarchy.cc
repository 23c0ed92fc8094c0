#include <stiction/elasticity/multigrid/dof_subset_hierarchy.h>
#include <stiction/elasticity/multigrid/mesh_hierarchy.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <type_traits>

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

    // The entries of all ranks, sorted. As bytes: deal.II's all_gather()
    // compresses what it sends, which takes longer than all the rest here.
    template<typename T>
    std::vector<T> gather_sorted(const std::vector<T> &mine, MPI_Comm communicator)
    {
      static_assert(std::is_trivially_copyable<T>::value, "sent as bytes");
      const auto n_bytes         = static_cast<int>(mine.size() * sizeof(T));
      const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      std::vector<int> sizes(n_ranks), begins(n_ranks, 0);
      MPI_Allgather(&n_bytes, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
      for (unsigned int r = 1; r < n_ranks; ++r)
        begins[r] = begins[r - 1] + sizes[r - 1];
      std::vector<T> all((begins.back() + sizes.back()) / sizeof(T));
      MPI_Allgatherv(mine.data(), n_bytes, MPI_BYTE, all.data(), sizes.data(),
                     begins.data(), MPI_BYTE, communicator);
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
