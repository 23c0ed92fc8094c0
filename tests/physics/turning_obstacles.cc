// Obstacles that turn. Exact: to turn the foundation about its normal is to turn the
// support the other way; where all sticks, contact nodes turn with it; where all
// slips, friction is F times the pressure, along the motion of the surface, and the
// torque of a roller is F N R; a roller that touches a line of nodes is a cylinder that
// is displaced there. All kinds of methods agree; energies balance; round and nearly
// round obstacles are taken, others not.

#include "tests.h"

#include <stiction/base/errors.h>
#include <stiction/contact/interface/contact_operator.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

using namespace stiction;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const std::string rotation = "Boundary conditions/Obstacle rotation=";

  const Settings block = {"Geometry/Table 1 level=0",     "Geometry/Lengths=2,1,1",
                          "Geometry/Subdivisions=4,2,2",  "Geometry/Global refinement=1",
                          "Material/Young's modulus=1e9", "Boundary conditions/Traction=",
                          "Friction/Law=coulomb",         "Friction/Coefficient=0.3",
                          "Contact solver/Tolerance=1e-9"};

  Run turn(const std::string &angle, const Settings &settings)
  {
    return Run(shipped("brick.prm"), block + settings + Settings{rotation + angle});
  }

  nlohmann::json boundary(const Run &run)
  {
    return run.summary()["contact"]["boundaries"][0];
  }

  double number(const nlohmann::json &json) { return json.get<double>(); }

  // The force on the body at a contact node, tangential to the contact surface.
  Tensor<1, 3> friction(const Run &run, const Eigen::Index i)
  {
    Eigen::Vector3d lambda = at_node(run.problem->state().lambda, i);
    lambda(0)              = 0.;
    const Eigen::Vector3d force =
      run.problem->contact_surface().nodes()[i].force_to_cartesian(-lambda);
    return Tensor<1, 3>({force(0), force(1), force(2)});
  }

  // A block on the foundation, about an axis that meets it at no node.
  void twist()
  {
    const std::string axis = "0.9; 0.6; 0; 0; 0; 2; ";
    const Tensor<1, 3> a({0., 0., 1.});
    const Point<3> p(0.9, 0.6, 0.);
    const std::string pressed = "Boundary conditions/Prescribed displacement=top : ";
    for (const std::string method : {"newton", "gauss seidel", "newton multigrid"})
      {
        const Settings down = {pressed + "0; 0; -1e-3",
                               "Contact solver/Method=" + method};
        const Run some      = turn(axis + "3e-4", down);
        const Run support =
          turn("0; 0; 0; 0; 0; 1; 0",
               down + Settings{pressed + "3e-4*(y-0.6); -3e-4*(x-0.9); -1e-3"});
        out() << "twist, " << method << ": certified "
              << yes(some.converged && support.converged) << ", slips and sticks "
              << yes(some.summary()["contact"]["slip"] > 0 &&
                     some.summary()["contact"]["stick"] > 0)
              << ", the forces of the support turned the other way to 1e-7 "
              << yes(distance(some, support) < 1e-7);

        const Run none =
          turn(axis + "1e-4*t", down + Settings{"Friction/Coefficient=50"});
        const ContactSurface &surface = none.problem->contact_surface();
        const Eigen::VectorXd moved   = surface.B().apply(none.problem->state().u);
        double error                  = 0.;
        for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
          {
            const ContactNode &node = surface.nodes()[i];
            const Tensor<1, 3> U    = 1e-4 * cross_product_3d(a, node.position - p);
            const Eigen::Vector3d w =
              at_node(moved, i) - node.displacement_to_local({U[0], U[1], U[2]});
            error = std::max(error, w.tail<2>().norm());
          }
        const nlohmann::json moment = boundary(none)["moment"],
                             force  = boundary(none)["force_on_body"];
        const double torque =
          number(moment[2]) - p[0] * number(force[1]) + p[1] * number(force[0]);
        out() << ", all sticks: certified "
              << yes(none.converged && none.summary()["contact"]["slip"] == 0)
              << ", turns with it to 1e-8 " << yes(error < 1e-8 * 1e-4)
              << ", torque drags along " << yes(torque > 0.)
              << " and is that of the forces "
              << yes(std::abs(number(boundary(none)["torque"]) / torque - 1.) < 1e-10);

        const Run all = turn(axis + "1e6", down);
        error         = 0.;
        for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
          {
            const Tensor<1, 3> U = cross_product_3d(a, surface.nodes()[i].position - p);
            const double g       = 0.3 * all.problem->state().lambda(i);
            error = std::max(error, (friction(all, i) - g / U.norm() * U).norm() / g);
          }
        out() << ", all slips: certified " << yes(all.converged)
              << ", friction along the motion of the surface to 1e-7 "
              << yes(error < 1e-7) << std::endl;
      }
  }

  // A roller of radius 5 along y, at a distance from the middle of the top.
  void roll()
  {
    const auto press = [](const double gap, const std::string &force,
                          const std::string &angle, const std::string &displacement) {
      const std::string axis = "1; 7; " + exact(6. + gap) + "; 0; 1; 0; ";
      return turn(axis + angle,
                  {"Boundary conditions/Prescribed displacement=bottom : 0; 0; 0",
                   "Boundary conditions/Contact boundary=top",
                   "Boundary conditions/Obstacle=cylinder : " + axis + "5",
                   "Boundary conditions/Obstacle force=0; 0; -" + force,
                   "Boundary conditions/Obstacle displacement=" + displacement});
    };
    const Run line      = press(0., "1e3", "1e-7", "0; 0; 0"),
              displaced = press(0., "1e3", "0", "-5e-7; 0; 0");
    out() << "roller on a line: certified " << yes(line.converged && displaced.converged)
          << ", touches one line of nodes "
          << yes(line.summary()["contact"]["closed"] == 5) << ", with friction "
          << yes(number(boundary(line)["tangential_force"][0]) < -30.)
          << ", the forces of R theta to 1e-7 " << yes(distance(line, displaced) < 1e-7)
          << std::endl;

    const Run slipping = press(0.1, "2e7", "-1e3", "0; 0; 0");
    // turned backwards, it drags the body along
    const double torque = -0.3 * 5. * number(boundary(slipping)["normal_force"]);
    out() << "roller that comes down and slips: certified " << yes(slipping.converged)
          << ", touches several lines "
          << yes(slipping.summary()["contact"]["closed"] > 5) << ", friction along x "
          << yes(number(boundary(slipping)["tangential_force"][0]) > 0.)
          << ", torque F N R to 1e-7 "
          << yes(std::abs(number(boundary(slipping)["torque"]) / torque - 1.) < 1e-7)
          << std::endl;
  }

  // The shipped roller, coarser: all methods.
  void agree()
  {
    const Settings coarse = {"Geometry/Global refinement=1",
                             "Contact solver/Tolerance=1e-9"};
    const Run first(shipped("roller.prm"), coarse);
    const auto &contact   = first.summary()["contact"];
    const auto &energy    = first.summary()["energy"];
    const double obstacle = -first.problem->state().lambda.dot(
      first.problem->contact_surface().motion().offset(first.problem->state().distances));
    out() << "shipped roller: slips and sticks "
          << yes(contact["slip"] > 0 && contact["stick"] > 0)
          << ", energies balance to 1e-8 "
          << yes(std::abs(2. * number(energy["strain"]) +
                          number(energy["friction_dissipation"]) - obstacle) <
                 1e-8 * obstacle);
    bool are_certified = first.converged;
    double largest     = 0.;
    for (const Method &method : all_methods())
      {
        const Run run(shipped("roller.prm"), coarse + method.settings);
        are_certified = are_certified && run.converged;
        largest       = std::max(largest, distance(run, first));
      }
    out() << ", all methods: certified " << yes(are_certified)
          << ", the same forces to 1e-6 " << yes(largest < 1e-6) << std::endl;
  }
  // The lateral surface of a prism around the cylinder of roll().
  void write_prism(const std::string &name, const unsigned int n_sides)
  {
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ofstream file(name);
        file << "solid prism\n";
        for (unsigned int k = 0; k < n_sides; ++k)
          {
            const auto corner = [&](const unsigned int side, const double y) {
              const double angle = (2. * side - 1.) * dealii::numbers::PI / n_sides;
              const double R     = 5. / std::cos(dealii::numbers::PI / n_sides);
              file << "vertex " << 1. + R * std::sin(angle) << ' ' << y << ' '
                   << 6. - R * std::cos(angle) << '\n';
            };
            const auto triangle = [&](const std::array<bool, 6> &which) {
              file << "facet normal 0 0 0\nouter loop\n";
              for (unsigned int v = 0; v < 3; ++v)
                corner(k + which[2 * v], which[2 * v + 1] ? 9. : -9.);
              file << "endloop\nendfacet\n";
            };
            triangle({{false, false, true, true, true, false}});
            triangle({{false, false, false, true, true, true}});
          }
        file << "endsolid prism\n";
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }

  void refuse()
  {
    write_prism("round.stl", 32);
    write_prism("square.stl", 4);
    const std::vector<std::array<std::string, 3>> obstacles = {
      {{"a plane about its normal", "plane : 0; 0; 1; 0.1; 0; -1", "7;7;7;-0.1;0;1"}},
      {{"a plane about another axis", "plane : 0; 0; 1; 0; 0; -1", "7;7;7;0.2;0;1"}},
      {{"a sphere", "sphere : 1; 0.5; 6; 5", "1;0.5;6;1;2;3"}},
      {{"a sphere, beside its centre", "sphere : 1; 0.5; 6; 5", "1;2;6;1;2;3"}},
      {{"a paraboloid", "paraboloid : 1; 0.5; 1; 0; 0; -1; 3", "1;0.5;7;0;0;1"}},
      {{"a cylinder across", "cylinder : 1; 0; 6; 0; 1; 0; 5", "1;0;6;1;0;0"}},
      {{"a formula", "formula : sqrt((x-1)^2 + (z-6)^2) - 5", "1;0;6;0;1;0"}},
      {{"a prism of 32 sides", "file : round.stl", "1;0;6;0;1;0"}},
      {{"a prism of 4 sides", "file : square.stl", "1;0;6;0;1;0"}}};
    for (const auto &[name, obstacle, axis] : obstacles)
      {
        std::string answer = "taken";
        try
          {
            turn(axis + ";1e-6",
                 {"Boundary conditions/Prescribed displacement=bottom : 0; 0; 0",
                  "Boundary conditions/Contact boundary=top",
                  "Boundary conditions/Obstacle=" + obstacle});
          }
        catch (const InputError &error)
          {
            const bool is_axis =
              std::string(error.what()).find("axis of revolution") != std::string::npos;
            answer = is_axis ? "refused" : error.what();
          }
        out() << name << ": " << answer << std::endl;
      }
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  twist();
  roll();
  agree();
  refuse();
}
