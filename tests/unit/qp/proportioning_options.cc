// Whatever its options, and with one scale a node or without, Proportioning
// returns the solution of 1e5 projected gradient steps. Scaling is a change of
// variables and nothing else: vectors come back from it, the natural residual
// is the same number before and after, one scale for all nodes changes no
// product, and the scales of from_diagonal() make nodes of very different
// stiffness cost no more than equal ones. Where a few modes are much stiffer
// than the others the options save a third of the products.

#include <stiction/qp/operators/nodal_scaling.h>
#include <stiction/qp/operators/scaled_operator.h>
#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include <limits>
#include <stdexcept>

#include "qp_tests.h"

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
      , scaling{VectorXd::Ones(m), 1.}
    {
    }

    // The same problem in the variables D⁻¹x: node i is d_i² times as stiff.
    Problem stretched(const VectorXd &d) const
    {
      Problem other = *this;
      VectorXd all(3 * d.size());
      all << d, d, d;
      other.A             = all.asDiagonal() * A * all.asDiagonal();
      other.b             = all.cwiseProduct(b);
      other.radii         = radii.cwiseQuotient(d);
      other.scaling.force = scaling.force.cwiseQuotient(d);
      return other;
    }

    MatrixXd A;
    VectorXd b, radii;
    Scaling scaling;
  };

  SolverRun solve(const Problem &problem, const ProportioningOptions &options,
                  const NodalScaling *const nodal, const double tolerance, VectorXd &x,
                  VectorXd &gradient)
  {
    const DenseOperator A(problem.A);
    if (nodal == nullptr)
      {
        const HalfLinesTimesDiscs set(problem.radii);
        return Proportioning(A, set, spectral_norm(A), options)
          .solve(x, gradient, problem.scaling, tolerance, 20000);
      }
    const ScaledOperator DAD(A, *nodal);
    const HalfLinesTimesDiscs set(nodal->divide(problem.radii));
    VectorXd y = nodal->divide(x), Dr = nodal->times(gradient);
    const SolverRun statistics =
      Proportioning(DAD, set, spectral_norm(DAD), options)
        .solve(y, Dr, nodal->scaled(problem.scaling), tolerance, 20000);
    x        = nodal->times(y);
    gradient = nodal->divide(Dr);
    return statistics;
  }

  bool throws(const VectorXd &scales)
  {
    try
      {
        NodalScaling nodal(scales);
      }
    catch (const std::invalid_argument &)
      {
        return true;
      }
    return false;
  }

  // ---------------------------------------------- every option, every scale
  void check_solutions()
  {
    for (const double gamma : {1., 3.})
      for (const bool spectral : {false, true})
        for (const bool projected : {false, true})
          for (const bool scaled : {false, true})
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
                  const NodalScaling nodal(random.vector(m, 0.5, 2.));
                  VectorXd x = random.vector(3 * m);
                  project(x, m, problem.radii);
                  VectorXd r = problem.A * x - problem.b;
                  not_converged += !solve(problem, {gamma, spectral, projected},
                                          scaled ? &nodal : nullptr, 1e-10, x, r)
                                      .converged;
                  distance.add((x - reference).norm());
                  gradient_error.add((r - (problem.A * x - problem.b)).norm());
                }
              std::cout << "Gamma " << gamma << (spectral ? ", spectral releases" : "")
                        << (projected ? ", projected expansions" : "")
                        << (scaled ? ", scaled" : "") << std::endl;
              print_count("  runs that did not converge", not_converged);
              print_below("  distance from the reference", distance, 1e-8);
              print_below("  error of the gradient", gradient_error, 1e-13);
            }
  }

  // ------------------------------------------------- a change of variables
  void check_change_of_variables()
  {
    Random random(42);
    Largest residual, forth_and_back, product;
    for (unsigned int sample = 0; sample < 200; ++sample)
      {
        const Index m = 1 + sample % 6;
        const Problem problem(random, m, 10.);
        VectorXd d(m);
        for (double &scale : d)
          scale = random.log_uniform(1e-3, 1e3);
        const NodalScaling nodal(d), other(random.vector(m, 0.5, 2.));

        const HalfLinesTimesDiscs set(problem.radii);
        const HalfLinesTimesDiscs scaled_set(nodal.divide(problem.radii));
        const HalfLinesTimesDiscs twice_set(other.divide(nodal.divide(problem.radii)));
        VectorXd x = random.vector(3 * m, -2., 4.);
        set.project(x);
        const VectorXd r = problem.A * x - problem.b;
        const Scaling units{random.vector(m, 0.1, 3.), 0.7};
        const double before = set.natural_residual(x, r, units);
        const double once   = scaled_set.natural_residual(nodal.divide(x), nodal.times(r),
                                                          nodal.scaled(units));
        const double twice  = twice_set.natural_residual(
           other.divide(nodal.divide(x)), other.times(nodal.times(r)),
           other.scaled(nodal.scaled(units)));
        residual.add(std::abs(once - before) / before);
        residual.add(std::abs(twice - before) / before);
        forth_and_back.add((nodal.times(nodal.divide(x)) - x).norm());

        // D A D by hand
        const DenseOperator A(problem.A);
        const ScaledOperator DAD(A, nodal);
        VectorXd result;
        DAD.vmult(result, r);
        VectorXd all(3 * m);
        all << d, d, d;
        const VectorXd expected = all.asDiagonal() * (problem.A * (all.asDiagonal() * r));
        product.add((result - expected).norm() / expected.norm());
      }
    std::cout << "A change of variables" << std::endl;
    print_below("  relative change of the natural residual", residual, 1e-12);
    print_below("  points that do not come back", forth_and_back, 1e-14);
    print_below("  relative error of D A D", product, 1e-13);

    const double inf = std::numeric_limits<double>::infinity();
    print("  scales that are zero, negative, infinite or no number throw",
          throws(VectorXd::Zero(1)) && throws(VectorXd::Constant(2, -1.)) &&
            throws(VectorXd::Constant(1, inf)) &&
            throws(VectorXd::Constant(1, std::nan(""))));
    print("  a scale of one does not", !throws(VectorXd::Ones(3)));
  }

  unsigned int products(const Problem &problem, const ProportioningOptions &options,
                        const NodalScaling *const nodal)
  {
    VectorXd x = VectorXd::Zero(problem.b.size()), r = -problem.b;
    return solve(problem, options, nodal, 1e-8, x, r).multiplications;
  }

  // --------------------------------------------------------------- its use
  void check_products()
  {
    Random random(43);
    unsigned int other_bits = 0;
    unsigned int plain = 0, scaled = 0, equal = 0;
    Largest mean_diagonal;
    for (unsigned int sample = 0; sample < 10; ++sample)
      {
        const Index m = 10;
        const Problem problem(random, m, 20.);
        VectorXd d(m);
        for (double &stretch : d)
          stretch = random.log_uniform(0.1, 10.);
        const Problem uneven     = problem.stretched(d);
        const NodalScaling nodal = NodalScaling::from_diagonal(uneven.A.diagonal(), m);
        for (Index i = 0; i < m; ++i)
          mean_diagonal.add(std::abs(
            nodal.scales()(i) * nodal.scales()(i) *
              (uneven.A(i, i) + uneven.A(i + m, i + m) + uneven.A(i + 2 * m, i + 2 * m)) /
              3. -
            1.));

        const ProportioningOptions literature{1., false, false};
        plain += products(uneven, literature, nullptr);
        scaled += products(uneven, literature, &nodal);
        equal += products(problem, literature, nullptr);

        // powers of two do not round
        const NodalScaling fourfold(VectorXd::Constant(m, 4.));
        other_bits += products(problem, {}, nullptr) != products(problem, {}, &fourfold);
      }
    std::cout << "Ten nodes, their stiffness spread over four decades" << std::endl;
    print_below("  mean diagonal entry minus one", mean_diagonal, 1e-14);
    print("  scaling saves over 90 % of the products", scaled < 0.1 * plain);
    print("  and they are about those of nodes of like stiffness",
          scaled < 1.5 * equal && equal < 1.5 * scaled);
    print_count("  runs with one scale for all that differ", other_bits);

    // The spectrum of a contact problem: a few modes are much stiffer than all
    // others, and a fixed step is made for those.
    unsigned int literature = 0, improved = 0;
    for (unsigned int sample = 0; sample < 10; ++sample)
      {
        const Index m  = 20;
        VectorXd modes = random.vector(3 * m, 0.002, 0.02);
        modes.head(3).setOnes();
        Problem problem(random, m, 2.);
        problem.A = random.symmetric(modes);
        problem.b *= 0.02;
        literature += products(problem, {1., false, false}, nullptr);
        improved += products(problem, {3., true, true}, nullptr);
      }
    std::cout << "Twenty nodes, a few stiff modes" << std::endl;
    print("  the options save over a third of the products",
          3 * improved < 2 * literature);
  }
} // namespace

int main()
{
  check_solutions();
  check_change_of_variables();
  check_products();
}
