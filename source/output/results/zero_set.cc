#include "zero_set.h"

#include <deal.II/base/table.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Function = std::function<std::optional<double>(const Point<3> &)>;

    // The cubes of a box that the surface cuts, and the function at all corners,
    // each computed once: a surface may lie on a plane of corners, where rounding
    // decides of the sign.
    class CutCubes
    {
    public:
      CutCubes(const Function &function, const BoundingBox<3> &box)
        : origin_(box.get_boundary_points().first)
      {
        const double longest =
          std::max({box.side_length(0), box.side_length(1), box.side_length(2)});
        for (unsigned int c = 0; c < 3; ++c)
          {
            // odd, so that planes through the middle cut the cubes
            n_[c] = 2 * static_cast<unsigned int>(
                          std::ceil(box.side_length(c) / longest * 20.)) +
                    1;
            width_[c] = box.side_length(c) / n_[c];
          }
        compute_distances(function);
        make_cubes();
      }

      const Triangulation<3> &cubes() const { return cubes_; }

      // At the corner of a cube.
      double distance(const Point<3> &corner) const
      {
        TableIndices<3> index;
        for (unsigned int c = 0; c < 3; ++c)
          index[c] = std::llround((corner[c] - origin_[c]) / width_[c]);
        return distances_(index);
      }

    private:
      void compute_distances(const Function &function)
      {
        distances_.reinit(n_[0] + 1, n_[1] + 1, n_[2] + 1);
        for (unsigned int i = 0; i <= n_[0]; ++i)
          for (unsigned int j = 0; j <= n_[1]; ++j)
            for (unsigned int k = 0; k <= n_[2]; ++k)
              {
                const auto value = function(
                  origin_ + Point<3>(i * width_[0], j * width_[1], k * width_[2]));
                distances_(i, j, k) =
                  value.value_or(std::numeric_limits<double>::quiet_NaN());
              }
      }

      void make_cubes()
      {
        Table<3, types::material_id> is_cut(n_[0], n_[1], n_[2]);
        bool is_any_cut = false;
        for (unsigned int i = 0; i < n_[0]; ++i)
          for (unsigned int j = 0; j < n_[1]; ++j)
            for (unsigned int k = 0; k < n_[2]; ++k)
              {
                unsigned int below = 0, above = 0;
                for (unsigned int v = 0; v < 8; ++v)
                  {
                    const double d =
                      distances_(i + (v & 1), j + (v >> 1 & 1), k + (v >> 2));
                    below += d < 0. ? 1 : 0;
                    above += d >= 0. ? 1 : 0;
                  }
                const bool cut  = below > 0 && above > 0 && below + above == 8;
                is_cut(i, j, k) = cut ? 0 : numbers::invalid_material_id;
                is_any_cut |= cut;
              }
        if (!is_any_cut)
          return;
        std::vector<std::vector<double>> widths(3);
        for (unsigned int c = 0; c < 3; ++c)
          widths[c].assign(n_[c], width_[c]);
        GridGenerator::subdivided_hyper_rectangle(cubes_, widths, origin_, is_cut);
      }

      const Point<3> origin_;
      std::array<unsigned int, 3> n_{};
      std::array<double, 3> width_{};
      Table<3, double> distances_;
      Triangulation<3> cubes_;
    };
  } // namespace

  TriangulatedSurface zero_set(const Function &distance, const BoundingBox<3> &box)
  {
    TriangulatedSurface surface;
    const CutCubes cut(distance, box);
    if (cut.cubes().n_levels() == 0)
      return surface;
    const FE_Q<3> fe(1);
    DoFHandler<3> dof_handler(cut.cubes());
    dof_handler.distribute_dofs(fe);
    Vector<double> values(dof_handler.n_dofs());
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        values(cell->vertex_dof_index(v, 0)) = cut.distance(cell->vertex(v));

    std::vector<CellData<2>> triangles;
    GridTools::MarchingCubeAlgorithm<3, Vector<double>>(StaticMappingQ1<3>::mapping, fe)
      .process(dof_handler, values, 0., surface.vertices, triangles);
    for (const auto &triangle : triangles)
      surface.triangles.push_back(
        {{triangle.vertices[0], triangle.vertices[1], triangle.vertices[2]}});
    return surface;
  }
} // namespace stiction
