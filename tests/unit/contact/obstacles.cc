// Obstacles: ψ and ∇ψ of every shape in closed form, of formulas and surfaces
// of triangles; gaps and normals of contact nodes; which nodes face away; whose
// the nodes on a common edge of two contact boundaries are.

#include "tests.h"

#include <stiction/contact/obstacles/obstacle.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>

using namespace stiction;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const std::vector<Point<3>> places = {{0.3, -0.7, 1.9},
                                        {1.1, 0.2, 0.4},
                                        {-2., 0.5, 0.3},
                                        {0.1, 0.2, -3.}};

  std::unique_ptr<Obstacle> read(const std::string &text)
  {
    return Obstacle::read(text, "the test", 1., 1., MPI_COMM_WORLD);
  }

  // The largest error against a closed form.
  void compare(const std::string &text,
               const std::function<Obstacle::Value(const Point<3> &)> &exact,
               const double tolerance = 1e-13)
  {
    const auto obstacle = read(text);
    double error        = 0.;
    for (const Point<3> &p : places)
      {
        const auto value = obstacle->at(p), right = exact(p);
        error = std::max({error, std::abs(value.psi - right.psi),
                          (value.gradient - right.gradient).norm()});
      }
    out() << text << ": " << yes(error < tolerance) << std::endl;
  }

  // A sphere of triangles: an icosahedron's or, simpler, a grid's of angles.
  void write_sphere(const std::string &file, const double R, const unsigned int n,
                    const bool is_binary = false)
  {
    std::ofstream stl(file);
    stl.precision(17);
    const auto at = [&](const unsigned int i, const unsigned int j) {
      const double theta = dealii::numbers::PI * i / n;
      const double phi   = dealii::numbers::PI * (j % (2 * n)) / n;
      const double s     = i == 0 || i == n ? 0. : std::sin(theta);
      return Point<3>(R * s * std::cos(phi), R * s * std::sin(phi), R * std::cos(theta));
    };
    std::vector<std::array<Point<3>, 3>> triangles;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < 2 * n; ++j)
        {
          triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
          triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
        }
    if (is_binary)
      {
        // a title, how many, then the normal, the corners and two bytes of each
        const auto write = [&](const auto value) {
          stl.write(reinterpret_cast<const char *>(&value), sizeof(value));
        };
        stl << std::string(80, ' ');
        write(static_cast<std::uint32_t>(triangles.size()));
        for (const auto &triangle : triangles)
          {
            for (const Point<3> &p : {Point<3>(), triangle[0], triangle[1], triangle[2]})
              for (unsigned int d = 0; d < 3; ++d)
                write(static_cast<float>(p[d]));
            write(std::uint16_t(0));
          }
        return;
      }
    stl << "solid sphere\n";
    for (const auto &triangle : triangles)
      {
        stl << "facet normal 0 0 0\nouter loop\n";
        for (const Point<3> &p : triangle)
          stl << "vertex " << p << "\n";
        stl << "endloop\nendfacet\n";
      }
    stl << "endsolid sphere\n";
  }

  struct Problem
  {
    explicit Problem(std::vector<std::string> settings)
    {
      settings.insert(settings.begin(),
                      {"Geometry/Table 1 level=0", "Geometry/Lengths=1,1,1",
                       "Geometry/Subdivisions=4,4,4", "Geometry/Global refinement=1",
                       "Boundary conditions/Traction="});
      parameters.read(shipped("brick.prm"), settings);
      body       = std::make_unique<Body>(parameters.geometry, MPI_COMM_WORLD);
      elasticity = std::make_unique<LinearElasticity>(*body, parameters.of_body());
      surface    = std::make_unique<ContactSurface>(*elasticity, parameters.of_contact());
    }

    Parameters parameters;
    std::unique_ptr<Body> body;
    std::unique_ptr<LinearElasticity> elasticity;
    std::unique_ptr<ContactSurface> surface;
  };
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  compare("plane : 0; 0; 0.5; 3; 0; 4", [](const Point<3> &p) {
    const Tensor<1, 3> n({0.6, 0., 0.8});
    return Obstacle::Value{(p - Point<3>(0., 0., 0.5)) * n, n};
  });
  const auto sphere = [](const Point<3> &p, const double R, const double sign) {
    const Tensor<1, 3> v = p - Point<3>(0.1, 0.2, 0.3);
    return Obstacle::Value{sign * (v.norm() - R), sign * v / v.norm()};
  };
  compare("sphere : 0.1; 0.2; 0.3; 0.7",
          [&](const Point<3> &p) { return sphere(p, 0.7, 1.); });
  compare("sphere : 0.1; 0.2; 0.3; -2*1.5",
          [&](const Point<3> &p) { return sphere(p, 3., -1.); });
  const auto cylinder = [](const Point<3> &p, const double R, const double sign) {
    Tensor<1, 3> v = p - Point<3>(0.1, 0.2, 0.3);
    v[1]           = 0.;
    return Obstacle::Value{sign * (v.norm() - R), sign * v / v.norm()};
  };
  compare("cylinder : 0.1; 0.2; 0.3; 0; -2; 0; 0.7",
          [&](const Point<3> &p) { return cylinder(p, 0.7, 1.); });
  compare("cylinder : 0.1; 0.2; 0.3; 0; 2; 0; -3",
          [&](const Point<3> &p) { return cylinder(p, 3., -1.); });
  compare("paraboloid : 0.1; 0.2; 0.3; 0; 0; 5; 2", [](const Point<3> &p) {
    const Tensor<1, 3> v = p - Point<3>(0.1, 0.2, 0.3);
    return Obstacle::Value{v[2] + (v[0] * v[0] + v[1] * v[1]) / 4.,
                           Tensor<1, 3>({v[0] / 2., v[1] / 2., 1.})};
  });
  compare(
    "formula : exp(x)*sin(y) + z^3",
    [](const Point<3> &p) {
      const double e = std::exp(p[0]);
      return Obstacle::Value{
        e * std::sin(p[1]) + std::pow(p[2], 3),
        Tensor<1, 3>({e * std::sin(p[1]), e * std::cos(p[1]), 3. * p[2] * p[2]})};
    },
    1e-9);

  // Surfaces: a stamp with corners and edges, inside and out; a sphere. Files
  // are written by each rank, to a name of its own.
  const auto stamp = read("file : " + shipped("meshes/stamp.stl"));
  struct Known
  {
    Point<3> p;
    double psi;
    Tensor<1, 3> gradient;
  };
  const double r3 = std::sqrt(1. / 3.);
  for (const Known &known :
       {Known{{0.5, 0.5, 0.8}, 0.2, Tensor<1, 3>({0., 0., -1.})},     // facet
        Known{{0.45, 0.5, 1.01}, -0.01, Tensor<1, 3>({0., 0., -1.})}, // inside
        Known{{0.7, 0.7, 1.}, 0., Tensor<1, 3>()},                    // vertex
        Known{{1.2, 1.2, 1.2}, 0.1 / r3, Tensor<1, 3>({r3, r3, r3})}, // beyond a vertex
        Known{{0.5, 1.2, 1.2},
              0.1 * std::sqrt(2.),
              Tensor<1, 3>({0., std::sqrt(0.5), std::sqrt(0.5)})}}) // beyond an edge
    {
      const auto value = stamp->at(known.p);
      out() << "stamp at " << known.p << ": "
            << yes(std::abs(value.psi - known.psi) < 1e-13 &&
                   (known.gradient.norm() == 0.
                      ? std::abs(value.gradient.norm() - 1.) < 1e-13
                      : (value.gradient - known.gradient).norm() < 1e-12))
            << std::endl;
    }

  const unsigned int n = 60;
  const std::string file =
    "sphere." + std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
    ".stl";
  write_sphere(file, 1., n);
  const auto sphere_surface = read("file : " + file);
  write_sphere(file, 1., n, true);
  const auto binary_surface = read("file : " + file);
  // a chord of the angle π/n is (π/n)²/8 below the circle, two of them add
  const double faceting = 2. * std::pow(dealii::numbers::PI / n, 2) / 8.;
  double error = 0., direction = 0., binary = 0.;
  bool inside = true;
  for (const Point<3> &p : places)
    for (const double scale : {1., 0.1})
      {
        const Point<3> q = scale * p;
        const auto value = sphere_surface->at(q);
        error            = std::max(error, std::abs(value.psi - (q.norm() - 1.)));
        direction        = std::max(direction, (value.gradient - q / q.norm()).norm());
        binary = std::max(binary, std::abs(binary_surface->at(q).psi - value.psi));
        inside = inside && (value.psi < 0.) == (q.norm() < 1.);
      }
  out() << "sphere of triangles: distance within its facets "
        << yes(error < faceting && error > 1e-8) << ", normals too "
        << yes(direction < 1.5 * dealii::numbers::PI / n) << ", signs right "
        << yes(inside) << ", the same in single precision from a binary file "
        << yes(binary > 0. && binary < 1e-6) << std::endl;

  // Nodes: a sphere below the bottom, beyond whose reach nodes face away.
  {
    const double height = 0.05, R = 0.04;
    const Problem problem({"Boundary conditions/Prescribed displacement=top : "
                           "0; 0; 0",
                           "Boundary conditions/Contact boundary=bottom",
                           "Boundary conditions/Initial gap=0.25",
                           "Boundary conditions/Obstacle=sphere : 0.5; 0.5; "
                           "-0.05; 0.04"});
    const ContactSurface &surface = *problem.surface;
    double wrong                  = 0.;
    for (const ContactNode &node : surface.nodes())
      {
        const Tensor<1, 3> v = Point<3>(0.5, 0.5, -height) - node.position;
        wrong += std::abs(node.gap - (v.norm() - R + 0.25)) +
                 (node.normal - v / v.norm()).norm() +
                 std::abs(node.tangent1 * node.normal) +
                 std::abs(node.tangent2 * node.normal);
      }
    unsigned int in_reach = 0;
    for (unsigned int i = 0; i < 9; ++i)
      for (unsigned int j = 0; j < 9; ++j)
        in_reach += std::hypot(i / 8. - 0.5, j / 8. - 0.5) < height * std::sqrt(99.);
    out() << "small sphere: " << surface.n_nodes() << " nodes in reach "
          << yes(surface.n_nodes() == in_reach) << ", of "
          << surface.n_nodes() + surface.n_facing_away() << ", gaps and frames exact "
          << yes(wrong < 1e-12) << ", found again by their unknowns " << yes([&]() {
               for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
                 if (surface.node_of(surface.B().dofs().dofs()[i]) != i)
                   return false;
               return surface.node_of(1000000000) == -1;
             }())
          << std::endl;
  }

  // Two contact boundaries share an edge: its nodes are of the first one, and those
  // beside it have the area and the gap that it has in the other.
  for (const std::string order : {"bottom | right", "right | bottom"})
    {
      const Problem problem({"Boundary conditions/Prescribed displacement=top : 0; 0; 0",
                             "Boundary conditions/Contact boundary=" + order,
                             "Boundary conditions/Initial gap=0.1 | 0.2 + x",
                             "Friction/Law=coulomb | given",
                             "Friction/Slip stress=7 | 8"});
      std::array<unsigned int, 2> nodes{};
      std::array<double, 2> area{};
      double wrong = 0.;
      for (Eigen::Index i = 0; i < problem.surface->n_nodes(); ++i)
        {
          const ContactNode &node  = problem.surface->nodes()[i];
          const unsigned int b     = node.boundary;
          const bool is_bottom     = (order[0] == 'b') == (b == 0);
          const qp::SlipBound &all = problem.surface->slip_bound();
          ++nodes[b];
          area[b] += node.area;
          wrong += (node.normal - (is_bottom ? Tensor<1, 3>({0., 0., -1.})
                                             : Tensor<1, 3>({1., 0., 0.})))
                     .norm() +
                   std::abs(node.gap - (b == 0 ? 0.1 : 0.2 + node.center[0])) +
                   std::abs(all.coefficient()(i) - (b == 0 ? 0.3 : 0.)) +
                   std::abs(all.constant()(i) - (b == 0 ? 0. : 8. * node.area));
        }
      out() << order << ": nodes " << nodes[0] << " and " << nodes[1] << ", areas "
            << area[0] << " and " << area[1] << ", data of their boundary "
            << yes(wrong < 1e-12) << ", mixed "
            << yes(problem.surface->slip_bound().is_mixed()) << std::endl;
    }
}
