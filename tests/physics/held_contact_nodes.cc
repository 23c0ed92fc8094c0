// Contact nodes of which some displacement components are prescribed. A brick
// with one or two planes of symmetry is solved whole and as its half or quarter
// with rollers on these planes: the same forces, halved in the planes, with
// friction, discs and ellipses, by all methods. A roller that is moved, and one
// across an inclined principal direction, are certified by all methods alike.

#include "tests.h"

#include <stiction/contact/interface/state.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  Settings brick(const int nx, const int ny, const std::string &prescribed)
  {
    return {"Geometry/Table 1 level=0",
            "Geometry/Lengths=" + std::to_string(nx) + "," + std::to_string(ny) + ",1",
            "Geometry/Subdivisions=" + std::to_string(2 * nx) + "," +
              std::to_string(2 * ny) + ",2",
            "Geometry/Global refinement=1",
            "Boundary conditions/Prescribed displacement=" + prescribed,
            "Contact solver/Tolerance=1e-11"};
  }

  Eigen::Vector3d force(const Run &run, const Eigen::Index i)
  {
    return run.problem->contact_surface().nodes()[i].force_to_cartesian(
      at_node(run.problem->state().lambda, i));
  }

  // How far the forces of a part are from those of the whole. On the planes of
  // symmetry x = 1 and (of a quarter) y = 1 half the forces act on the part,
  // and the tangential forces across it cancel.
  double difference(const Run &part, const Run &whole, const bool is_quarter)
  {
    const auto &nodes = part.problem->contact_surface().nodes();
    const auto &all   = whole.problem->contact_surface().nodes();
    double error = 0., largest = 0.;
    std::size_t n_compared = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < all.size(); ++j)
        if (nodes[i].position.distance(all[j].position) < 1e-9)
          {
            Eigen::Vector3d expected = force(whole, static_cast<Eigen::Index>(j));
            largest                  = std::max(largest, expected.norm());
            if (nodes[i].position[0] > 1. - 1e-9)
              expected *= 0.5;
            if (is_quarter && nodes[i].position[1] > 1. - 1e-9)
              expected *= 0.5;
            error = std::max(
              error, (force(part, static_cast<Eigen::Index>(i)) - expected).norm());
            ++n_compared;
          }
    return n_compared == nodes.size() ? error / largest : 1.;
  }

  // The largest friction at a partly held node over its normal force.
  double friction_in_plane(const Run &run)
  {
    double largest     = 0.;
    const auto &lambda = run.problem->state().lambda;
    const auto &nodes  = run.problem->contact_surface().nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const Eigen::Vector3d y = at_node(lambda, static_cast<Eigen::Index>(i));
        if (nodes[i].scale[0] == 0. && y(0) > 0.)
          largest = std::max(largest, std::abs(y(2)) / y(0));
      }
    return largest;
  }

  // Contact forces in directions that are held.
  double in_held_directions(const Run &run)
  {
    return run.problem->contact_surface()
      .B()
      .held()
      .cwiseProduct(run.problem->state().lambda)
      .norm();
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::vector<Method> methods = all_methods();
  methods.push_back({"by solves, amg",
                     {"Contact solver/Method=newton", "Dual operator/Form=by solves",
                      "Stiffness solver/Type=amg"}});

  const std::string top         = "top : 0; 4e-5; -1e-4*(1 + y)";
  const std::string quarter_top = "top : 0; 0; -1e-4";
  const Settings squeezed       = {
          "Boundary conditions/Traction=left : 2e7; 0; 0 | right : -2e7; 0; 0"};
  const Settings squeezed_half = {"Boundary conditions/Traction=left : 2e7; 0; 0"};
  for (const std::string coefficient : {"0.3", "0.5; 0.3"})
    {
      const Settings friction = {"Friction/Coefficient=" + coefficient};
      const Settings newton   = methods.front().settings + friction;
      const Run whole(shipped("brick.prm"), brick(2, 1, top) + squeezed + newton);
      const Run all_four(shipped("brick.prm"),
                         brick(2, 2, quarter_top) + squeezed + newton);
      const auto &states = whole.summary()["contact"];
      out() << "F = " << coefficient << ": whole certified "
            << yes(whole.converged && all_four.converged) << ", slips and sticks "
            << yes(states["slip"].get<int>() > 0 && states["stick"].get<int>() > 0)
            << std::endl;
      for (const Method &method : methods)
        {
          const Run half(shipped("brick.prm"),
                         brick(1, 1, "right : 0; free; free | " + top) + squeezed_half +
                           friction + method.settings);
          const Run quarter(
            shipped("brick.prm"),
            brick(1, 1, "right : 0; free; free | back : free; 0; free | " + quarter_top) +
              squeezed_half + friction + method.settings);
          out() << method.name << ": certified "
                << yes(half.converged && quarter.converged) << ", half agrees to 1e-8 "
                << yes(difference(half, whole, false) < 1e-8)
                << ", quarter agrees to 1e-8 "
                << yes(difference(quarter, all_four, true) < 1e-8)
                << ", friction acts in the plane of symmetry "
                << yes(friction_in_plane(half) > 0.1) << ", no force in held directions "
                << yes(in_held_directions(half) == 0. &&
                       in_held_directions(quarter) == 0.)
                << std::endl;
        }
    }

  // Energies balance if nothing but the clamped top and the fixed rollers holds
  // the body; a moved roller does work.
  const Settings moved =
    brick(1, 1,
          "right : 1e-4; free; free | top : 1e-4*x; 4e-5; "
          "-1e-4*(1 + y)") +
    squeezed_half +
    Settings{"Friction/Coefficient=0.4; 0.15", "Friction/First direction=1; 1; 0"};
  const Run newton(shipped("brick.prm"), moved + methods.front().settings);
  for (const Method &method : methods)
    {
      const Run run(shipped("brick.prm"), moved + method.settings);
      const auto &lambda = newton.problem->state().lambda;
      const auto &energy = run.summary()["energy"];
      const double work  = energy["load_work"].get<double>();
      const double kept  = 2. * energy["strain"].get<double>() +
                          energy["friction_dissipation"].get<double>();
      out() << method.name << ", moved roller: certified " << yes(run.converged)
            << ", agrees to 1e-8 "
            << yes((run.problem->state().lambda - lambda).norm() < 1e-8 * lambda.norm())
            << ", work is strain and friction "
            << yes(std::abs(work - kept) < 1e-8 * std::abs(work))
            << ", energy error bounded "
            << yes(run.summary()["certificate"]["duality_gap"].get<double>() < 1e-6)
            << std::endl;
    }

  // Given friction by the interior point method alone, which is what Newton's
  // method in displacements falls back to.
  const Settings given = {"Friction/Law=given", "Friction/Slip stress=1e7; 4e6",
                          "Contact solver/Tolerance=1e-9"};
  const Run dual(shipped("brick.prm"), moved + given + methods.front().settings);
  LevelNewton::Options options;
  options.only_fallback = true;
  NewtonMultigrid newton_multigrid(dual.problem->elasticity(),
                                   dual.problem->contact_surface(), true, options);
  State state;
  const auto status =
    newton_multigrid.solve(state, 1e-9, 1000, [](const ContactStep &) {});
  const Eigen::VectorXd &lambda = dual.problem->state().lambda;
  out() << "interior point method alone: converged " << yes(status.converged)
        << ", agrees to 1e-6 "
        << yes((state.lambda - lambda).norm() < 1e-6 * lambda.norm())
        << ", slips and sticks "
        << yes(dual.summary()["contact"]["slip"].get<int>() > 0 &&
               dual.summary()["contact"]["stick"].get<int>() > 0)
        << std::endl;
}
