// The smooth surface that the faces of cells stand for: of trilinear cells on a sphere, a
// cylinder, flat faces and sharp edges it is exact, hanging nodes or not; on a cone, and
// of triquadratic cells, its error falls by twelve and more with the cells halved, where
// that of flat faces falls by four.

#include "tests.h"

#include <stiction/contact/certificate/smooth_boundary.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/geometry_parameters.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace stiction;
using dealii::Point;
using dealii::Tensor;
using Cell = dealii::DoFHandler<3>::active_cell_iterator;

namespace
{
  struct Errors
  {
    double flat = 0., smooth = 0., normal = 0.;
  };

  using Surface = std::function<SmoothBoundary::Place(const Point<3> &)>;

  // @param closest the place of the true surface that is next to a point
  // @param is_wanted of faces, by their centre
  Errors errors(const Body &body, const std::set<dealii::types::boundary_id> &ids,
                const Surface &closest,
                const std::function<bool(const Point<3> &)> &is_wanted)
  {
    const SmoothBoundary smooth(body, ids);
    const dealii::FE_Q<2> bilinear(1), fe(body.dof_handler().get_fe().degree);
    Errors errors;
    for (const Cell &cell : body.dof_handler().active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->is_locally_owned() && cell->at_boundary(f) &&
            ids.count(cell->face(f)->boundary_id()) > 0 &&
            is_wanted(cell->face(f)->center()))
          for (const double s : {0.2, 0.5, 0.8})
            for (const double t : {0.1, 0.5, 0.9})
              {
                std::vector<double> weights;
                for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
                  weights.push_back(fe.shape_value(a, {s, t}));
                Point<3> flat;
                for (unsigned int a = 0; a < 4; ++a)
                  flat +=
                    bilinear.shape_value(a, {s, t}) *
                    cell->vertex(dealii::GeometryInfo<3>::face_to_cell_vertices(f, a));
                const auto place = SmoothBoundary::at(smooth.face(cell, f), weights);
                const auto exact = closest(place.position);
                errors.flat =
                  std::max(errors.flat, flat.distance(closest(flat).position));
                errors.smooth =
                  std::max(errors.smooth, place.position.distance(exact.position));
                errors.normal =
                  std::max(errors.normal, (place.normal - exact.normal).norm());
              }
    for (double *error : {&errors.flat, &errors.smooth, &errors.normal})
      *error = dealii::Utilities::MPI::max(*error, MPI_COMM_WORLD);
    return errors;
  }

  SmoothBoundary::Place on_sphere(const Point<3> &p)
  {
    const Point<3> centre(0., 0., 1.);
    const Tensor<1, 3> n = (p - centre) / p.distance(centre);
    return {centre + n, n};
  }

  SmoothBoundary::Place on_cylinder(const Point<3> &p)
  {
    const Tensor<1, 3> from_axis({p[0], p[1], 0.});
    const Tensor<1, 3> n = from_axis / from_axis.norm();
    return {p - from_axis + n, n};
  }

  SmoothBoundary::Place on_cone(const Point<3> &p) // of radius ¾ − x/4
  {
    Tensor<1, 3> from_axis({0., p[1], p[2]});
    from_axis /= from_axis.norm();
    const Tensor<1, 3> n = (from_axis + Tensor<1, 3>({0.25, 0., 0.})) / std::sqrt(1.0625);
    return {p - ((Tensor<1, 3>(p) - 0.75 * from_axis) * n) * n, n};
  }

  struct Geometry : GeometryParameters
  {
    Geometry(const std::string &kind, const unsigned int refinement,
             const unsigned int degree = 1)
    {
      type                = kind;
      radius              = 1.;
      length              = 2.;
      generator           = "truncated_cone";
      generator_arguments = "1 : 0.5 : 1";
      element_degree      = degree;
      global_refinement   = refinement;
    }
  };

  // Cuts what is near the pole z = 0.
  void refine_near_pole(Body &body)
  {
    std::vector<bool> is_cut(body.triangulation().n_active_cells());
    for (const Cell &cell : body.dof_handler().active_cell_iterators())
      if (cell->center()[2] < 0.4)
        is_cut[cell->active_cell_index()] = true;
    body.refine(is_cut);
  }

