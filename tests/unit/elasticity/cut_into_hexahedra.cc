// Tetrahedra and prisms become hexahedra that fill the body without gaps: of its six
// sides and nothing else they have boundaries, by name, and of each material the
// volume. Blocks from files of every format; then a quarter of a ring, whose curvature
// cells of second order keep.

#include "cut_block_file.h"
#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/geometry_parameters.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

using namespace stiction;

namespace
{
  std::unique_ptr<Body> read(const std::string &file, const unsigned int refinement = 0,
                             const unsigned int degree = 1)
  {
    GeometryParameters geometry;
    geometry.type              = "file";
    geometry.mesh_file         = file;
    geometry.global_refinement = refinement;
    geometry.element_degree    = degree;
    return std::make_unique<Body>(geometry, MPI_COMM_WORLD);
  }

  struct Sizes
  {
    std::map<std::string, double> volumes, areas; // by names, else by numbers
    double volume = 0.;
  };

  Sizes sizes(const Body &body)
  {
    const auto name = [](const MeshNames &names, const MeshNames::Id id) {
      return names.name(id).empty() ? std::to_string(id) : names.name(id);
    };
    Sizes sizes;
    dealii::FEValues<3> values(body.mapping(), body.dof_handler().get_fe(),
                               dealii::QGauss<3>(4), dealii::update_JxW_values);
    dealii::FEFaceValues<3> on_face(body.mapping(), body.dof_handler().get_fe(),
                                    dealii::QGauss<2>(4), dealii::update_JxW_values);
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      {
        values.reinit(cell);
        for (const double volume : values.get_JxW_values())
          {
            sizes.volume += volume;
            sizes.volumes[name(body.material_names(), cell->material_id())] += volume;
          }
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              on_face.reinit(cell, f);
              for (const double area : on_face.get_JxW_values())
                sizes.areas[name(body.boundary_names(), cell->face(f)->boundary_id())] +=
                  area;
            }
      }
    return sizes;
  }

  // A block of 3 m x 2 m x 2 m in as many cubes.
  void block(const std::string &title, const CutBlockFile::Kind &kind)
  {
    for (const unsigned int order : {1, 2})
      for (const std::string format : {"msh", "inp", "vtk"})
        {
          const std::string file = "block." + format;
          CutBlockFile(
            {{3, 2, 2}}, kind,
            [](const dealii::Point<3> &p) {
              return dealii::Point<3>(3. * p[0], 2. * p[1], 2. * p[2]);
            },
            order)
            .write(file);
          const std::unique_ptr<Body> body = read(file);
          const Sizes seen                 = sizes(*body);
          bool is_right     = seen.areas.size() == 6 && seen.volumes.size() == 2;
          const bool is_vtk = format == "vtk";
          const std::vector<std::string> sides =
            is_vtk ? std::vector<std::string>{"1", "2", "3", "4", "5", "6"}
                   : std::vector<std::string>{"left", "right",  "front",
                                              "back", "bottom", "top"};
          const std::vector<double> areas = {4., 4., 6., 6., 6., 6.};
          for (unsigned int side = 0; side < 6 && is_right; ++side)
            is_right = seen.areas.count(sides[side]) == 1 &&
                       std::abs(seen.areas.at(sides[side]) - areas[side]) < 1e-12;
          for (const auto &volume : seen.volumes)
            is_right = is_right && std::abs(volume.second - 6.) < 1e-12;
          is_right = is_right && seen.volumes.count(is_vtk ? "7" : "lower") == 1;
          std::string elements;
          for (const auto &[name, n] : body->cut_elements())
            elements += std::to_string(n) + ' ' + name + ", ";
          out() << title << ", " << format << ", order " << order << ": " << elements
                << body->triangulation().n_active_cells()
                << " cells, boundaries and materials " << yes(is_right) << std::endl;
        }
  }

  dealii::Point<3> ring(const dealii::Point<3> &p)
  {
    const double r = 1. + p[0], angle = .5 * dealii::numbers::PI * p[1];
    return {r * std::cos(angle), r * std::sin(angle), p[2]};
  }

  void curvature(const std::string &title, const char kind)
  {
    const double exact = .75 * dealii::numbers::PI;
    std::vector<double> errors, refined;
    for (const unsigned int n : {2, 4, 8})
      {
        CutBlockFile(
          {{n, n, 2}}, [&](const auto &) { return kind; }, ring, 2)
          .write("ring.msh");
        errors.push_back(std::abs(sizes(*read("ring.msh", 0, 2)).volume / exact - 1.));
      }
    CutBlockFile(
      {{2, 2, 1}}, [&](const auto &) { return kind; }, ring, 2)
      .write("ring.msh");
    const double curved = sizes(*read("ring.msh", 0, 2)).volume;
    for (const unsigned int n : {0, 1, 2})
      refined.push_back(std::abs(sizes(*read("ring.msh", n)).volume / curved - 1.));
    const double finer = sizes(*read("ring.msh", 1, 2)).volume;
    out() << title << ": the volume is right to 1e-3 with two across "
          << yes(errors[0] < 1e-3) << ", errors fall more than twelvefold when there are "
          << "twice as many "
          << yes(errors[0] > 12. * errors[1] && errors[1] > 12. * errors[2])
          << ", refined the body is the same to 1e-12 "
          << yes(std::abs(finer / curved - 1.) < 1e-12)
          << ", trilinear cells approach it fourfold "
          << yes(refined[0] > 3.5 * refined[1] && refined[1] > 3.5 * refined[2])
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Place = CutBlockFile::Place;
  block("tetrahedra", [](const Place &) { return 't'; });
  block("prisms", [](const Place &) { return 'z'; });
  block("prisms below tetrahedra",
        [](const Place &cube) { return cube[2] == 0 ? 'z' : 't'; });
  block("hexahedra beside prisms",
        [](const Place &cube) { return cube[0] < 2 ? 'h' : 'z'; });
  block("prisms of both axes", [](const Place &cube) { return cube[0] < 1 ? 'z' : 'y'; });
  curvature("a ring of curved tetrahedra", 't');
  curvature("a ring of curved prisms", 'z');
}
