// Whatever its options, Proportioning returns the solution of 1e5 projected gradient
// steps. So does Mpgp, whose one scale a node is a change of variables and nothing else:
// the natural residual it reports is that of the problem as given, and nodes that are
// stretched by powers of two change no bit of its path; nodes of very different
// stiffness cost no more than equal ones. Where a few modes are much stiffer than the
// others the options save a third of the products.

#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/solvers/proportioning.h>

#include "qp_tests.h"

using namespace stiction;
using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  struct Problem
  {
    Problem(Random &random, const Index m, const double condition)
      : A(random.spd(3 * m, condition))
      , b(random.vector(3 * m, -1., 2.))
      , radii(random.vector(m, 0.1, 4.))
      , scaling{VectorXd::Ones(m), 1., VectorXd::Ones(m)}
    {
    }

    // The same problem in the variables D⁻¹x: node i is d_i² times as stiff.
    Problem stretched(const VectorXd &d) const
    {
      Problem other = *this;
      VectorXd all(3 * d.size());
      all << d, d, d;
      other.A              = all.asDiagonal() * A * all.asDiagonal();
      other.b              = all.cwiseProduct(b);
      other.radii          = radii.cwiseQuotient(d);
      other.scaling.force  = scaling.force.cwiseQuotient(d);
      other.scaling.weight = scaling.weight.cwiseProduct(d);
      return other;
    }

    MatrixXd A;
    VectorXd b, radii;
    Scaling scaling;
  };

  SolverRun solve(const Problem &problem, const ProportioningOptions &options,
                  const double tolerance, VectorXd &x, VectorXd &gradient)
  {
    const DenseOperator A(problem.A);
    const HalfLinesTimesDiscs set(problem.radii);
    return Proportioning(A, set, spectral_norm(A), options)
      .solve(x, gradient, problem.scaling, tolerance, 20000);
  }

  struct Found : DualMethodResult, DualIterate
  {
    double products;
  };

  Found solve_by_mpgp(const Problem &problem, const VectorXd &start,
                      const double tolerance)
  {
    const DenseDualOperator Q(problem.A, problem.b);
    Mpgp method(Q);
    Found found{{}, {start, problem.A * start - problem.b}, -Q.n_multiplications()};
    static_cast<DualMethodResult &>(found) = method.solve(
      found, {SlipBound::given(problem.radii), problem.scaling, {tolerance, 1., 1000}});
    found.products += Q.n_multiplications();
    return found;
  }

  // ---------------------------------------------------------- every option
  void check_solutions()
  {
    for (const double gamma : {1., 3.})
      for (const bool spectral : {false, true})
        {
          Random random(41);
          unsigned int not_converged = 0;
          Largest distance, gradient_error;
          for (unsigned int sample = 0; sample < 20; ++sample)
            {
              const Index m = 1 + sample % 4;
              const Problem problem(random, m, 5.);
              const VectorXd reference =
                reference_solution(problem.A, problem.b, m, problem.radii);
              VectorXd x = random.vector(3 * m);
              project(x, m, problem.radii);
              VectorXd r = problem.A * x - problem.b;
              not_converged += !solve(problem, {gamma, spectral}, 1e-10, x, r).converged;
              distance.add((x - reference).norm());
              gradient_error.add((r - (problem.A * x - problem.b)).norm());
            }
          std::cout << "Gamma " << gamma << (spectral ? ", spectral releases" : "")
                    << std::endl;
          print_count("  runs that did not converge", not_converged);
          print_below("  distance from the reference", distance, 1e-8);
          print_below("  error of the gradient", gradient_error, 1e-13);
        }
  }

  // ------------------------------------------------- a change of variables
  void check_change_of_variables()
  {
    Random random(42);
    unsigned int not_converged = 0, other_bits = 0;
    Largest distance, gradient_error, residual;
    for (unsigned int sample = 0; sample < 40; ++sample)
      {
        const Index m = 1 + sample % 4;
        Problem problem(random, m, 5.);
        problem.scaling.force        = random.vector(m, 0.1, 3.);
        problem.scaling.displacement = 0.7;
        if (sample % 2 == 0)
          problem.scaling.weight = random.vector(m, 0.5, 2.);
        VectorXd d(m);
        for (double &stretch : d)
          stretch = std::ldexp(1., random.integer(21) - 10); // does not round
        const VectorXd start = random.vector(3 * m), all = d.replicate(3, 1);

        const Found other =
          solve_by_mpgp(problem.stretched(d), start.cwiseQuotient(all), 1e-10);
        if (sample % 2 == 1)
          problem.scaling.weight.resize(0); // which means the same
        const Found found = solve_by_mpgp(problem, start, 1e-10);
        const VectorXd &x = found.lambda, &r = found.gradient;
        not_converged += !found.converged;
        distance.add(
          (x - reference_solution(problem.A, problem.b, m, problem.radii)).norm());
        gradient_error.add((r - (problem.A * x - problem.b)).norm());
        residual.add(std::abs(
          found.residual -
          HalfLinesTimesDiscs(problem.radii).natural_residual(x, r, problem.scaling)));
        other_bits +=
          other.products != found.products || other.residual != found.residual ||
          other.lambda.cwiseProduct(all) != x || other.gradient.cwiseQuotient(all) != r;
      }
    std::cout << "Mpgp" << std::endl;
    print_count("  runs that did not converge", not_converged);
    print_below("  distance from the reference", distance, 1e-8);
    print_below("  error of the gradient", gradient_error, 1e-13);
    print_below("  change of the natural residual", residual, 1e-13);
    print_count("  runs with stretched nodes that differ", other_bits);
  }

  unsigned int products(const Problem &problem, const ProportioningOptions &options)
  {
    VectorXd x = VectorXd::Zero(problem.b.size()), r = -problem.b;
    return solve(problem, options, 1e-8, x, r).multiplications;
  }

  // --------------------------------------------------------------- its use
  void check_products()
  {
    Random random(43);
    double plain = 0., scaled = 0., equal = 0.;
    for (unsigned int sample = 0; sample < 10; ++sample)
      {
        const Index m = 10;
        const Problem problem(random, m, 20.);
        VectorXd d(m);
        for (double &stretch : d)
          stretch = random.log_uniform(0.1, 10.);
        const Problem uneven = problem.stretched(d);
        const VectorXd zero  = VectorXd::Zero(3 * m);
        plain += products(uneven, {6., true});
        scaled += solve_by_mpgp(uneven, zero, 1e-8).products;
        equal += products(problem, {6., true});
      }
    std::cout << "Ten nodes, their stiffness spread over four decades" << std::endl;
    print("  scaling saves over 90 % of the products", scaled < 0.1 * plain);
    print("  and they are about those of nodes of like stiffness",
          scaled < 1.5 * equal && equal < 1.5 * scaled);

    // The spectrum of a contact problem: a few modes are much stiffer than all
    // others, and a fixed step is made for those.
    unsigned int fixed = 0, spectral = 0;
    for (unsigned int sample = 0; sample < 10; ++sample)
      {
        const Index m  = 20;
        VectorXd modes = random.vector(3 * m, 0.002, 0.02);
        modes.head(3).setOnes();
        Problem problem(random, m, 2.);
        problem.A = random.symmetric(modes);
        problem.b *= 0.02;
        fixed += products(problem, {});
        spectral += products(problem, {3., true});
      }
    std::cout << "Twenty nodes, a few stiff modes" << std::endl;
    print("  the options save over a third of the products", 3 * spectral < 2 * fixed);
  }
} // namespace

int main()
{
  check_solutions();
  check_change_of_variables();
  check_products();
}
