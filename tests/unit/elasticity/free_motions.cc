// The rigid motions that supports leave free, in words; that K does not feel them; that
// anchors hold them and bear nothing where loads are balanced.

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include "tests.h"

#include <algorithm>
#include <vector>

using namespace stiction;

namespace
{
  void check(const std::string &name, const Settings &supports)
  {
    Parameters parameters;
    parameters.read(shipped("block_on_slope.prm"),
                    Settings{"Geometry/Lengths=1,2,1", "Geometry/Subdivisions=2,2,2",
                             "Geometry/Global refinement=1",
                             "Material/Young's modulus=1"} +
                      supports);
    const Body body(parameters.geometry, MPI_COMM_WORLD);
    LinearElasticity elasticity(body, parameters.of_body());
    elasticity.choose_anchors({});
    const FreeMotions &motions = elasticity.free_motions();
    out() << name << ": " << (motions.n() > 0 ? motions.in_words() : "nothing")
          << std::endl;

    // no motion strains the body or moves a support
    double strain = 0., moved = 0.;
    LA::Vector all = elasticity.zero_vector();
    for (Eigen::Index j = 0; j < motions.n(); ++j)
      {
        const Eigen::VectorXd alpha = Eigen::VectorXd::Unit(motions.n(), j);
        LA::Vector u                = elasticity.zero_vector();
        elasticity.add_free_motion(alpha, u);
        strain = std::max(strain, elasticity.internal_force(u).linfty_norm());
        for (const auto dof : body.locally_owned_dofs())
          if (elasticity.is_prescribed(dof))
            moved = std::max(moved, std::abs(u(dof)));
        elasticity.add_free_motion((1. + j) * alpha, all);
      }
    moved                       = dealii::Utilities::MPI::max(moved, MPI_COMM_WORLD);
    const Eigen::VectorXd found = elasticity.free_motion_of(all);
    double wrong                = 0.;
    for (Eigen::Index j = 0; j < motions.n(); ++j)
      wrong = std::max(wrong, std::abs(found(j) - 1. - static_cast<double>(j)));

    // a load in balance: that of some displacement
    LA::Vector u = elasticity.zero_vector();
    for (const Body::Node &node : body.locally_owned_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        if (!elasticity.is_prescribed(node.dofs[c]))
          u(node.dofs[c]) = node.position[(c + 1) % 3] * node.position[c];
    LA::Vector load   = elasticity.internal_force(u);
    const double work = elasticity.work_along_free_motions(load).norm();
    double reaction   = 0.;
    for (const std::string type : {"mumps", "multigrid", "amg"})
      {
        LA::Vector right = load, solution = elasticity.zero_vector();
        for (const auto dof : body.locally_owned_dofs())
          if (elasticity.is_fixed(dof))
            right(dof) = 0.;
        StiffnessSolver::create(type, elasticity, 1e-12)->solve(solution, right);
        LA::Vector missing = elasticity.internal_force(solution);
        missing -= load;
        for (const auto dof : body.locally_owned_dofs())
          if (elasticity.is_prescribed(dof))
            missing(dof) = 0.;
        reaction = std::max(reaction, missing.linfty_norm());
      }
    out() << "  " << elasticity.anchors().size() << " anchors, no strain "
          << yes(strain < 1e-13) << ", supports at rest " << yes(moved < 1e-13)
          << ", found again " << yes(wrong < 1e-12) << ", loads in balance "
          << yes(work < 1e-13) << ", anchors bear nothing " << yes(reaction < 1e-10)
          << std::endl;
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string entry = "Boundary conditions/Prescribed displacement=";
  const std::string point = "Boundary conditions/Prescribed points=";
  check("no supports", {});
  check("clamped", {entry + "left : 0; 0; 0"});
  check("a roller", {entry + "left : 0; free; free"});
  check("two rollers", {entry + "left : 0; free; free | front : free; 0; free"});
  check("a hinge", {point + "0; 0; 1 : 0; 0; 0 | 0; 2; 1 : 0; 0; 0"});
  check("an oblique hinge", {point + "0; 0; 1 : 0; 0; 0 | 1; 2; 1 : 0; 0; 0"});
  check("a ball joint", {point + "0; 0; 1 : 0; 0; 0"});
  check("a point on rails", {point + "0; 0; 1 : free; 0; 0"});
}
