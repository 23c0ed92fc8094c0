// Contact nodes whose displacement is prescribed in some directions, or in all of them,
// and bodies that nothing presses any more. A brick that is turned by 10 degrees and
// whose upper edges support moves: gaps are those of a rigid motion, and edges touch as
// the rest does. Friction on a face whose nodes are all held obliquely bears what it
// bears on any other. Edges that are driven into what lies opposite, friction that they
// lack, corners of two contact boundaries: warnings. A block that slips while it is
// pressed stays where it is once all pressure is gone, whatever the method.

#include <stiction/base/errors.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>

#include "several_bodies.h"

#include <cmath>

using namespace stiction;

namespace
{
  const double sine        = std::sin(10. * dealii::numbers::PI / 180.),
               cosine      = std::cos(10. * dealii::numbers::PI / 180.);
  const std::string turned = "0;0;0;0;1;0;10";

  std::string oblique(const std::string &supports, const std::string &entry)
  {
    return file(
      "oblique.prm",
      brick("b", "10,10,10", "4,3,4", "0;0;0", turned) +
        brick("other", "10,30,30", "2,5,5", "8.11159575345278;-10;-11.5845593067914",
              turned) +
        section("Boundary conditions", {"Prescribed displacement = " + supports}) +
        section("Contact pair c",
                {"Boundary = b.right", "Obstacle = boundary : other.left",
                 "Law = frictionless", entry}));
  }

  // How far gaps are from one number, as a part of the displacement, and from zero.
  void rigid_gaps(const std::string &supports, const double gap)
  {
    const Run run(oblique(supports, "Initial gap = 0.5"), {});
    const auto &surface     = run.problem->contact_surface();
    const Eigen::VectorXd r = surface.gap_and_slip(run.problem->state());
    double wrong            = 0.;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      wrong = std::max(wrong, std::abs(r(i) - gap) / 0.3);
    out() << supports << ": certified " << yes(run.converged) << ", gaps right to 1e-6 "
          << yes(wrong < 1e-6) << std::endl;
  }

  // The force on the side that does not bear it.
  dealii::Tensor<1, 3> pressed(const std::string &method, const std::string &side)
  {
    const Run run(oblique("b.top : free; 0; -0.3 | b.left : 0; free; free | "
                          "other.right : 0; 0; 0",
                          "Slave side = " + side),
                  {"Contact solver/Method=" + method});
    const auto &surface          = run.problem->contact_surface();
    const auto &lambda           = run.problem->state().lambda;
    const Eigen::VectorXd forces = surface.forces(lambda);
    const Eigen::Index m         = surface.n_nodes();
    const dealii::Tensor<1, 3> force(
      {forces.head(m).sum(), forces.segment(m, m).sum(), forces.tail(m).sum()});
    const double along_face = sine * force[0] + cosine * force[2];
    out() << method << ", forces on " << side << ": certified " << yes(run.converged)
          << ", open nodes of the brick "
          << (side == "boundary" ? std::to_string((lambda.head(m).array() <= 0.).count())
                                 : "-")
          << ", force along the face "
          << (std::abs(along_face) < 1e-6 * force.norm() ? "none" : "some")
          << ", pressures bear it "
          << yes(std::abs(lambda.head(m).sum() - force.norm()) < 1e-6 * force.norm())
          << std::endl;
    return force;
  }

  // A plate pressed with 1 onto a plane that is inclined by 30 degrees and pushed across.
  // Its face is held in z and nothing holds it in y but friction: 0.5/cos 30° of it.
  void pushed_across(const std::string &method, const double part)
  {
    const auto name =
      file("across.prm",
           brick("b", "2,30,10", "1,6,3", "0;0;0", "0;0;0;0;1;0;30") +
             section("Boundary conditions",
                     {"Prescribed displacement = b.right : free; free; 0",
                      "Traction = b.left : 1; " +
                        std::to_string(part * 0.5 / std::sqrt(0.75)) + "; 0"}) +
             section("Contact pair c",
                     {"Boundary = b.right",
                      "Obstacle = plane : 1.73205080756888;0;-1;-0.866025403784439;0;0.5",
                      "Law = coulomb", "Coefficient = 0.5"}));
    out() << method << ", pushed across by " << part << " of what friction bears: ";
    try
      {
        const Run run(name, {"Contact solver/Method=" + method});
        out() << "certified " << yes(run.converged) << std::endl;
      }
    catch (const InputError &e)
      {
        out() << e.what() << std::endl;
      }
  }

  void driven(const std::string &name, const std::string &obstacle,
              const std::string &supports, const std::string &side)
  {
    const Run run(
      file("driven.prm",
           brick("b", "40,20,10", "8,4,2", "0;0;0") +
             brick("o", "60,40,10", "8,4,2", "-10;-10;-10") +
             section("Boundary conditions", {"Prescribed displacement = " + supports}) +
             section("Contact pair c", {"Boundary = b.bottom", "Obstacle = " + obstacle,
                                        "Slave side = " + side, "Law = frictionless"})),
      {});
    out() << name << ": certified " << yes(run.converged) << ", warnings of nodes inside "
          << n_warnings(run, "none of its forces act") << std::endl;
  }

