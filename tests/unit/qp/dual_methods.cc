// The methods on the dual problem of the reference brick, k = 1: Newton's
// method with its fallbacks forced after every step still ends at the same
// forces, and counts them, those without a matrix and the interior point method
// with one; the monolithic method's energy falls in every
// iteration; successive approximations report how they contract, and the
// extrapolation ends at the same forces; a method that needs the matrix says
// so; a problem written to files and read again has the same solution.

#include "tests.h"

#include <stiction/contact/dual/schur_complement.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/problem/problem_files.h>
#include <stiction/qp/dual_problem.h>
#include <stiction/qp/methods/admm.h>
#include <stiction/qp/methods/coulomb_fixed_point.h>
#include <stiction/qp/methods/gauss_seidel.h>
#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/methods/newton.h>
#include <stiction/qp/verifier.h>

#include <cmath>
#include <memory>
#include <stdexcept>

using namespace stiction;

struct Found
{
  bool converged;
  Eigen::VectorXd lambda;
};

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  Parameters parameters;
  parameters.read(shipped("brick.prm"), {"Geometry/Table 1 level=1"});
  const Body body(parameters.geometry, MPI_COMM_WORLD);
  const LinearElasticity elasticity(body, parameters.of_body());
  const ContactSurface surface(elasticity, parameters.of_contact());
  const auto solver = StiffnessSolver::create("mumps", elasticity, 1e-13);
  const auto Q      = SchurComplement::create("assembled", elasticity, surface, *solver);
  const auto by_solves =
    SchurComplement::create("by solves", elasticity, surface, *solver);
  const auto given   = qp::SlipBound::given(1.5e7 * surface.areas());
  const auto coulomb = surface.slip_bound();

  const auto solve = [&](DualMethod &method, const qp::SlipBound &bound) {
    DualProblemVerifier verifier(*Q, bound, surface.areas());
    Found found;
    found.converged = certified_solve(
                        method, *Q, bound, verifier, 1e-9, 1000, "",
                        [](const ContactStep &) {}, found.lambda)
                        .converged;
    return found;
  };

  for (const auto &bound : {given, coulomb})
    {
      const char *law = bound.is_coulomb() ? "coulomb" : "given";
      Newton plain(*Q), forced(*by_solves, 1), inside(*Q, 1);
      const auto best = solve(plain, bound), same = solve(forced, bound),
                 also = solve(inside, bound);
      out() << law << ": newton " << yes(best.converged) << " without fallbacks "
            << yes(plain.statistics().fallbacks == 0) << "; forced to fall back "
            << yes(same.converged) << ", more than twice "
            << yes(forced.statistics().fallbacks > 2) << ", same forces "
            << yes((same.lambda - best.lambda).norm() < 1e-7 * best.lambda.norm())
            << "; forced inside " << yes(also.converged) << ", steps there "
            << yes(inside.statistics().interior_point_steps > 5) << ", same forces "
            << yes((also.lambda - best.lambda).norm() < 1e-7 * best.lambda.norm())
            << std::endl;
    }

  {
    // the energy from h afresh, not from what the method keeps
    Mpgp method(*Q);
    DualIterate iterate{Eigen::VectorXd::Zero(given.n_nodes() * 3),
                        -Q->right_hand_side()};
    DualProblemVerifier verifier(*Q, given, surface.areas());
    const qp::Scaling scaling = verifier.verify(iterate.lambda).scaling();
    double last               = 0.;
    bool falls                = true;
    unsigned int steps        = 0;
    for (; steps < 40; ++steps)
      {
        method.solve(iterate, {given, scaling, {0., 0., 1}});
        const double energy = 0.5 * iterate.lambda.dot(*Q->matrix() * iterate.lambda) -
                              iterate.lambda.dot(Q->right_hand_side());
        falls = falls && energy <= last + 1e-12 * std::abs(last);
        last  = energy;
      }
    out() << "mpgp: the energy falls " << yes(falls && last < 0.) << std::endl;
  }

  {
    CoulombFixedPoint fixed_point(std::make_unique<GaussSeidel>(*Q));
    const bool converged     = solve(fixed_point, coulomb).converged;
    const double contraction = fixed_point.statistics().contraction;
    out() << "fixed point: " << yes(converged) << ", contracts "
          << yes(contraction > 0. && contraction < 0.9) << std::endl;
  }

  try
    {
      Admm admm(*by_solves);
      out() << "admm without a matrix: not refused" << std::endl;
    }
  catch (const std::invalid_argument &)
    {
      out() << "admm without a matrix: refused" << std::endl;
    }
  const Eigen::VectorXd exact = Q->nodal_compliance(),
                        guess = by_solves->nodal_compliance();
  const Eigen::ArrayXd ratio  = guess.cwiseQuotient(exact).array();
  out() << "compliance by one product within a factor of three: "
        << yes(ratio.minCoeff() > 1. / 3. && ratio.maxCoeff() < 3.) << std::endl;

  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      DualProblem problem;
      problem.Q          = *Q->matrix();
      problem.h          = Q->right_hand_side();
      problem.slip_bound = coulomb;
      problem.areas      = surface.areas();
      export_problem("results", problem);
      Newton here(*Q);
      const auto expected = solve(here, coulomb);
      for (const std::string path : {"results/problem.hdf5", "results/Q.mtx"})
        {
          const DualProblem read = import_problem(path);
          const DenseDualOperator R(read.Q, read.h);
          DualProblemVerifier verifier(R, read.slip_bound, read.areas);
          Newton there(R);
          Found found;
          found.converged = certified_solve(
                              there, R, read.slip_bound, verifier, 1e-9, 1000, "",
                              [](const ContactStep &) {}, found.lambda)
                              .converged;
          out() << path << ": " << yes(found.converged) << ", same forces "
                << yes((found.lambda - expected.lambda).norm() <
                       1e-9 * expected.lambda.norm())
                << std::endl;
        }
    }
}
