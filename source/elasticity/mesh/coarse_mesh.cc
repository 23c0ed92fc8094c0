#include <stiction/base/errors.h>
#include <stiction/base/text/in_words.h>
#include <stiction/elasticity/mesh/coarse_mesh.h>
#include <stiction/elasticity/mesh/shape_parameters.h>
#include <stiction/elasticity/mesh/readers/mesh_file.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Vertices = std::array<Point<3>, 8>; // in deal.II's order

    using Gradients = std::array<Tensor<1, 3>, 8>; // of the trilinear functions

    // Vertices show a cell that is folded before Gauss points do, which are
    // what the stiffness needs.
    std::vector<Gradients> gradients_to_check()
    {
      const double gauss = .5 - .5 / std::sqrt(3.);
      std::vector<Gradients> all;
      for (const double inset : {0., gauss})
        for (unsigned int at = 0; at < 8; ++at)
          {
            Point<3> p = GeometryInfo<3>::unit_cell_vertex(at);
            for (unsigned int c = 0; c < 3; ++c)
              p[c] = inset + (1. - 2. * inset) * p[c];
            all.emplace_back();
            for (unsigned int v = 0; v < 8; ++v)
              all.back()[v] = GeometryInfo<3>::d_linear_shape_function_gradient(p, v);
          }
      return all;
    }

    bool is_valid(const Vertices &vertices, const double smallest)
    {
      static const std::vector<Gradients> points = gradients_to_check();
      return std::all_of(points.begin(), points.end(), [&](const Gradients &gradients) {
        Tensor<2, 3> jacobian;
        for (unsigned int v = 0; v < 8; ++v)
          jacobian += outer_product(Tensor<1, 3>(vertices[v]), gradients[v]);
        return determinant(jacobian) > smallest;
      });
    }

    // The vertices of a cell with several faces on a sphere are flat if it is a
    // good cell, with edges along the sphere: Gauss points alone count.
    bool is_valid(const QuadraticCells &cells, const QuadraticCells::Cell &cell,
                  const double smallest)
    {
      static const QGauss<3> quadrature(3);
      const auto &points = quadrature.get_points();
      return cells.empty() ||
             std::all_of(points.begin(), points.end(), [&](const Point<3> &p) {
               return cells.determinant(cell, p) > smallest;
             });
    }

    // What an exception of many lines has to say, in one.
    std::string in_one_line(const ExceptionBase &exception)
    {
      std::ostringstream out;
      exception.print_info(out);
      std::string text;
      for (const char c : out.str())
        if (c != '\n' && c != '\t' && c != ' ')
          text += c;
        else if (!text.empty() && text.back() != ' ')
          text += ' ';
      while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
        text.pop_back();
      return text.substr(0, 200);
    }
  } // namespace

  CoarseMesh::CoarseMesh(const ShapeParameters &shape)
    : triangulation_(Triangulation<3>::none, false)
  {
    std::map<std::string, MeshNames::Id> boundaries, materials;
    std::string how_to_name;
    try
      {
        if (shape.is_brick())
          {
            make_brick(shape, triangulation_);
            boundaries = {{"left", 0}, {"right", 1},  {"front", 2},
                          {"back", 3}, {"bottom", 4}, {"top", 5}};
          }
        else if (shape.type == "cylinder")
          {
            boundaries = {{"side", 0}, {"bottom", 1}, {"top", 2}};
            if (shape.inner_radius)
              {
                make_tube(*shape.inner_radius, *shape.radius, *shape.length);
                boundaries["inside"] = 3;
              }
            else
              make_cylinder(*shape.radius, *shape.length);
          }
        else if (shape.type == "half ball")
          {
            make_half_ball(*shape.radius);
            boundaries = {{"curved", 0}, {"flat", 1}};
          }
        else if (shape.type == "generator")
          generate(shape);
        else
          {
            const MeshData mesh =
              read_mesh_file(shape.mesh_file, shape.location, shape.boundaries_in_use);
            triangulation_.create_triangulation(mesh.vertices, mesh.cells, mesh.faces);
            origin_.quadratic_cells = QuadraticCells(triangulation_, mesh.inner_nodes);
            origin_.cut_elements    = mesh.cut_elements;
            for (const std::string &what : mesh.left_out)
              origin_.left_out.push_back("Left out of " + shape.mesh_file + ": " + what);
            for (const std::string &what : mesh.damages)
              origin_.damages.push_back("in " + shape.mesh_file + ' ' + what + '.');
            boundaries    = mesh.boundary_names;
            materials     = mesh.material_names;
            body_names_   = mesh.body_names;
            body_of_cell_ = mesh.body_of_cell;
            how_to_name   = mesh.how_to_name_boundaries;
          }
      }
    catch (const ExceptionBase &exception)
      {
        throw InputError(shape.location + ", makes no mesh: " + in_one_line(exception) +
                         ".");
      }
    require_valid_cells(triangulation_, origin_.quadratic_cells,
                        shape.location +
                          (origin_.cut_elements.empty() ? "" : ", when cut"));
    set_names(boundaries, materials, how_to_name);
    for (const auto &[name, id] : materials)
      body_of_material_[id] = name;
  }

  std::string CoarseMesh::body_name(const Triangulation<3>::cell_iterator &cell) const
  {
    if (!body_of_cell_.empty())
      return body_names_[body_of_cell_[cell->index()]];
    const auto found = body_of_material_.find(cell->material_id());
    return found == body_of_material_.end() ? "" : found->second;
  }

  void CoarseMesh::make_brick(const ShapeParameters &shape,
                              Triangulation<3> &triangulation)
  {
    GridGenerator::subdivided_hyper_rectangle(
      triangulation, shape.subdivisions, Point<3>(),
      Point<3>(shape.lengths[0], shape.lengths[1], shape.lengths[2]), true);
    // deal.II colours the octants, too
    for (const auto &cell : triangulation.active_cell_iterators())
      cell->set_material_id(0);
  }

  void CoarseMesh::make_cylinder(const double radius, const double length)
  {
    // around the x axis, x from -length / 2; ids 0 hull, 1 left, 2 right
    GridGenerator::subdivided_cylinder(
      triangulation_,
      static_cast<unsigned int>(std::max(1., std::round(length / radius))), radius,
      .5 * length);
    GridTools::transform(
      [&](const Point<3> &p) { return Point<3>(p[1], p[2], p[0] + .5 * length); },
      triangulation_);
    triangulation_.set_manifold(0, CylindricalManifold<3>(2));
  }

  void CoarseMesh::make_tube(const double inner, const double outer, const double length)
  {
    const double around = numbers::PI * (inner + outer), thickness = outer - inner;
    const double n_around = std::clamp(4. * std::round(around / thickness / 4.), 8., 48.);
    const double n_along  = std::max(1., std::round(length * n_around / around));
    GridGenerator::cylinder_shell(triangulation_, length, inner, outer,
                                  static_cast<unsigned int>(n_around),
                                  static_cast<unsigned int>(n_along));
    for (const auto &face : triangulation_.active_face_iterators())
      if (face->at_boundary())
        {
          const double z = face->center()[2] / length;
          const double r = std::hypot(face->vertex(0)[0], face->vertex(0)[1]);
          face->set_boundary_id(z < 1e-6                    ? 1
                                : z > 1. - 1e-6             ? 2
                                : r < 0.5 * (inner + outer) ? 3
                                                            : 0);
        }
  }

  void CoarseMesh::make_half_ball(const double radius)
  {
    // the half x > 0; ids 0 curved, 1 flat
    GridGenerator::half_hyper_ball(triangulation_, Point<3>(), radius);
    GridTools::transform(
      [&](const Point<3> &p) { return Point<3>(p[2], p[1], radius - p[0]); },
      triangulation_);
    triangulation_.set_manifold(0, SphericalManifold<3>(Point<3>(0., 0., radius)));
  }

  void CoarseMesh::generate(const ShapeParameters &shape)
  {
    Triangulation<3> generated(Triangulation<3>::none, false);
    try
      {
        GridGenerator::generate_from_name_and_arguments(generated, shape.generator,
                                                        shape.generator_arguments);
      }
    catch (const ExceptionBase &)
      {
        throw InputError(shape.location + ", does not take 'Generator arguments' = '" +
                         shape.generator_arguments + "', must be '" +
                         shape.generator_takes() +
                         "' with a value each, 'x, y, z' for points, true or false for "
                         "colorize and attach_spherical_manifold.");
      }
    if (generated.n_active_cells() == 0)
      throw InputError(shape.location + ", makes a mesh without cells.");
    if (!generated.all_reference_cells_are_hyper_cube())
      throw InputError(shape.location + ", makes other cells than hexahedra, must be a "
                                        "generator of hexahedra.");
    // what comes refined becomes a coarse mesh that every rank can share
    GridGenerator::flatten_triangulation(generated, triangulation_);
    for (const auto manifold : generated.get_manifold_ids())
      if (manifold != numbers::flat_manifold_id)
        triangulation_.set_manifold(manifold, generated.get_manifold(manifold));
  }

  void CoarseMesh::set_names(const std::map<std::string, MeshNames::Id> &boundaries,
                             const std::map<std::string, MeshNames::Id> &materials,
                             const std::string &how_to_name)
  {
    std::set<MeshNames::Id> material_ids;
    for (const auto &cell : triangulation_.active_cell_iterators())
      material_ids.insert(cell->material_id());
    const auto boundary_ids = triangulation_.get_boundary_ids();
    origin_.boundary_names =
      MeshNames("boundary", {boundary_ids.begin(), boundary_ids.end()}, boundaries,
                materials, how_to_name);
    origin_.material_names = MeshNames("material", material_ids, materials, boundaries);
  }

  void require_valid_cells(const Triangulation<3> &triangulation,
                           const QuadraticCells &quadratic_cells,
                           const std::string &location)
  {
    for (const auto &cell : triangulation.cell_iterators())
      {
        if (cell->level_subdomain_id() == numbers::artificial_subdomain_id)
          continue;
        Vertices vertices;
        for (unsigned int v = 0; v < 8; ++v)
          vertices[v] = cell->vertex(v);
        double size = 0.;
        for (const Point<3> &vertex : vertices)
          size = std::max(size, vertex.distance(vertices[0]));
        const double smallest  = 1e-14 * size * size * size;
        const bool has_corners = is_valid(vertices, smallest);
        if (has_corners && is_valid(quadratic_cells, cell, smallest))
          continue;
        const bool is_coarse = cell->level() == 0;
        const std::string advice =
          !is_coarse    ? ", as they may with smaller cells from 'Geometry/Global "
                          "refinement' or in the file."
          : has_corners ? ": smaller cells where edges are curved unfold it, or a mesher "
                          "that moves nodes, in Gmsh 'Mesh.HighOrderOptimize = 2'."
                        : ".";
        throw InputError(text_of(
          location, ", ",
          is_coarse ? "cell " + std::to_string(cell->index() + 1) : "a refined cell",
          " with its centre at (", cell->center(), ") is inverted or degenerate, its ",
          has_corners ? "nodes" : "corners", " must make a hexahedron that is not folded",
          advice));
      }
  }
} // namespace stiction
