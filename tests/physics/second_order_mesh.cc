// Meshes of hexahedra with 20 and 27 nodes. A block whose inner edges and faces
// are curved, from files of every format, passes the patch test: triquadratic
// elements of any shape have what is linear. Half a ball from a file is the one
// that the program makes itself, and keeps its shape when it is refined.

#include "second_order_file.h"
#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/coarse_mesh.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>

using namespace stiction;

namespace
{
  // Of the body in the shape that the stiffness is integrated in.
  double volume(const Body &body)
  {
    dealii::FEValues<3> values(body.mapping(), body.dof_handler().get_fe(),
                               dealii::QGauss<3>(4), dealii::update_JxW_values);
    double sum = 0.;
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          values.reinit(cell);
          for (const unsigned int q : values.quadrature_point_indices())
            sum += values.JxW(q);
        }
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }

  const Body &body(const Run &run) { return run.problem->elasticity().body(); }

  // Pressed onto the foundation and sheared by less than what friction holds;
  // u = (γ z, 0, -ε z).
  void patch_test(const std::string &file, const std::string &refinement)
  {
    constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4, gamma = 3e-5;
    const double lame = E * nu / ((1. + nu) * (1. - 2. * nu));
    const double G    = E / (2. * (1. + nu));
    const double sxx = -lame * epsilon, sxz = G * gamma;
    const bool is_vtk              = file.substr(file.size() - 3) == "vtk";
    std::vector<std::string> names = {"x0", "x1", "y0", "y1", "z0", "z1"};
    if (is_vtk)
      names = {"1", "2", "3", "4", "5", "6"};
    const Run run(
      shipped("brick.prm"),
      {"Geometry/Table 1 level=0", "Geometry/Type=file", "Geometry/Mesh file=" + file,
       "Geometry/Element degree=2", refinement, "Material/Young's modulus=" + exact(E),
       "Material/Poisson ratio=" + exact(nu), "Friction/Law=coulomb",
       "Friction/Coefficient=0.25", "Contact solver/Method=newton",
       "Contact solver/Tolerance=1e-11",
       "Boundary conditions/Prescribed displacement=" + names[5] + " : " +
         three(gamma, 0., -epsilon),
       "Boundary conditions/Traction=" + names[0] + " : " + three(-sxx, 0, -sxz) + " | " +
         names[1] + " : " + three(sxx, 0, sxz) + " | " + names[2] + " : " +
         three(0, -sxx, 0) + " | " + names[3] + " : " + three(0, sxx, 0),
       "Boundary conditions/Contact boundary=" + names[4]});

    double error = 0.;
    for (const auto &node : body(run).locally_owned_nodes())
      {
        if (body(run).is_hanging(node.dofs[0]))
          continue;
        const double z       = node.position[2];
        const double exact[] = {gamma * z, 0., -epsilon * z};
        for (unsigned int c = 0; c < 3; ++c)
          error = std::max(
            error, std::abs(run.problem->state().u(node.dofs[c]) - exact[c]) / epsilon);
      }
    error              = dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);
    const double force = run.summary()["contact"]["force_on_body"][2].get<double>() /
                         ((lame + 2. * G) * epsilon);
    out() << file << ", " << refinement << ": certified " << yes(run.converged)
          << ", displacement exact to 1e-8 " << yes(error < 1e-8)
          << ", force over that of a unit face " << force << ", volume "
          << volume(body(run)) << std::endl;
  }

  std::vector<std::string> ball(const std::vector<std::string> &geometry)
  {
    std::vector<std::string> settings = {
      "Contact solver/Method=newton", "Contact solver/Tolerance=1e-11",
      "Boundary conditions/Prescribed displacement=flat : 0; 0; -2e-2",
      "Output/Write solution=false"};
    settings.insert(settings.end(), geometry.begin(), geometry.end());
    return settings;
  }

  double relative_difference(const double a, const double b)
  {
    return std::abs(a / b - 1.);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  {
    dealii::Triangulation<3> block;
    dealii::GridGenerator::subdivided_hyper_cube(block, 2);
    for (const auto &face : block.active_face_iterators())
      if (face->at_boundary())
        for (unsigned int d = 0; d < 3; ++d)
          if (std::abs(face->center()[d] - .5) > .49)
            face->set_boundary_id(2 * d + (face->center()[d] > .5 ? 1 : 0));
    // the faces of the block remain where they are
    const SecondOrderFile file(
      block, {{"x0", 0}, {"x1", 1}, {"y0", 2}, {"y1", 3}, {"z0", 4}, {"z1", 5}},
      dealii::MappingQ<3>(1), [](dealii::Point<3> p) {
        const dealii::Point<3> q = p;
        for (unsigned int d = 0; d < 3; ++d)
          p[d] += (.3 + .1 * d) * q[d] * (1. - q[d]) *
                  std::sin(2. + 3. * q[(d + 1) % 3] + 5. * q[(d + 2) % 3]);
        return p;
      });
    for (const unsigned int n : {20, 27})
      for (const std::string kind : {"msh", "inp", "vtk"})
        {
          const std::string name = "block_" + std::to_string(n) + '.' + kind;
          file.write(name, n);
          patch_test(name, "Geometry/Global refinement=0");
        }
    patch_test("block_27.msh", "Geometry/Global refinement=1");
    patch_test("block_20.inp", "Geometry/Contact refinement=1");
  }

  {
    GeometryParameters geometry;
    geometry.type              = "half ball";
    geometry.radius            = 1.;
    geometry.element_degree    = 2;
    geometry.global_refinement = 1;
    const Body own(geometry, MPI_COMM_SELF);
    SecondOrderFile(own.triangulation(), {{"curved", 0}, {"flat", 1}}, own.mapping())
      .write("ball.msh", 27);
  }
  const Run own(shipped("half_ball.prm"),
                ball({"Geometry/Global refinement=1", "Geometry/Element degree=2"}));
  const auto from_file = [&](const std::string &refinement) {
    return Run(
      shipped("half_ball.prm"),
      ball({"Geometry/Type=file", "Geometry/Mesh file=ball.msh",
            "Geometry/Global refinement=0", "Geometry/Element degree=2", refinement}));
  };
  const Run same      = from_file("Geometry/Global refinement=0");
  const auto pressure = [](const Run &run) {
    return run.summary()["contact"]["max_pressure"].get<double>();
  };
  const auto force = [](const Run &run) {
    return run.summary()["contact"]["force_on_body"][2].get<double>();
  };
  out() << "half a ball as the program makes it: certified "
        << yes(own.converged && same.converged) << ", force to 1e-9 "
        << yes(relative_difference(force(same), force(own)) < 1e-9)
        << ", largest pressure to 1e-9 "
        << yes(relative_difference(pressure(same), pressure(own)) < 1e-9)
        << ", volume to 1e-12 "
        << yes(relative_difference(volume(body(same)), volume(body(own))) < 1e-12)
        << ", within 1e-3 of the ball "
        << yes(relative_difference(volume(body(own)), 2. / 3. * dealii::numbers::PI) <
               1e-3)
        << std::endl;

  const Run refined = from_file("Geometry/Contact refinement=1");
  out() << "with smaller cells at the contact boundary: certified "
        << yes(refined.converged) << ", hanging nodes "
        << yes(body(refined).n_hanging_nodes() > 0)
        << ", the volume is the same to 1e-12 "
        << yes(relative_difference(volume(body(refined)), volume(body(same))) < 1e-12)
        << std::endl;

  std::vector<double> errors;
  for (const unsigned int n : {0, 1, 2})
    {
      GeometryParameters geometry;
      geometry.type              = "file";
      geometry.mesh_file         = "ball.msh";
      geometry.global_refinement = n;
      errors.push_back(
        relative_difference(volume(Body(geometry, MPI_COMM_WORLD)), volume(body(same))));
    }
  out() << "trilinear elements refined along the curved cells: errors of the "
           "volume fall fourfold "
        << yes(errors[0] > 3.5 * errors[1] && errors[1] > 3.5 * errors[2]) << std::endl;
}
