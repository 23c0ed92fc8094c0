// Reactions of the supports against exact answers: a bar that is pulled, a
// block clamped at two faces that meet, and with rollers, points, a prescribed
// displacement and two contact boundaries the balance of all forces and
// moments, also with hanging nodes and with triquadratic elements.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/support_reactions.h>

#include <deal.II/lac/la_parallel_vector.h>

using namespace stiction;
using Vector3 = dealii::Tensor<1, 3>;

namespace
{
  const Settings block = {"Geometry/Type=brick",
                          "Geometry/Table 1 level=0",
                          "Geometry/Lengths=4,3,1",
                          "Geometry/Subdivisions=4,3,1",
                          "Geometry/Global refinement=1",
                          "Boundary conditions/Pressure=",
                          "Boundary conditions/Traction=",
                          "Boundary conditions/Contact boundary=bottom",
                          "Boundary conditions/Initial gap=1",
                          "Contact solver/Method=newton",
                          "Contact solver/Tolerance=1e-9"};

  Vector3 vector(const nlohmann::json &v)
  {
    return Vector3({v[0].get<double>(), v[1].get<double>(), v[2].get<double>()});
  }

  struct Sum
  {
    Vector3 force, moment;

    void add(const dealii::Point<3> &at, const Vector3 &f)
    {
      force += f;
      moment += cross_product_3d(at, f);
    }
  };

  // Of all supports in the summary, and of all loads.
  Sum reactions(const Run &run)
  {
    Sum sum;
    const auto &json = run.summary()["reactions"];
    for (const auto &boundary : json["boundaries"])
      {
        sum.force += vector(boundary["force"]);
        sum.moment += vector(boundary["moment"]);
      }
    for (const auto &point : json["points"])
      sum.add(dealii::Point<3>(vector(point["at"])), vector(point["force"]));
    return sum;
  }

  Sum nodal(const Run &run, const LA::Vector &v)
  {
    Sum sum;
    for (const Body::Node &node : run.problem->elasticity().body().locally_owned_nodes())
      {
        Vector3 f;
        for (unsigned int c = 0; c < 3; ++c)
          f[c] = v(node.dofs[c]);
        sum.add(node.position, f);
      }
    sum.force  = dealii::Utilities::MPI::sum(sum.force, MPI_COMM_WORLD);
    sum.moment = dealii::Utilities::MPI::sum(sum.moment, MPI_COMM_WORLD);
    return sum;
  }

  // ‖reactions + loads + contact forces‖ relative to S, and of the moments.
  bool is_balanced(const Run &run)
  {
    const Sum R         = reactions(run);
    const Sum loads     = nodal(run, run.problem->elasticity().load());
    const Sum all       = nodal(run, run.problem->reactions().nodal());
    const auto &contact = run.summary()["contact"];
    Vector3 force, moment;
    for (const auto &boundary : contact["boundaries"])
      {
        force += vector(boundary["force_on_body"]);
        moment += vector(boundary["moment"]);
      }
    const double S = run.problem->certificate().force_scale();
    return run.converged && (R.force + loads.force + force).norm() < 1e-10 * S &&
           (R.moment + loads.moment + moment).norm() < 1e-10 * 5. * S &&
           (R.force - all.force).norm() < 1e-12 * S &&
           (R.moment - all.moment).norm() < 1e-12 * 5. * S;
  }

  bool has(const nlohmann::json &v, const Vector3 &exact, const double scale)
  {
    return (vector(v) - exact).norm() < 1e-9 * scale;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string file = shipped("brick.prm");
  {
    const Run run(
      file, block + Settings{"Boundary conditions/Prescribed displacement=left : 0; "
                             "free; free",
                             "Boundary conditions/Prescribed points=0;0;0 : free;0;0 "
                             "| 0;3;0 : free;free;0",
                             "Boundary conditions/Traction=right : 1e6; 0; 0"});
    const auto &R    = run.summary()["reactions"];
    const double F   = 3e6;
    const auto &left = R["boundaries"][0];
    out() << "Pulled bar: held with the load "
          << yes(left["name"] == "left" && has(left["force"], Vector3({-F, 0., 0.}), F))
          << ", its moment "
          << yes(has(left["moment"], Vector3({0., -F / 2., 1.5 * F}), F))
          << ", nothing at the points "
          << yes(has(R["points"][0]["force"], {}, F) &&
                 has(R["points"][1]["force"], {}, F))
          << ", balance " << yes(is_balanced(run)) << std::endl;
  }
  {
    const Run run(
      file, block + Settings{"Boundary conditions/Prescribed displacement=left : 0; "
                             "0; 0 | front : 0; 0; 0",
                             "Boundary conditions/Prescribed points=0;0;0 : 0;0;0",
                             "Boundary conditions/Traction=top : 0; 0; -1e6"});
    const Sum R = reactions(run);
    out() << "Two clamped faces and a point: force "
          << yes((R.force - Vector3({0., 0., 1.2e7})).norm() < 1e-3) << ", moment "
          << yes((R.moment - Vector3({1.8e7, -2.4e7, 0.})).norm() < 1e-3) << ", balance "
          << yes(is_balanced(run)) << std::endl;
  }
  const Settings all =
    block + Settings{"Boundary conditions/Prescribed displacement=left : 0; "
                     "free; free | front : free; 1e-5; free",
                     "Boundary conditions/Prescribed points=0;0;1 : 0;free;0 | "
                     "4;0;1 : free;free;0",
                     "Boundary conditions/Traction=top : 1e5; 2e5; -1e7",
                     "Boundary conditions/Contact boundary=bottom | right",
                     "Boundary conditions/Obstacle=foundation | plane : "
                     "4;0;0;-1;0;0",
                     "Boundary conditions/Initial gap=0",
                     "Friction/Law=coulomb",
                     "Friction/Coefficient=0.3"};
  for (const auto &what : std::vector<std::pair<std::string, Settings>>{
         {"uniform", {}},
         {"hanging nodes",
          {"Geometry/Contact refinement=1", "Geometry/Contact refinement where=x<2"}},
         {"triquadratic", {"Geometry/Global refinement=0", "Geometry/Element degree=2"}}})
    {
      const Run run(file, all + what.second);
      const auto &contact = run.summary()["contact"]["boundaries"];
      const auto &R       = run.summary()["reactions"];
      const double S      = run.problem->certificate().force_scale();
      bool only_held      = true;
      only_held           = only_held &&
                  std::abs(R["boundaries"][0]["force"][1].get<double>()) == 0. &&
                  std::abs(R["boundaries"][0]["force"][2].get<double>()) == 0. &&
                  std::abs(R["boundaries"][1]["force"][0].get<double>()) == 0.;
      bool parts = contact.size() == 2;
      for (const auto &boundary : contact)
        parts = parts && boundary["normal_force"].get<double>() > 1e-3 * S &&
                boundary["open"].get<int>() + boundary["slip"].get<int>() +
                    boundary["stick"].get<int>() ==
                  boundary["nodes"].get<int>() &&
                vector(boundary["tangential_force"]).norm() > 1e-6 * S;
      // a plane: what is left of the force is along its normal
      const Vector3 bottom =
        vector(contact[0]["force_on_body"]) - vector(contact[0]["tangential_force"]);
      parts = parts &&
              (bottom - Vector3({0., 0., contact[0]["normal_force"]})).norm() < 1e-12 * S;
      out() << "Rollers, points, two contact boundaries, " << what.first << ": balance "
            << yes(is_balanced(run)) << ", held components alone " << yes(only_held)
            << ", contact boundaries " << yes(parts) << std::endl;
    }
}
