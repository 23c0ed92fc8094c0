// The parts of the multigrid method: products without a matrix are those of
// the assembled matrix, on every level the Galerkin products of the next finer
// one; interpolation reproduces linear functions and restriction is its
// transpose; the V-cycle is symmetric, also with supports along directions that
// are no axis, and its number of iterations does not grow under refinement.

#include "tests.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/levels/dof_subset_hierarchy.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>
#include <stiction/elasticity/multigrid/multigrid.h>
#include <stiction/elasticity/solvers/multigrid_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Eigen/Geometry>

#include <cmath>
#include <memory>

using namespace stiction;

namespace
{
  struct Brick
  {
    Brick(const unsigned int refinement, const std::string &solver)
    {
      parameters.read(shipped("brick.prm"),
                      {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                       "Geometry/Subdivisions=3,2,1",
                       "Geometry/Global refinement=" + std::to_string(refinement),
                       "Stiffness solver/Type=" + solver});
      body       = std::make_unique<Body>(parameters.geometry, MPI_COMM_WORLD);
      elasticity = std::make_unique<LinearElasticity>(*body, parameters.of_body());
    }

    Parameters parameters;
    std::unique_ptr<Body> body;
    std::unique_ptr<LinearElasticity> elasticity;
  };

  // The same numbers on any number of ranks: functions of the places.
  void fill(const MeshLevel &level, LA::Vector &v, const double frequency)
  {
    level.for_each_cell([&](const HexahedralCell &cell) {
      for (unsigned int k = 0; k < 8; ++k)
        if (cell.nodes[k] < level.n_owned_nodes())
          for (unsigned int c = 0; c < 3; ++c)
            {
              const auto &x = cell.vertices[k];
              v.local_element(3 * cell.nodes[k] + c) =
                std::sin(frequency * (x[0] + 2. * x[1] + 3. * x[2]) + c) +
                0.3 * std::cos(7. * x[1] - x[0]);
            }
    });
  }

  double distance(const LA::Vector &a, const LA::Vector &b)
  {
    LA::Vector difference = a;
    difference -= b;
    return difference.l2_norm() / b.l2_norm();
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  {
    const Brick brick(1, "amg");
    const Body &body                   = *brick.body;
    const LinearElasticity &elasticity = *brick.elasticity;
    LA::Vector v = elasticity.zero_vector(), assembled = v;
    fill(elasticity.mesh(), v, 1.);
    for (const auto dof : body.locally_owned_dofs())
      if (elasticity.constraints().is_constrained(dof))
        v(dof) = 0.;
    elasticity.constrained_stiffness().vmult(assembled, v);
    LA::Vector product = elasticity.internal_force(v);
    for (const auto dof : body.locally_owned_dofs())
      if (elasticity.constraints().is_constrained(dof))
        product(dof) = 0.;
    out() << "product without a matrix is that of the matrix: "
          << yes(distance(product, assembled) < 1e-13) << std::endl;
  }

  const Brick brick(3, "multigrid");
  const Body &body                   = *brick.body;
  const LinearElasticity &elasticity = *brick.elasticity;
  const MeshHierarchy hierarchy(body, elasticity.mesh());

  for (unsigned int l = 1; l < hierarchy.n_levels(); ++l)
    {
      const MeshLevel &fine = hierarchy.level(l), &coarse = hierarchy.level(l - 1);
      const LevelTransfer &transfer = hierarchy.transfer(l);
      LA::Vector u = coarse.zero_vector<double>(), back = u, Ku = u;
      LA::Vector v = fine.zero_vector<double>(), Pu = v, KPu = v;

      // linear functions
      const auto linear = [](const MeshLevel &level, LA::Vector &w) {
        level.for_each_cell([&](const HexahedralCell &cell) {
          for (unsigned int k = 0; k < 8; ++k)
            if (cell.nodes[k] < level.n_owned_nodes())
              for (unsigned int c = 0; c < 3; ++c)
                w.local_element(3 * cell.nodes[k] + c) =
                  1. + cell.vertices[k][c] - 2. * cell.vertices[k][(c + 1) % 3];
        });
      };
      linear(coarse, u);
      linear(fine, v);
      transfer.prolongate(Pu, u);
      const bool is_exact = distance(Pu, v) < 1e-14;
      transfer.inject(back, v);
      const bool injects = distance(back, u) < 1e-14;

      fill(coarse, u, 0.7);
      fill(fine, v, 1.3);
      transfer.prolongate(Pu, u);
      transfer.restrict_to(back, v);
      const bool is_transpose = std::abs((Pu * v) / (u * back) - 1.) < 1e-12;

      const StiffnessOperator<double> K_fine(fine, elasticity.materials());
      const StiffnessOperator<double> K_coarse(coarse, elasticity.materials());
      K_fine.vmult(KPu, Pu);
      transfer.restrict_to(back, KPu);
      K_coarse.vmult(Ku, u);
      out() << "level " << l << ": interpolates linear functions " << yes(is_exact)
            << ", injects them " << yes(injects) << ", restriction is the transpose "
            << yes(is_transpose) << ", Galerkin product "
            << yes(distance(back, Ku) < 1e-12) << std::endl;
    }

  // supports of all kinds at the nodes of the face z = 0, normals oblique
  std::vector<dealii::types::global_dof_index> nodes;
  {
    std::vector<dealii::types::global_dof_index> mine;
    for (const Body::Node &node : body.locally_owned_nodes())
      if (node.position[2] == 0. && node.position[1] > 0.)
        mine.push_back(node.dofs[0]);
    for (const auto &theirs : dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, mine))
      nodes.insert(nodes.end(), theirs.begin(), theirs.end());
  }
  const DofSubsetHierarchy trace(hierarchy, nodes);
  Multigrid multigrid(elasticity, hierarchy, trace);
  const unsigned int finest = hierarchy.n_levels() - 1;
  NodalSupports supports(nodes.size());
  for (std::size_t i = 0; i < supports.size(); ++i)
    {
      const Eigen::Vector3d n = Eigen::Vector3d(0.2, -0.1, -1.).normalized();
      const Eigen::Vector3d t = n.cross(Eigen::Vector3d::UnitX()).normalized();
      if (i % 3 != 0)
        supports[i].projection -= n * n.transpose();
      if (i % 3 == 1)
        supports[i].spring = 1e10 * t * t.transpose();
      if (i % 7 == 0)
        supports[i].projection.setZero();
    }
  multigrid.set_supports(finest, supports);

