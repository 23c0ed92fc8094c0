#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/free_motions.h>
#include <stiction/elasticity/stiffness/anchors.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Core>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of motions of size one: less is rounding. A beam that turns about its axis moves
    // by a part of its length only.
    constexpr double least_motion = 1e-8;

    // The free motions along the axes of owned unknowns at vertices that are not
    // constrained, of all cells or of those of the coarse mesh alone.
    std::map<types::global_dof_index, Eigen::RowVectorXd> candidates(
      const Body &body, const AffineConstraints<double> &constraints,
      const FreeMotions &free_motions,
      const std::vector<types::global_dof_index> &excluded, const bool only_coarse)
    {
      std::set<unsigned int> coarse_vertices;
      for (const auto &cell : body.triangulation().cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          coarse_vertices.insert(cell->vertex_index(v));
      const std::set<types::global_dof_index> left_out(excluded.begin(), excluded.end());

      std::map<types::global_dof_index, Eigen::RowVectorXd> rows;
      for (const auto &cell : body.locally_owned_cells())
        for (const unsigned int v : cell->vertex_indices())
          {
            const auto first_dof = cell->vertex_dof_index(v, 0);
            if (!body.locally_owned_dofs().is_element(first_dof) ||
                left_out.count(first_dof) > 0 || rows.count(first_dof) > 0 ||
                (only_coarse && coarse_vertices.count(cell->vertex_index(v)) == 0))
              continue;
            const Eigen::MatrixXd motions =
              free_motions.at(cell->vertex(v), body.piece_of(cell));
            for (unsigned int c = 0; c < 3; ++c)
              if (!constraints.is_constrained(cell->vertex_dof_index(v, c)))
                rows[cell->vertex_dof_index(v, c)] = motions.row(c);
          }
      return rows;
    }

    // Of all numbers but the last one.
    double norm(const std::vector<double> &row)
    {
      return Eigen::Map<const Eigen::VectorXd>(row.data(),
                                               static_cast<Eigen::Index>(row.size()) - 1)
        .norm();
    }

    std::vector<types::global_dof_index> choose(
      std::map<types::global_dof_index, Eigen::RowVectorXd> rows, const Eigen::Index n,
      MPI_Comm communicator)
    {
      std::vector<types::global_dof_index> anchors;
      for (Eigen::Index k = 0; k < n; ++k)
        {
          // of all ranks the largest, by their entries and the number of the unknown
          std::vector<double> largest(n + 1, 0.);
          for (const auto &[dof, motions] : rows)
            if (motions.norm() > norm(largest))
              {
                std::copy(motions.begin(), motions.end(), largest.begin());
                largest.back() = static_cast<double>(dof);
              }
          for (const auto &other : Utilities::MPI::all_gather(communicator, largest))
            if (norm(other) > norm(largest) ||
                (norm(other) == norm(largest) && other.back() < largest.back()))
              largest = other;
          const double size = norm(largest);
          if (size < least_motion)
            return {};
          anchors.push_back(static_cast<types::global_dof_index>(largest.back()));
          const Eigen::RowVectorXd direction =
            Eigen::Map<const Eigen::RowVectorXd>(largest.data(), n) / size;
          for (auto &row : rows)
            row.second -= row.second.dot(direction) * direction;
        }
      return anchors;
    }
  } // namespace

  std::vector<types::global_dof_index> choose_anchors(
    const Body &body, const AffineConstraints<double> &constraints,
    const FreeMotions &free_motions, const std::vector<types::global_dof_index> &excluded)
  {
    const auto n = free_motions.n();
    for (const auto &[only_coarse, left_out] :
         {std::make_pair(true, excluded), std::make_pair(false, excluded),
          std::make_pair(false, std::vector<types::global_dof_index>())})
      {
        std::vector<types::global_dof_index> anchors =
          choose(candidates(body, constraints, free_motions, left_out, only_coarse), n,
                 body.communicator());
        if (static_cast<Eigen::Index>(anchors.size()) == n)
          return anchors;
      }
    return {}; // a motion that vanishes at all vertices is none
  }
} // namespace stiction
