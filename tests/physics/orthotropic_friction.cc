// Orthotropic friction, all methods. Patch tests with an exact solution: a
// brick pressed down and sheared, its contact force on the ellipse and its slip
// along the ellipse's normal. Equal axes are the disc to the last bit. On the
// reference brick all methods agree, and where it slips the force is on the
// ellipse and the slip normal to it.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/numbers.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  constexpr double E = 2e11, nu = 0.3, epsilon = 1e-4, height = 1.;
  constexpr double first_axis = 0.3, second_axis = 0.12, axis_angle = 0.4;

  // The shear γ under the displacement U of the top in principal directions,
  // with the ellipse of shear tractions a: γ = U/H inside, otherwise on the
  // ellipse, with the slip U − γH = μ(γ_i/a_i²) along its normal.
  Eigen::Vector2d exact_shear(const Eigen::Vector2d &U, const Eigen::Vector2d &a,
                              const double G)
  {
    const auto shear = [&](const double mu) -> Eigen::Vector2d {
      return U.array() / (height + mu / a.array().square());
    };
    const auto excess = [&](const double mu) {
      return (G * shear(mu)).cwiseQuotient(a).norm() - 1.;
    };
    if (excess(0.) <= 0.)
      return shear(0.);
    double low = 0., high = height * a.squaredNorm();
    while (excess(high) > 0.)
      high *= 2.;
    for (unsigned int k = 0; k < 200; ++k)
      (excess(0.5 * (low + high)) > 0. ? low : high) = 0.5 * (low + high);
    return shear(0.5 * (low + high));
  }

  // Whether the patch test comes out exactly.
  bool patch(const Method &method, const std::string &law, const bool sticks,
             const double degrees)
  {
    const double lame = E * nu / ((1. + nu) * (1. - 2. * nu));
    const double G    = E / (2. * (1. + nu));
    const double p    = (lame + 2. * G) * epsilon;
    const Eigen::Vector2d axes(first_axis, second_axis);
    Eigen::Matrix2d principal; // columns
    principal << std::cos(axis_angle), -std::sin(axis_angle), std::sin(axis_angle),
      std::cos(axis_angle);

    const double angle = degrees / 180. * dealii::numbers::PI;
    const Eigen::Vector2d U =
      (sticks ? 1e-5 : 2e-4) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d gamma =
      principal * exact_shear(principal.transpose() * U, p * axes, G);
    const Eigen::Vector2d slip = U - height * gamma;

    const double sxx = -lame * epsilon;
    const double sxz = G * gamma(0), syz = G * gamma(1);
    const std::string coefficients = exact(first_axis) + ";" + exact(second_axis);
    const Run run(
      shipped("brick.prm"),
      Settings{
        "Geometry/Table 1 level=0", "Geometry/Lengths=1.5,1.2,1",
        "Geometry/Subdivisions=3,2,2", "Geometry/Global refinement=1",
        "Material/Young's modulus=" + exact(E), "Material/Poisson ratio=" + exact(nu),
        "Boundary conditions/Prescribed displacement=5 : " +
          three(U(0), U(1), -epsilon * height),
        "Boundary conditions/Traction=0 : " + three(-sxx, 0, -sxz) +
          " | 1 : " + three(sxx, 0, sxz) + " | 2 : " + three(0, -sxx, -syz) +
          " | 3 : " + three(0, sxx, syz),
        "Friction/Law=" + law, "Friction/Coefficient=" + coefficients,
        "Friction/Slip stress=" + exact(first_axis * p) + ";" + exact(second_axis * p),
        // its normal component does not count
        "Friction/First direction=" +
          three(std::cos(axis_angle), std::sin(axis_angle), 0.3),
        "Contact solver/Tolerance=1e-10"} +
        method.settings);

    const auto &u = run.problem->state().u;
    double error  = 0.;
    for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
      {
        const double z         = node.position[2];
        const double exact_u[] = {gamma(0) * z + slip(0), gamma(1) * z + slip(1),
                                  -epsilon * z};
        for (unsigned int c = 0; c < 3; ++c)
          error = std::max(error, std::abs(u(node.dofs[c]) - exact_u[c]) / U.norm());
      }
    error = dealii::Utilities::MPI::max(error, MPI_COMM_WORLD);

    const auto &surface     = run.problem->contact_surface();
    const auto statuses     = run.problem->node_statuses();
    unsigned int n_statuses = 0;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node = surface.nodes()[i];
        const Eigen::Vector3d force =
          node.force_to_cartesian(at_node(run.problem->state().lambda, i)) / node.area;
        error = std::max(error, (force - Eigen::Vector3d(sxz, syz, -p)).norm() / p);
        n_statuses += statuses[i].normal == NormalStatus::closed &&
                          statuses[i].tangential ==
                            (sticks ? TangentialStatus::stick : TangentialStatus::slip)
                        ? 1
                        : 0;
      }

    // the summary has the force on the body
    const auto &contact = run.summary()["contact"]["tangential_force"];
    const double area   = 1.5 * 1.2;
    error             = std::max(error, std::hypot(contact[0].get<double>() + sxz * area,
                                                   contact[1].get<double>() + syz * area,
                                                   contact[2].get<double>()) /
                                          (p * area));
    const double work = area * (sxz * slip(0) + syz * slip(1));
    error             = std::max(
                  error,
                  std::abs(run.summary()["energy"]["friction_dissipation"].get<double>() - work) /
                    (area * p * U.norm()));
    return run.converged && n_statuses == surface.n_nodes() && error < 1e-8 &&
           (slip.norm() < 1e-12) == sticks;
  }

  // ‖force on the ellipse − 1‖ and the slip's part off the ellipse's normal,
  // relative to the largest slip, at slipping nodes.
  double off_ellipse(const Run &run, const double F1, const double F2)
  {
    const auto &surface = run.problem->contact_surface();
    const auto statuses = run.problem->node_statuses();
    double largest_slip = 0., error = 0., off_normal = 0.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        if (statuses[i].tangential != TangentialStatus::slip)
          continue;
        const ContactNode &node = surface.nodes()[i];
        const Eigen::Vector3d force =
          node.axes() * node.force_to_cartesian(at_node(run.problem->state().lambda, i));
        const Eigen::Vector3d r = at_node(run.problem->certificate().gradient(), i);
        const Eigen::Vector3d slip =
          node.axes() * node.displacement_to_cartesian({0., -r(1), -r(2)});
        const Eigen::Vector2d on(force(1) / F1, force(2) / F2);
        const Eigen::Vector2d normal =
          Eigen::Vector2d(on(0) / F1, on(1) / F2).normalized();
        const Eigen::Vector2d slip_t = slip.tail<2>();
        largest_slip                 = std::max(largest_slip, slip_t.norm());
        error =
          std::max(error, std::abs(on.norm() - force(0)) /
                            surface.slip_bound().at(run.problem->state().lambda).mean());
        off_normal = std::max(
          off_normal, (slip_t - std::max(slip_t.dot(normal), 0.) * normal).norm());
      }
    return std::max(error, off_normal / largest_slip);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::vector<Method> methods = all_methods();
  methods.push_back(
    {"qpq",
     {"Contact solver/Method=gauss seidel", "Contact solver/Disc solver=spectral"}});

  for (const Method &method : methods)
    for (const std::string law : {"given", "coulomb"})
      if (law == "coulomb" || method.solves_given)
        {
          out() << method.name << ", " << law << ": exact where it sticks "
                << yes(patch(method, law, true, 70.)) << ", where it slips";
          for (const double degrees : {55., 137.})
            out() << " at " << degrees << " degrees "
                  << yes(patch(method, law, false, degrees));
          out() << std::endl;
        }

  for (const std::string name : {"newton", "newton multigrid"})
    {
      const Settings settings = {"Contact solver/Method=" + name,
                                 "Geometry/Table 1 level=1"};
      const Run disc(shipped("brick.prm"),
                     settings + Settings{"Friction/Coefficient=0.3"});
      const Run ellipse(shipped("brick.prm"),
                        settings + Settings{"Friction/Coefficient=0.3; 0.3"});
      out() << name << ": equal axes are the disc to the last bit "
            << yes(disc.problem->state().lambda == ellipse.problem->state().lambda)
            << std::endl;
    }

  const Settings brick = {"Geometry/Table 1 level=2", "Friction/Coefficient=0.4; 0.2",
                          "Friction/First direction=2; 1; 0",
                          "Contact solver/Tolerance=1e-9"};
  const Run newton(shipped("brick.prm"), brick + methods.front().settings);
  const Run disc(shipped("brick.prm"),
                 brick + Settings{"Friction/Coefficient=0.4"} + methods.front().settings);
  out() << "not the disc's answer " << yes(distance(newton, disc) > 1e-2) << std::endl;
  for (const Method &method : methods)
    {
      const Run run(shipped("brick.prm"), brick + method.settings);
      out() << method.name << ": certified " << yes(run.converged) << ", agrees to 1e-6 "
            << yes(distance(run, newton) < 1e-6)
            << ", force on the ellipse and slip normal to it to 1e-6 "
            << yes(off_ellipse(run, 0.4, 0.2) < 1e-6) << std::endl;
    }
}