  // @return the errors away from the rim.
  Errors errors(const Geometry &geometry, const Surface &closest,
                const bool has_hanging_nodes)
  {
    Body body(geometry, MPI_COMM_WORLD);
    if (has_hanging_nodes)
      refine_near_pole(body);
    return errors(body, {0}, closest, [&](const Point<3> &centre) {
      return geometry.type == "cylinder" ||
             (geometry.type == "generator" ? std::abs(centre[0]) : centre[2]) < 0.6;
    });
  }

  void round(const std::string &name, const std::string &type, const Surface &closest,
             const bool has_hanging_nodes)
  {
    out() << name << ':';
    for (const unsigned int refinement : {2, 3})
      {
        const Errors found =
          errors(Geometry(type, refinement), closest, has_hanging_nodes);
        out() << " faces off by more than 1e-3 " << yes(found.flat > 1e-3)
              << ", surface and normals exact to 1e-13 "
              << yes(std::max(found.smooth, found.normal) < 1e-13);
      }
    out() << std::endl;
  }

  void converge(const std::string &name, const std::string &type, const Surface &closest,
                const unsigned int degree, const bool has_hanging_nodes)
  {
    out() << name << ':';
    Errors last;
    for (const unsigned int refinement : {2, 3, 4})
      {
        const Errors now =
          errors(Geometry(type, refinement, degree), closest, has_hanging_nodes);
        if (last.flat > 0.)
          out() << "\n  faces by 3.5 to 4.5 "
                << yes(last.flat > 3.5 * now.flat && last.flat < 4.5 * now.flat)
                << ", surface by more than 12 " << yes(last.smooth > 12. * now.smooth)
                << ", normals by more than 3.8 " << yes(last.normal > 3.8 * now.normal);
        last = now;
      }
    out() << ", surface better than faces by more than 1e4 "
          << yes(last.flat > 1e4 * last.smooth) << std::endl;
  }

  void box(const std::string &name, const GeometryParameters &geometry,
           const std::set<dealii::types::boundary_id> &ids, const bool has_hanging_nodes)
  {
    Body body(geometry, MPI_COMM_WORLD);
    if (has_hanging_nodes)
      refine_near_pole(body);
    const auto corners = body.bounding_box().get_boundary_points();
    const auto on_box  = [&](const Point<3> &p) {
      SmoothBoundary::Place place{p, {}};
      double nearest = 1e300;
      for (unsigned int d = 0; d < 3; ++d)
        for (const auto *corner : {&corners.first, &corners.second})
          if (std::abs(p[d] - (*corner)[d]) < nearest)
            {
              nearest           = std::abs(p[d] - (*corner)[d]);
              place             = {p, {}};
              place.position[d] = (*corner)[d];
              place.normal[d]   = corner == &corners.first ? -1. : 1.;
            }
      return place;
    };
    const Errors found = errors(body, ids, on_box, [](const Point<3> &) { return true; });
    out() << name << ": exact to 1e-14 "
          << yes(std::max(found.smooth, found.normal) < 1e-14) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  round("sphere", "half ball", on_sphere, false);
  round("sphere with hanging nodes", "half ball", on_sphere, true);
  round("cylinder", "cylinder", on_cylinder, false);
  converge("cone", "generator", on_cone, 1, false);
  converge("sphere, degree 2", "half ball", on_sphere, 2, false);
  converge("sphere, degree 2, with hanging nodes", "half ball", on_sphere, 2, true);

  Geometry brick("brick", 1);
  brick.lengths      = {1., 1.5, 2.};
  brick.subdivisions = {1, 2, 2};
  for (const bool has_hanging_nodes : {false, true})
    box(has_hanging_nodes ? "brick with hanging nodes" : "brick", brick,
        {0, 1, 2, 3, 4, 5}, has_hanging_nodes);
  Geometry cube("generator", 2);
  cube.generator           = "hyper_cube";
  cube.generator_arguments = "0 : 1 : false";
  box("cube, one boundary around its edges", cube, {0}, false);
}
