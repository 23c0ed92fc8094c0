// What nodes do along the normal and across it, where both are known: a brick
// on a face with a slip stress is sheared while it is pressed on, just touches
// or is lifted off, and sticks, slides, or is held by exactly the slip stress.
// The exact solution is linear in space. Friction is the same whether the face
// touches or not, what rounding decides is undecided, and counts and statuses
// say so for every method. With Coulomb's law or none the same face has no
// friction unless it is pressed.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>

using namespace stiction;

namespace
{
  constexpr double E = 2e11, nu = 0.3, slip_stress = 5e6;
  constexpr double G    = E / (2. * (1. + nu));
  constexpr double lame = E * nu / ((1. + nu) * (1. - 2. * nu));
  constexpr double cx = 0.8, cy = 0.6; // direction of the shear

  struct Case
  {
    std::string name;
    double lift; // of the top, m
    NormalStatus expected;
  };

  const std::vector<Case> cases = {{"pressed", -1e-4, NormalStatus::closed},
                                   {"touching", 0., NormalStatus::undecided},
                                   {"lifted", 1e-4, NormalStatus::open}};

  struct Ending
  {
    std::string name;
    double shear; // over the slip stress
    double slip;  // m
    TangentialStatus expected;
  };

  const std::vector<Ending> endings = {
    {"sticks", 0.7, 0., TangentialStatus::stick},
    {"slides", 1., 1e-4, TangentialStatus::slip},
    {"is just held", 1., 0., TangentialStatus::undecided}};

  // Both statuses of every node, and the counts of summary.json.
  bool all_nodes_are(const Run &run, const NormalStatus normal,
                     const TangentialStatus tangential)
  {
    for (const NodeStatus status : run.problem->node_statuses())
      if (status.normal != normal || status.tangential != tangential)
        return false;
    const auto &contact = run.summary()["contact"];
    const auto m        = run.problem->contact_surface().n_nodes();
    const auto is       = [&](const char *entry, const bool all) {
      return contact[entry] == (all ? m : 0) &&
             contact["boundaries"][0][entry] == (all ? m : 0);
    };
    return is("open", normal == NormalStatus::open) &&
           is("closed", normal == NormalStatus::closed) &&
           is("undecided_normal", normal == NormalStatus::undecided) &&
           is("slip", tangential == TangentialStatus::slip) &&
           is("stick", tangential == TangentialStatus::stick) &&
           is("undecided_tangential", tangential == TangentialStatus::undecided) &&
           is("undecided", normal == NormalStatus::undecided ||
                             tangential == TangentialStatus::undecided);
  }

  // All that come to an end: at a switch ADMM converges too slowly.
  std::vector<Method> methods(const std::string &law)
  {
    std::vector<Method> chosen;
    for (const Method &method : all_methods())
      if (method.name != "admm" && (method.solves_given || law == "coulomb"))
        chosen.push_back(method);
    return chosen;
  }

  Settings brick(const std::string &law)
  {
    return {"Geometry/Table 1 level=0",
            "Geometry/Lengths=1.5,1.2,1",
            "Geometry/Subdivisions=2,1,1",
            "Geometry/Global refinement=1",
            "Material/Young's modulus=" + exact(E),
            "Material/Poisson ratio=" + exact(nu),
            "Friction/Law=" + law,
            "Friction/Coefficient=0.3",
            "Friction/Slip stress=" + exact(slip_stress)};
  }

  // The largest error of the displacement over slip and lift, and of the
  // contact forces over the slip stress.
  double error(const Run &run, const Case &c, const Ending &ending)
  {
    const double gamma = ending.shear * slip_stress / G;
    const double p     = c.lift < 0. ? -(lame + 2. * G) * c.lift : 0.;
    const auto &u      = run.problem->state().u;
    double largest     = 0.;
    for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
      {
        const double z         = node.position[2];
        const double exact_u[] = {cx * (gamma * z + ending.slip),
                                  cy * (gamma * z + ending.slip),
                                  c.lift < 0. ? c.lift * z : c.lift};
        for (unsigned int k = 0; k < 3; ++k)
          largest = std::max(largest, std::abs(u(node.dofs[k]) - exact_u[k]) / 1e-4);
      }
    largest = dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);