  void corner(const std::string &push)
  {
    const Run run(
      file("corner.prm",
           section("Geometry", {"Lengths = 2,1,1", "Subdivisions = 4,2,2"}) +
             section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
             section("Boundary conditions",
                     {"Prescribed displacement = front : free; 0; free",
                      "Traction = right : " + push + "; 0; 0 | top : 0; 0; " + push}) +
             section("Contact pair floor",
                     {"Boundary = bottom", "Obstacle = plane : 0;0;0;0;0;1",
                      "Law = frictionless"}) +
             section("Contact pair wall",
                     {"Boundary = left", "Obstacle = plane : 0;0;0;1;0;0",
                      "Law = frictionless"})),
      {});
    out() << "pushed into a corner by " << push << ": certified " << yes(run.converged)
          << ", warnings of nodes inside " << n_warnings(run, "none of its forces act")
          << std::endl;
  }

  // A drawer that is pushed by 5 and pulled back, on friction.
  void drawer(const std::string &end)
  {
    const Run run(
      file("drawer.prm",
           section("Geometry", {"Lengths = 100,60,20", "Subdivisions = 5,3,1"}) +
             section("Material", {"Young's modulus = 10000", "Poisson ratio = 0.3"}) +
             section(
               "Boundary conditions",
               {"Prescribed displacement = left : if(t<1,5*t,10-5*t); " + end + "; free",
                "Pressure = top : 0.01"}) +
             section("Contact pair floor",
                     {"Boundary = bottom", "Obstacle = plane : 0;0;0;0;0;1",
                      "Law = coulomb", "Coefficient = 0.2"}) +
             section("Time", {"Steps = 1, 2"})),
      {});
    const double friction =
      run.summary()["contact"]["force_on_body"][0].get<double>() / 12.;
    out() << "pushed and pulled back, y " << end << ": certified " << yes(run.converged)
          << ", friction right to 1e-3 " << yes(std::abs(std::abs(friction) - 1.) < 1e-3)
          << ", warnings of friction that lacks "
          << n_warnings(run, "without friction in the directions") << std::endl;
  }

  // Pressed, dragged until much of it slips, let go in that direction, and in all.
  double released(const std::string &method, const double until)
  {
    const Run run(
      file(
        "released.prm",
        section("Geometry", {"Lengths = 40,12,10", "Subdivisions = 10,3,2"}) +
          section("Material", {"Young's modulus = 1000", "Poisson ratio = 0.3"}) +
          section("Boundary conditions",
                  {"Pressure = top : if(t<=3,1,4-t)",
                   "Traction = left : if(t<1,0,if(t<2,t-1,max(3-t,0)));0;0"}) +
          section("Contact pair floor",
                  {"Boundary = bottom", "Obstacle = plane : 0;0;0;0;0;1", "Law = coulomb",
                   "Coefficient = 0.3"}) +
          section("Contact pair wall",
                  {"Boundary = right", "Obstacle = plane : 45;0;0;-1;0;0",
                   "Law = frictionless"}) +
          section("Time", {until == 4. ? "Steps = 1,2,3,3.5,4" : "Steps = 1,2,3,3.5"})),
      {"Contact solver/Method=" + method, "Contact solver/Tolerance=1e-6"});
    double sum     = 0.;
    unsigned int n = 0;
    for (const auto &node : run.problem->elasticity().body().locally_owned_nodes())
      {
        sum += run.problem->state().u(node.dofs[0]);
        ++n;
      }
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD) /
           dealii::Utilities::MPI::sum(n, MPI_COMM_WORLD);
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  rigid_gaps("b.top : free; 0; -0.3 | b.left : 0; free; free | other.right : 0; 0; 0",
             0.5 - 0.3 * sine);
  rigid_gaps("b.top : free; 0; 0.3 | b.left : 0; free; free | other.right : 0; 0; 0",
             0.5 + 0.3 * sine);
  rigid_gaps("b.top : free; 0; 0 | b.left : 0; free; free | other.right : 0; 0; -0.3",
             0.5 + 0.3 * sine);
  for (const std::string method : {"newton", "newton multigrid", "mpgp"})
    {
      const auto own = pressed(method, "boundary"), other = pressed(method, "obstacle");
      out() << "forces are opposite to 2 % "
            << yes((own + other).norm() < 2e-2 * own.norm()) << std::endl;
    }

  for (const std::string method : {"newton", "newton multigrid", "admm"})
    for (const double part : {0.99, 1.01})
      pushed_across(method, part);

  const std::string pair = "boundary : o.top", plane = "plane : 0;0;0;0;0;1",
                    held = " | o.bottom : 0; 0; 0";
  driven("an edge into a plane", plane, "b.left : 0; 0; -0.1" + held, "automatic");
  driven("along a plane", plane, "b.left : 0.1; 0; 0" + held, "automatic");
  driven("an edge into a body", pair, "b.left : 0; 0; -0.1" + held, "boundary");
  driven("its forces on that body", pair, "b.left : 0; 0; -0.1" + held, "obstacle");
  driven("held in the plane alone", pair,
         "b.left : 0; 0; free | b.top : free; free; -0.05" + held, "boundary");
  corner("0");
  corner("-10");
  drawer("free");
  drawer("0");

  for (const std::string method : {"newton", "newton multigrid", "admm", "mpgp"})
    {
      const double before = released(method, 3.5), after = released(method, 4.);
      out() << method << ": it slipped " << yes(before > 1e-4)
            << ", stays to 1e-4 of that " << yes(std::abs(after / before - 1.) < 1e-4)
            << std::endl;
    }
}
