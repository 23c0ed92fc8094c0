// What solve() promises of every method: the energy never rises from one
// product to the next, the gradient it returns is Ax − b, the number of
// products is counted and bounded, an optimal start or an empty problem costs
// none, a second run of the same object is like the first, and a change of
// units changes no bit of the iterates.

#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/disc_active_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include <memory>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  enum class Method
  {
    half_lines,
    discs,
    product,
    as_printed,
    with_expansion,
    with_proportioning,
    with_projected_release,
    robust,
    spectral
  };

  const Method all_methods[] = {Method::half_lines,
                                Method::discs,
                                Method::product,
                                Method::as_printed,
                                Method::with_expansion,
                                Method::with_proportioning,
                                Method::with_projected_release,
                                Method::robust,
                                Method::spectral};

  const char *const names[] = {"Proportioning on half-lines",
                               "Proportioning on discs",
                               "Proportioning on half-lines times discs",
                               "DiscActiveSet as_printed",
                               "DiscActiveSet with_expansion",
                               "DiscActiveSet with_proportioning",
                               "DiscActiveSet with_projected_release",
                               "DiscActiveSet robust",
                               "DiscActiveSet spectral"};

  // A problem on m nodes for one method, and a run of that method on it.
  struct Problem
  {
    Problem(const Method the_method, const Index m, Random &random)
      : method(the_method)
      , n_components(method == Method::half_lines ? 1
                     : method == Method::product  ? 3
                                                  : 2)
      , A(random.spd(n_components * m, 1e4))
      , b(random.vector(n_components * m))
      , radii(random.vector(m, 0.1, 10.))
      , start(random.vector(n_components * m, -2., 2.))
      , scaling{VectorXd::Ones(m), 1.}
    {
      set()->project(start);
    }

    std::unique_ptr<FeasibleSet> set() const
    {
      if (method == Method::half_lines)
        return std::make_unique<HalfLines>(VectorXd::Zero(radii.size()));
      if (method == Method::product)
        return std::make_unique<HalfLinesTimesDiscs>(radii);
      return std::make_unique<Discs>(radii);
    }

    std::unique_ptr<ActiveSetMethod> solver(const SymmetricOperator &op,
                                            const FeasibleSet &feasible) const
    {
      if (method == Method::half_lines || method == Method::discs ||
          method == Method::product)
        return std::make_unique<Proportioning>(op, feasible, norm);
      const int variant = static_cast<int>(method) - static_cast<int>(Method::as_printed);
      return std::make_unique<DiscActiveSet>(
        op, static_cast<const Discs &>(feasible), norm,
        static_cast<DiscActiveSet::Variant>(variant));
    }

    SolverRun solve(const SymmetricOperator &op, VectorXd &x, VectorXd &gradient,
                    const double tolerance, const unsigned int max_multiplications) const
    {
      const auto feasible = set();
      return solver(op, *feasible)
        ->solve(x, gradient, scaling, tolerance, max_multiplications);
    }

    Method method;
    double norm = 1.; // of A, at most
    Index n_components;
    MatrixXd A;
    VectorXd b, radii, start;
    Scaling scaling;
  };

  void check(const Method method)
  {
    Random random(11);
    Largest rise, gradient_error, infeasible;
    unsigned int too_many = 0, miscounted = 0, did_not_fall = 0;
    unsigned int products_at_optimum = 0, moved_at_optimum = 0;
    unsigned int other_bits = 0, compared = 0, not_repeated = 0;
    for (unsigned int sample = 0; sample < 40; ++sample)
      {
        const Problem problem(method, 2 + sample % 10, random);
        const DenseOperator A(problem.A);
        const auto set = problem.set();

        // ------------------ runs cut after 0, 1, 2, ... products are the
        // ------------------ beginnings of one another
        const double first = energy(problem.A, problem.b, problem.start);
        double before      = first;
        for (unsigned int max = 0; max <= 60; ++max)
          {
            VectorXd x = problem.start, r = problem.A * x - problem.b;
            const unsigned long counter = A.n_multiplications();
            const SolverRun statistics  = problem.solve(A, x, r, 1e-6, max);
            const double now            = energy(problem.A, problem.b, x);
            rise.add((now - before) / (1. + std::abs(first)));
            before = now;

            miscounted += (statistics.multiplications != A.n_multiplications() - counter);
            // A step that was begun is finished: up to two products more.
            too_many += (statistics.multiplications > (max > 0 ? max + 2 : 0));
            gradient_error.add((r - (problem.A * x - problem.b)).norm() /
                               (1. + x.norm()));
            VectorXd projected = x;
            project(projected, problem.n_components != 2 ? problem.radii.size() : 0,
                    problem.n_components != 1 ? problem.radii : VectorXd(0));
            infeasible.add((x - projected).norm() / (1. + x.norm()));
            miscounted +=
              (statistics.residual != set->natural_residual(x, r, problem.scaling));
            miscounted += (statistics.converged != (statistics.residual <= 1e-6));
          }
        did_not_fall += !(before < first - 1e-2);

        // ------------------------------------------------ an optimal start
        {
          Problem optimal = problem;
          VectorXd r      = VectorXd::Zero(optimal.b.size());
          for (Index i = 0; i < optimal.radii.size(); ++i)
            {
              const Index t = i + (optimal.n_components - 2) * optimal.radii.size();
              const Index s = t + optimal.radii.size();
              if (optimal.n_components != 2 && optimal.start(i) == 0.)
                r(i) = 0.7;
              if (optimal.n_components != 1 &&
                  std::hypot(optimal.start(t), optimal.start(s)) >
                    0.999 * optimal.radii(i))
                {
                  r(t) = -0.7 * optimal.start(t);
                  r(s) = -0.7 * optimal.start(s);
                }
            }
          optimal.b  = optimal.A * optimal.start - r;
          VectorXd x = optimal.start;
          products_at_optimum += optimal.solve(A, x, r, 1e-12, 1000).multiplications;
          moved_at_optimum += (x != optimal.start);
        }

        // --------------------------------------- the same object once more
        {
          const auto solver = problem.solver(A, *set);
          VectorXd x[2]     = {problem.start, problem.start};
          for (VectorXd &run : x)
            {
              VectorXd r = problem.A * run - problem.b;
              solver->solve(run, r, problem.scaling, 1e-6, 20);
            }
          not_repeated += (x[0] != x[1]);
        }

        // ------------------------------------------------------ other units
        for (const unsigned int max : {1u, 3u, 10u, 40u})
          {
            VectorXd x0               = problem.start;
            VectorXd r0               = problem.A * x0 - problem.b;
            const SolverRun reference = problem.solve(A, x0, r0, 1e-6, max);

            // lengths by `length`, forces by `force`
            for (const double length : {1., std::ldexp(1., 20)})
              for (const double force : {1., std::ldexp(1., -30)})
                {
                  Problem other = problem;
                  other.A *= length / force;
                  other.norm *= length / force;
                  other.b *= length;
                  other.radii *= force;
                  other.start *= force;
                  other.scaling.force *= force;
                  other.scaling.displacement *= length;
                  VectorXd x = other.start, r = other.A * x - other.b;
                  const DenseOperator B(other.A);
                  const SolverRun statistics = other.solve(B, x, r, 1e-6, max);
                  ++compared;
                  other_bits += (x != force * x0 || r != length * r0 ||
                                 statistics.residual != reference.residual ||
                                 statistics.multiplications != reference.multiplications);
                }
          }
      }

    std::cout << names[static_cast<int>(method)] << std::endl;
    print_below("  largest relative rise of the energy", rise, 1e-13);
    print_count("  problems whose energy did not fall", did_not_fall);
    print_below("  largest relative error of the gradient", gradient_error, 1e-13);
    print_below("  largest relative distance from the set", infeasible, 1e-14);
    print_count("  wrong statistics", miscounted);
    print_count("  runs with too many products", too_many);
    print_count("  products from an optimal start", products_at_optimum);
    print_count("  optimal starts that were moved", moved_at_optimum);
    print_count("  second runs by the same object that differ", not_repeated);
    print_count("  runs in other units with other bits", other_bits);
    print("  of hundreds compared", compared >= 100);

    // ----------------------------------------------------- nothing to solve
    const Problem empty(method, 0, random);
    const DenseOperator A(empty.A);
    VectorXd x(0), r(0);
    const SolverRun statistics = empty.solve(A, x, r, 0., 10);
    print("  an empty problem is solved by no product",
          statistics.converged && statistics.multiplications == 0 &&
            statistics.residual == 0.);
  }
} // namespace

int main()
{
  for (const Method method : all_methods)
    check(method);
}
