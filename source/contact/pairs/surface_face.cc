#include <stiction/base/all_gather.h>
#include <stiction/base/log.h>
#include <stiction/contact/pairs/surface_face.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    std::array<double, 3> in_array(const Point<3> &p) { return {{p[0], p[1], p[2]}}; }

    // The Lagrange polynomials of one variable, and their slopes.
    std::array<double, 3> values(const unsigned int degree, const double x)
    {
      if (degree == 1)
        return {{1. - x, x, 0.}};
      return {{(1. - x) * (1. - 2. * x), 4. * x * (1. - x), x * (2. * x - 1.)}};
    }

    std::array<double, 3> slopes(const unsigned int degree, const double x)
    {
      if (degree == 1)
        return {{-1., 1., 0.}};
      return {{4. * x - 3., 4. - 8. * x, 4. * x - 1.}};
    }

    // Of the shorter way across a face: an arc of 30 degrees rises by more over its
    // chord.
    constexpr double least_rise = 0.05;

    Point<3> unit_centre(const unsigned int face)
    {
      Point<3> centre(0.5, 0.5, 0.5);
      centre[face / 2] = face % 2;
      return centre;
    }

    // The nodes of a cell on one of its faces, along the first edge first.
    std::vector<unsigned int> nodes_on_face(const FiniteElement<3> &scalar,
                                            const unsigned int f)
    {
      const auto &points         = scalar.get_unit_support_points();
      const unsigned int n       = scalar.degree + 1;
      const unsigned int across  = f / 2;
      const double level         = f % 2;
      const unsigned int along[] = {(across + 1) % 3, (across + 2) % 3};
      std::vector<unsigned int> nodes(n * n);
      for (unsigned int i = 0; i < points.size(); ++i)
        if (std::abs(points[i][across] - level) < 0.1)
          {
            const auto place = [&](const unsigned int d) {
              return static_cast<unsigned int>(
                std::lround(points[i][along[d]] * scalar.degree));
            };
            nodes[place(0) + n * place(1)] = i;
          }
      return nodes;
    }
  } // namespace

  std::array<Point<3>, 4> SurfaceFace::corners() const
  {
    const unsigned int n = degree + 1;
    return {{node(0), node(n - 1), node(n * n - 1), node(n * (n - 1))}};
  }

  std::array<types::global_dof_index, 4> SurfaceFace::corner_dofs() const
  {
    const unsigned int n = degree + 1;
    return {{dofs[0], dofs[n - 1], dofs[n * n - 1], dofs[n * (n - 1)]}};
  }

  Point<3> SurfaceFace::centre() const
  {
    Point<3> sum;
    for (const Point<3> &corner : corners())
      sum += corner / 4.;
    return sum;
  }

  Tensor<1, 3> SurfaceFace::normal() const
  {
    const auto c              = corners();
    const Tensor<1, 3> across = cross_product_3d(c[2] - c[0], c[3] - c[1]);
    const Point<3> in(inside[0], inside[1], inside[2]);
    return (across * (centre() - in) > 0. ? 1. : -1.) / across.norm() * across;
  }

  double SurfaceFace::area() const
  {
    const auto c = corners();
    return 0.5 * cross_product_3d(c[2] - c[0], c[3] - c[1]).norm();
  }

  double SurfaceFace::diameter() const
  {
    const auto c = corners();
    return std::max(c[0].distance(c[2]), c[1].distance(c[3]));
  }

  FaceShape::FaceShape(const unsigned int degree, const std::array<double, 2> &at)
  {
    const unsigned int n = degree + 1;
    const auto x = values(degree, at[0]), y = values(degree, at[1]);
    const auto dx = slopes(degree, at[0]), dy = slopes(degree, at[1]);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          value[i + n * j]    = x[i] * y[j];
          gradient[i + n * j] = {{dx[i] * y[j], x[i] * dy[j]}};
        }
  }

  std::vector<std::array<double, 2>> kinks(const std::vector<SurfaceFace> &faces)
  {
    std::map<types::global_dof_index, Tensor<1, 3>> at_nodes;
    for (const SurfaceFace &face : faces)
      for (const auto dof : face.corner_dofs())
        at_nodes[dof] += face.area() * face.normal();
    std::vector<std::array<double, 2>> of_faces;
    for (const SurfaceFace &face : faces)
      {
        double least = 1., most = 0.;
        for (const auto dof : face.corner_dofs())
          {
            const Tensor<1, 3> mean = at_nodes.at(dof) / at_nodes.at(dof).norm();
            const double half       = cross_product_3d(mean, face.normal()).norm();
            least                   = std::min(least, half);
            most                    = std::max(most, half);
          }
        of_faces.push_back({{least, most}});
      }
    return of_faces;
  }

  double depth_of_facets(const std::vector<SurfaceFace> &faces)
  {
    const auto of_faces = kinks(faces);
    double depth        = 0.;
    for (std::size_t f = 0; f < faces.size(); ++f)
      {
        const auto [least, most] = of_faces[f];
        // a part of a large facet has edges of that on one side alone
        const double size =
          least > 0.5 * most ? faces[f].diameter() : faces[f].coarse_diameter;
        depth = std::max(depth, most * size / 4.);
      }
    return depth;
  }

  std::string why_not_opposite(const std::vector<SurfaceFace> &first,
                               const std::vector<SurfaceFace> &second)
  {
    double distance = std::numeric_limits<double>::max(), cosine = 0.;
    for (const SurfaceFace &a : first)
      for (const SurfaceFace &b : second)
        if (const double d = a.centre().distance(b.centre()); d < distance)
          {
            distance = d;
            cosine   = a.normal() * b.normal();
          }
    const double reach =
      std::min(first.front().surface_size, second.front().surface_size);
    if (distance > reach)
      return format("are %.3g apart, must be nearer than the smaller one is large, %.3g",
                    distance, reach);
    if (cosine > -facing_cosine)
      return format("have outward normals that are %.0f degrees apart, must look at each "
                    "other",
                    std::acos(std::min(1., cosine)) * 180. / numbers::PI);
    return "lie beside each other, must overlap along their normals";
  }

  double mean_diameter(const std::vector<SurfaceFace> &faces)
  {
    double size = 0.;
    for (const SurfaceFace &face : faces)
      size += face.diameter() / static_cast<double>(faces.size());
    return size;
  }

  namespace
  {
    // Makes the faces of one rank.
    class FaceMaker
    {
    public:
      explicit FaceMaker(const LinearElasticity &elasticity)
        : body_(elasticity.body())
        , materials_(elasticity.materials())
        , base_(body_.dof_handler().get_fe().base_element(0))
        , values_(body_.mapping(), base_, base_.get_unit_support_points(),
                  update_quadrature_points)
        , dofs_(body_.dof_handler().get_fe().n_dofs_per_cell())
      {
        for (unsigned int f = 0; f < 6; ++f)
          on_face_[f] = nodes_on_face(base_, f);
      }

      SurfaceFace face(const DoFHandler<3>::active_cell_iterator &cell,
                       const unsigned int f)
      {
        values_.reinit(static_cast<Triangulation<3>::cell_iterator>(cell));
        cell->get_dof_indices(dofs_);
        SurfaceFace face{};
        face.degree          = base_.degree;
        face.coarse_diameter = coarse_diameter(cell, f);
        face.inside          = in_array(cell->center());
        face.youngs_modulus  = materials_.of(cell->material_id()).youngs_modulus;
        face.piece           = body_.piece_of(cell);
        const auto &box      = body_.pieces()[face.piece].box;
        face.thickness =
          std::min({box.side_length(0), box.side_length(1), box.side_length(2)});
        for (unsigned int k = 0; k < on_face_[f].size(); ++k)
          {
            face.dofs[k]  = dofs_[3 * on_face_[f][k]];
            face.nodes[k] = in_array(values_.quadrature_point(on_face_[f][k]));
          }
        face.is_round =
          rises(face,
                body_.mapping().transform_unit_to_real_cell(cell, unit_centre(f))) ||
          rises(face, cell->face(f)->center(true));
        return face;
      }

    private:
      static double coarse_diameter(Triangulation<3>::cell_iterator cell,
                                    const unsigned int f)
      {
        while (cell->level() > 0)
          cell = cell->parent();
        const auto corner = [&](const unsigned int v) {
          return cell->face(f)->vertex(v);
        };
        return std::max(corner(0).distance(corner(3)), corner(1).distance(corner(2)));
      }

      // Whether this is the centre of a round one.
      static bool rises(const SurfaceFace &face, const Point<3> &centre)
      {
        const auto c = face.corners();
        return std::abs((centre - face.centre()) * face.normal()) >
               0.5 * least_rise *
                 std::min((c[0] + (c[1] - c[2]) - c[3]).norm(),
                          (c[0] + (c[3] - c[1]) - c[2]).norm());
      }

      const Body &body_;
      const Materials &materials_;
      const FiniteElement<3> &base_;
      FEValues<3> values_;
      std::vector<types::global_dof_index> dofs_;
      std::array<std::vector<unsigned int>, 6> on_face_;
    };

    // What they are as a whole.
    void set_sizes(std::vector<SurfaceFace> &faces)
    {
      if (faces.empty())
        return;
      std::vector<Point<3>> points;
      double thickness = faces.front().thickness;
      for (const SurfaceFace &face : faces)
        {
          thickness = std::min(thickness, face.thickness);
          for (unsigned int i = 0; i < face.n_nodes(); ++i)
            points.push_back(face.node(i));
        }
      const double size = diameter(BoundingBox<3>(points));
      for (SurfaceFace &face : faces)
        {
          face.surface_size = size;
          face.thickness    = thickness;
        }
    }
  } // namespace

  std::vector<SurfaceFace> surface_faces(const LinearElasticity &elasticity,
                                         const std::vector<types::boundary_id> &ids)
  {
    const Body &body = elasticity.body();
    FaceMaker maker(elasticity);
    std::vector<SurfaceFace> faces;
    for (const auto &cell : body.locally_owned_cells())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            std::count(ids.begin(), ids.end(), cell->face(f)->boundary_id()) > 0)
          faces.push_back(maker.face(cell, f));
    faces = all_gather(faces, body.communicator());
    set_sizes(faces);
    // in an order that does not depend on the partition
    std::sort(faces.begin(), faces.end(), [](const SurfaceFace &a, const SurfaceFace &b) {
      return std::tie(a.inside, a.nodes) < std::tie(b.inside, b.nodes);
    });
    return faces;
  }
} // namespace stiction