    const double t = ending.shear * slip_stress;
    for (std::size_t i = 0; i < run.problem->node_statuses().size(); ++i)
      {
        const ContactNode &node = run.problem->contact_surface().nodes()[i];
        const Eigen::Vector3d force =
          node.force_to_cartesian(at_node(run.problem->state().lambda, i)) / node.area;
        largest = std::max(largest, (force - Eigen::Vector3d(t * cx, t * cy, -p)).norm() /
                                      slip_stress);
      }
    return largest;
  }

  void given_friction(const Case &c, const Ending &ending)
  {
    const double gamma = ending.shear * slip_stress / G;
    const double top   = gamma + ending.slip;
    const double sxx   = c.lift < 0. ? lame * c.lift : 0.;
    const double sxz = G * gamma * cx, syz = G * gamma * cy;
    for (const Method &method : methods("given"))
      {
        const Run run(
          shipped("brick.prm"),
          brick("given") + method.settings +
            Settings{"Boundary conditions/Prescribed displacement=5 : " +
                       three(top * cx, top * cy, c.lift),
                     "Boundary conditions/Traction=0 : " + three(-sxx, 0, -sxz) +
                       " | 1 : " + three(sxx, 0, sxz) + " | 2 : " + three(0, -sxx, -syz) +
                       " | 3 : " + three(0, sxx, syz)});
        out() << c.name << ", " << ending.name << ", " << method.name << ": certified "
              << yes(run.converged) << ", exact to 1e-6 "
              << yes(error(run, c, ending) < 1e-6) << ", status of all nodes "
              << yes(all_nodes_are(run, c.expected, ending.expected)) << std::endl;
      }
  }

  // The top is drawn so far along x that a pressed face slides; nothing holds
  // one that is not pressed, in a body that is stretched.
  void friction_by_pressure(const Case &c, const std::string &law)
  {
    const bool is_pressed           = c.lift < 0.;
    const double p                  = is_pressed ? -(lame + 2. * G) * c.lift : 0.;
    const double stretch            = is_pressed ? 0. : 1e-4;
    const double sxx                = is_pressed ? lame * c.lift : E * stretch;
    const double syy                = is_pressed ? sxx : 0.;
    const double sxz                = law == "coulomb" ? 0.3 * p : 0.;
    const TangentialStatus expected = law == "frictionless" || c.lift > 0.
                                        ? TangentialStatus::none
                                      : is_pressed ? TangentialStatus::slip
                                                   : TangentialStatus::undecided;
    for (const Method &method : methods(law))
      {
        const Run run(
          shipped("brick.prm"),
          brick(law) + method.settings +
            Settings{"Boundary conditions/Prescribed displacement=5 : 1e-3+" +
                       exact(stretch) + "*x; " + exact(-nu * stretch) + "*y; " +
                       exact(c.lift - nu * stretch),
                     "Boundary conditions/Traction=0 : " + three(-sxx, 0, -sxz) +
                       " | 1 : " + three(sxx, 0, sxz) + " | 2 : " + three(0, -syy, 0) +
                       " | 3 : " + three(0, syy, 0)});
        out() << c.name << ", " << law << ", " << method.name << ": certified "
              << yes(run.converged) << ", status of all nodes "
              << yes(all_nodes_are(run, c.expected, expected)) << std::endl;
      }
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Case &c : cases)
    {
      for (const Ending &ending : endings)
        given_friction(c, ending);
      for (const std::string law : {"coulomb", "frictionless"})
        friction_by_pressure(c, law);
    }
}
