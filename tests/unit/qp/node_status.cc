// A problem made for its answer: contact forces and gaps are chosen, nodes of
// every status among them and a third exactly at each switch, and h = Qλ − r.
// However a method came to its answer and however exact it is, what lies at a
// switch is undecided, and everything else is what it is. What is not a number
// is undecided, too.

#include <stiction/contact/dual/contact_solver_parameters.h>
#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/qp/certified_solve.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/dual_operator.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/verifier.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>

using namespace stiction;

namespace
{
  const char *yes(const bool condition) { return condition ? "yes" : "NO"; }

  // Contact nodes on a grid, of which each gives way to the forces at the
  // others by 1/√(r² + 1/4), in directions that are coupled.
  Eigen::MatrixXd compliance(const Eigen::Index n)
  {
    const Eigen::Index m = n * n;
    Eigen::MatrixXd kernel(m, m), Q(3 * m, 3 * m);
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < m; ++j)
        kernel(i, j) = 1e-9 / std::hypot(i % n - j % n, std::hypot(i / n - j / n, 0.5));
    Eigen::Matrix3d coupling;
    coupling << 1., .2, .1, .2, .8, .1, .1, .1, .9;
    for (unsigned int r = 0; r < 3; ++r)
      for (unsigned int c = 0; c < 3; ++c)
        Q.block(r * m, c * m, m, m) = coupling(r, c) * kernel;
    return Q;
  }

  constexpr NormalStatus normal_statuses[] = {NormalStatus::open, NormalStatus::closed,
                                              NormalStatus::undecided};
  constexpr TangentialStatus tangential_statuses[] = {
    TangentialStatus::slip, TangentialStatus::stick, TangentialStatus::undecided};

  struct Problem
  {
    Eigen::VectorXd lambda, r;
    qp::SlipBound slip_bound;
    std::vector<NodeStatus> expected;
  };

  // F < 0: given friction.
  Problem make(const Eigen::MatrixXd &Q, const double F)
  {
    static std::mt19937 generator(7);
    std::uniform_real_distribution<double> size(0.1, 1.), angle(0., 6.28);
    const Eigen::Index m = Q.rows() / 3;
    const double far     = Q.topLeftCorner(m, m).rowwise().sum().mean(); // 1 N each

    Problem problem;
    problem.lambda = problem.r = Eigen::VectorXd::Zero(3 * m);
    Eigen::VectorXd given(m);
    for (Eigen::Index i = 0; i < m; ++i)
      {
        NodeStatus status{normal_statuses[generator() % 3],
                          tangential_statuses[generator() % 3]};
        const double phi = angle(generator);
        const Eigen::Vector2d direction(std::cos(phi), std::sin(phi));
        if (status.normal == NormalStatus::closed)
          problem.lambda(i) = size(generator);
        if (status.normal == NormalStatus::open)
          problem.r(i) = size(generator) * far;
        given(i)        = size(generator);
        const double g  = F < 0. ? given(i) : F * problem.lambda(i);
        double friction = g, slip = 0.;
        if (status.tangential == TangentialStatus::stick)
          friction *= 0.5 * size(generator);
        if (status.tangential == TangentialStatus::slip)
          slip = size(generator) * far;
        set_at_node(
          problem.lambda, i,
          {problem.lambda(i), friction * direction(0), friction * direction(1)});
        set_at_node(problem.r, i,
                    {problem.r(i), -slip * direction(0), -slip * direction(1)});
        // friction that needs pressure
        if (F == 0. || (F > 0. && status.normal == NormalStatus::open))
          status.tangential = TangentialStatus::none;
        else if (F > 0. && status.normal == NormalStatus::undecided)
          status.tangential = TangentialStatus::undecided;
        problem.expected.push_back(status);
      }
    problem.slip_bound = F < 0. ? qp::SlipBound::given(given)
                                : qp::SlipBound::coulomb(Eigen::VectorXd::Constant(m, F));
    return problem;
  }

  unsigned int n_wrong(const std::vector<NodeStatus> &found,
                       const std::vector<NodeStatus> &expected)
  {
    unsigned int n = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
      n += found[i].normal != expected[i].normal ||
               found[i].tangential != expected[i].tangential
             ? 1
             : 0;
    return n;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Eigen::MatrixXd matrix = compliance(7);
  for (const double F : {-1., 0., 0.3, 1.})
    for (const std::string method : {"gauss seidel", "newton", "mpgp", "admm"})
      for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10})
        {
          const Problem problem = make(matrix, F);
          const DenseDualOperator Q(matrix, matrix * problem.lambda - problem.r);
          ContactSolverParameters parameters;
          parameters.method    = method;
          parameters.tolerance = tolerance;
          const auto solver    = create_dual_method(parameters, Q, F >= 0.);
          DualProblemVerifier verifier(Q, problem.slip_bound, {});
          Eigen::VectorXd lambda;
          const auto status = certified_solve(
            *solver, Q, problem.slip_bound, verifier, tolerance, 2000, "",
            [](const ContactStep &) {}, lambda);
          const Eigen::VectorXd stiffness = Q.nodal_compliance().cwiseInverse();
          const auto statuses = node_statuses(verifier.verify(lambda), problem.slip_bound,
                                              stiffness, tolerance);
          if (F < 0.)
            std::cout << "given friction, ";
          else
            std::cout << "F = " << F << ", ";
          std::cout << method << ", " << tolerance << ": certified "
                    << yes(status.converged) << ", nodes with a wrong status "
                    << n_wrong(statuses, problem.expected) << std::endl;
          if (F != 0.3 || tolerance != 1e-10 || method != "newton")
            continue;

          // the same of an answer that is less exact than it should be
          Eigen::VectorXd spoilt = lambda;
          for (Eigen::Index i = 0; i < spoilt.size(); ++i)
            spoilt(i) *= 1. + 1e-4 * std::sin(7. * static_cast<double>(i));
          const auto loose = node_statuses(verifier.verify(spoilt), problem.slip_bound,
                                           stiffness, tolerance);
          unsigned int contradictions = 0, decided = 0;
          for (std::size_t i = 0; i < loose.size(); ++i)
            if (loose[i].normal != NormalStatus::undecided)
              {
                ++decided;
                contradictions += loose[i].normal != problem.expected[i].normal ? 1 : 0;
              }
          std::cout << "spoilt: some nodes decided " << yes(decided > 10) << ", wrongly "
                    << contradictions << std::endl;
          spoilt(5)          = std::numeric_limits<double>::quiet_NaN();
          bool all_undecided = true;
          for (const auto status : node_statuses(
                 verifier.verify(spoilt), problem.slip_bound, stiffness, tolerance))
            all_undecided = all_undecided && status.is_undecided();
          std::cout << "a force that is none: all undecided " << yes(all_undecided)
                    << std::endl;
        }
}