  LA::Vector a = elasticity.zero_vector(), b = a;
  fill(elasticity.mesh(), a, 0.4);
  fill(elasticity.mesh(), b, 2.1);
  auto Ma = elasticity.mesh().zero_vector<float>(), Mb = Ma;
  const double factor_a = multigrid.vmult(finest, Ma, a);
  const double factor_b = multigrid.vmult(finest, Mb, b);
  double aMb = 0., bMa = 0., aMa = 0., held = 0.;
  for (unsigned int k = 0; k < a.locally_owned_size(); ++k)
    {
      aMb += factor_b * Mb.local_element(k) * a.local_element(k);
      bMa += factor_a * Ma.local_element(k) * b.local_element(k);
      aMa += factor_a * Ma.local_element(k) * a.local_element(k);
    }
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (Ma.in_local_range(nodes[i]))
      {
        const Eigen::Vector3d at_node(Ma(nodes[i]), Ma(nodes[i] + 1), Ma(nodes[i] + 2));
        held = std::max(held, (at_node - supports[i].projection * at_node).norm());
      }
  aMb  = dealii::Utilities::MPI::sum(aMb, MPI_COMM_WORLD);
  bMa  = dealii::Utilities::MPI::sum(bMa, MPI_COMM_WORLD);
  aMa  = dealii::Utilities::MPI::sum(aMa, MPI_COMM_WORLD);
  held = dealii::Utilities::MPI::max(held, MPI_COMM_WORLD);
  out() << "V-cycle with supports: symmetric " << yes(std::abs(aMb / bMa - 1.) < 1e-4)
        << ", positive " << yes(aMa > 0.) << ", zero where it is held "
        << yes(held < 1e-6 * Ma.linfty_norm()) << std::endl;

  {
    // x = M (P K P + S) x for x in the range of P, once it is factorised
    const bool is_new = multigrid.factorize(finest);
    multigrid.set_supports(finest, supports);
    const auto at_nodes = [&](LA::Vector &v, const auto &change) {
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (v.in_local_range(nodes[i]))
          {
            const Eigen::Vector3d at_node =
              change(i, Eigen::Vector3d(v(nodes[i]), v(nodes[i] + 1), v(nodes[i] + 2)));
            for (unsigned int c = 0; c < 3; ++c)
              v(nodes[i] + c) = at_node(c);
          }
    };
    const auto project = [&](LA::Vector &v) {
      at_nodes(v, [&](const std::size_t i, const Eigen::Vector3d &at_node) {
        return Eigen::Vector3d(supports[i].projection * at_node);
      });
      for (const auto dof : body.locally_owned_dofs())
        if (elasticity.constraints().is_constrained(dof))
          v(dof) = 0.;
    };
    LA::Vector x = a;
    project(x);
    LA::Vector springs = x;
    at_nodes(springs, [&](const std::size_t i, const Eigen::Vector3d &at_node) {
      return Eigen::Vector3d(supports[i].spring * at_node);
    });
    LA::Vector Ax = elasticity.internal_force(x);
    for (const auto dof : nodes)
      if (Ax.in_local_range(dof))
        for (unsigned int c = 0; c < 3; ++c)
          Ax(dof + c) += springs(dof + c);
    project(Ax);
    const double factor = multigrid.vmult(finest, Ma, Ax);
    LA::Vector found    = x;
    for (unsigned int k = 0; k < found.locally_owned_size(); ++k)
      found.local_element(k) = factor * Ma.local_element(k);
    out() << "factorised with supports: is new " << yes(is_new) << ", is exact "
          << yes(distance(found, x) < 1e-5) << ", and not new again "
          << yes(!multigrid.factorize(finest)) << std::endl;
  }

  for (const unsigned int refinement : {1, 2, 3, 4})
    {
      const Brick refined(refinement, "multigrid");
      const LinearElasticity &elastic = *refined.elasticity;
      MultigridSolver solver(elastic, 1e-8);
      LA::Vector u = elastic.zero_vector();
      solver.solve(u, elastic.constrained_load());
      LA::Vector residual = elastic.load();
      residual -= elastic.internal_force(u);
      for (const auto dof : refined.body->locally_owned_dofs())
        if (elastic.constraints().is_constrained(dof))
          residual(dof) = 0.;
      out() << "elastic solve, refined " << refinement << " times: residual below 1e-8 "
            << yes(residual.l2_norm() <= 1.01e-8 * elastic.load().l2_norm())
            << ", at most 20 iterations " << yes(solver.n_iterations() <= 20)
            << std::endl;
    }
}
