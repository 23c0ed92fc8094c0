// Q = B K⁻¹ Bᵀ and h = B K⁻¹ f − (d; 0; 0) against dense linear algebra on a
// tiny body with a prescribed displacement and an initial gap, for both
// forms of the dual operator and both solvers; block products agree with the
// whole and count what they cost.

#include "tests.h"

#include <stiction/contact/dual/schur_complement.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <memory>

using namespace stiction;

namespace
{
  // The whole stiffness matrix on every rank.
  Eigen::MatrixXd dense(const LinearElasticity &elasticity)
  {
    const auto &K     = elasticity.constrained_stiffness();
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(K.m(), K.n());
    for (const auto row : elasticity.body().locally_owned_dofs())
      for (auto entry = K.begin(row); entry != K.end(row); ++entry)
        D(row, entry->column()) = entry->value();
    MPI_Allreduce(MPI_IN_PLACE, D.data(), static_cast<int>(D.size()), MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD);
    return D;
  }

  Eigen::VectorXd dense(const LA::Vector &v)
  {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(v.size());
    for (const auto i : v.locally_owned_elements())
      d(i) = v(i);
    MPI_Allreduce(MPI_IN_PLACE, d.data(), static_cast<int>(d.size()), MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD);
    return d;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Parameters parameters;
  parameters.read(shipped("brick.prm"),
                  {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                   "Geometry/Subdivisions=3,2,2", "Geometry/Global refinement=0",
                   "Boundary conditions/Prescribed displacement=2 : 1e-4; "
                   "2e-4*x; 1e-4",
                   "Boundary conditions/Initial gap=1e-5*x - 2e-5"});
  const Body body(parameters.geometry, MPI_COMM_WORLD);
  const LinearElasticity elasticity(body, parameters.of_body());
  const ContactSurface surface(elasticity, parameters.of_contact());
  const Eigen::Index m = surface.n_nodes();

  // B row by row from the frames of the contact nodes
  const Eigen::MatrixXd K = dense(elasticity);
  Eigen::MatrixXd B       = Eigen::MatrixXd::Zero(3 * m, K.rows());
  for (Eigen::Index i = 0; i < m; ++i)
    for (unsigned int c = 0; c < 3; ++c)
      {
        const auto dof    = surface.B().dofs().dofs()[i + c * m];
        const auto &node  = surface.nodes()[i];
        B(i, dof)         = node.normal[c];
        B(i + m, dof)     = node.tangent1[c];
        B(i + 2 * m, dof) = node.tangent2[c];
      }
  const Eigen::LLT<Eigen::MatrixXd> factor(K);
  const Eigen::MatrixXd Q = B * factor.solve(B.transpose());
  Eigen::VectorXd h       = B * factor.solve(dense(elasticity.constrained_load()));
  h.head(m) -= surface.gaps();
  out() << "order of K " << K.rows() << ", of Q " << 3 * m << std::endl
        << "Q is symmetric " << yes((Q - Q.transpose()).norm() < 1e-10 * Q.norm())
        << ", and not diagonal "
        << yes((Q - Eigen::MatrixXd(Q.diagonal().asDiagonal())).norm() > 0.1 * Q.norm())
        << ", gaps of both signs "
        << yes(surface.gaps().minCoeff() < 0. && surface.gaps().maxCoeff() > 0.)
        << std::endl;

  for (const std::string type : {"mumps", "amg"})
    for (const std::string form : {"assembled", "by solves"})
      {
        const auto solver = StiffnessSolver::create(type, elasticity, 1e-13);
        const auto schur  = SchurComplement::create(form, elasticity, surface, *solver);

        Eigen::MatrixXd product(3 * m, 3 * m);
        double block_error = 0.;
        for (Eigen::Index j = 0; j < 3 * m; ++j)
          {
            Eigen::VectorXd column;
            schur->vmult(DualBlock::all, DualBlock::all, column,
                         Eigen::VectorXd::Unit(3 * m, j));
            product.col(j) = column;
          }
        const double before = schur->n_multiplications();
        Eigen::VectorXd y, x = Eigen::VectorXd::LinSpaced(3 * m, -1., 2.);
        const auto check = [&](const DualBlock rows, const DualBlock columns,
                               const Eigen::VectorXd &expected,
                               const Eigen::VectorXd &part) {
          schur->vmult(rows, columns, y, part);
          block_error = std::max(block_error, (y - expected).norm() / expected.norm());
        };
        const Eigen::VectorXd xn = x.head(m), xt = x.tail(2 * m);
        check(DualBlock::normal, DualBlock::normal, Q.topLeftCorner(m, m) * xn, xn);
        check(DualBlock::tangential, DualBlock::tangential,
              Q.bottomRightCorner(2 * m, 2 * m) * xt, xt);
        check(DualBlock::tangential, DualBlock::normal, Q.bottomLeftCorner(2 * m, m) * xn,
              xn);
        check(DualBlock::normal, DualBlock::tangential, Q.topRightCorner(m, 2 * m) * xt,
              xt);

        out() << type << ", " << form << ": Q to 1e-10 "
              << yes((product - Q).norm() < 1e-10 * Q.norm()) << ", h to 1e-10 "
              << yes((schur->right_hand_side() - h).norm() < 1e-10 * h.norm())
              << ", blocks to 1e-10 " << yes(block_error < 1e-10)
              << ", the four blocks cost one product "
              << yes(std::abs(schur->n_multiplications() - before - 1.) < 1e-12)
              << std::endl;
      }
}
