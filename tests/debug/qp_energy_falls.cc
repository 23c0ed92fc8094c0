// "No step raises the dual energy" is an assertion of ActiveSetMethod. Here it
// is switched on: every method runs random problems, easy and hard ones, with
// norms that are right and too small, down to rounding. A method that breaks
// the rule is there to show that the assertion can fail.
//
// Returns 0 if all went well; an assertion that fails aborts.

#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/methods/squares.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/solvers/disc_active_set.h>
#include <stiction/qp/solvers/proportioning.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

#include "qp_tests.h"

#ifdef NDEBUG
#  error "without assertions this test tests nothing"
#endif

using namespace stiction;
using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  // Makes a method for a Hessian, radii and an estimate of the norm; the set
  // it works on stays alive with it.
  struct Method
  {
    std::unique_ptr<FeasibleSet> set;
    std::unique_ptr<ActiveSetMethod> solver;
  };

  using Make = std::function<Method(const SymmetricOperator &, const VectorXd &, double)>;

  struct Candidate
  {
    const char *name;
    Index n_components;
    Make make;
  };

  Make disc_active_set(const DiscActiveSet::Variant variant)
  {
    return
      [variant](const SymmetricOperator &A, const VectorXd &radii, const double norm) {
        auto discs  = std::make_unique<Discs>(radii);
        auto solver = std::make_unique<DiscActiveSet>(A, *discs, norm, variant);
        return Method{std::move(discs), std::move(solver)};
      };
  }

  Make proportioning(
    const std::function<std::unique_ptr<FeasibleSet>(const VectorXd &)> &make,
    const ProportioningOptions &options = {})
  {
    return [make, options](const SymmetricOperator &A, const VectorXd &radii,
                           const double norm) {
      auto set    = make(radii);
      auto solver = std::make_unique<Proportioning>(A, *set, norm, options);
      return Method{std::move(set), std::move(solver)};
    };
  }

  std::vector<Candidate> candidates()
  {
    const auto half_lines = [](const VectorXd &radii) {
      return std::make_unique<HalfLines>(VectorXd::Zero(radii.size()));
    };
    const auto discs = [](const VectorXd &radii) {
      return std::make_unique<Discs>(radii);
    };
    const auto product = [](const VectorXd &radii) {
      return std::make_unique<HalfLinesTimesDiscs>(radii);
    };
    const auto boxes = [](const VectorXd &half_widths) {
      return std::make_unique<HalfLinesTimesBoxes>(half_widths, 4);
    };
    const ProportioningOptions improved{3., true};
    using Variant = DiscActiveSet::Variant;
    return {
      {"as_printed", 2, disc_active_set(Variant::as_printed)},
      {"with_expansion", 2, disc_active_set(Variant::with_expansion)},
      {"with_proportioning", 2, disc_active_set(Variant::with_proportioning)},
      {"with_projected_release", 2, disc_active_set(Variant::with_projected_release)},
      {"robust", 2, disc_active_set(Variant::robust)},
      {"spectral", 2, disc_active_set(Variant::spectral)},
      {"half-lines", 1, proportioning(half_lines)},
      {"discs", 2, proportioning(discs)},
      {"half-lines times discs", 3, proportioning(product)},
      {"half-lines times boxes", 5, proportioning(boxes)},
      {"half-lines, improved", 1, proportioning(half_lines, improved)},
      {"half-lines times discs, improved", 3, proportioning(product, improved)},
      {"half-lines times boxes, improved", 5, proportioning(boxes, improved)}};
  }

  // Runs that must not abort; returns whether all of them ended well.
  bool run(const Candidate &candidate)
  {
    Random random(31);
    unsigned int not_finite = 0, products = 0;
    for (unsigned int sample = 0; sample < 60; ++sample)
      for (const double condition : {3., 1e4, 1e8})
        for (const double norm : {1., 0.3})
          for (const double tolerance : {1e-8, 0.})
            {
              const Index m         = 1 + sample % 7;
              const Index n         = candidate.n_components * m;
              const MatrixXd matrix = random.spd(n, condition);
              const VectorXd b      = random.vector(n, -1., 2.);
              VectorXd radii        = random.vector(m, 0.01, 3.);
              if (sample % 5 == 0)
                radii(0) = 0.;
              const DenseOperator A(matrix);
              const Method method = candidate.make(A, radii, norm);

              VectorXd x = random.vector(n, -3., 3.);
              method.set->project(x);
              VectorXd r = matrix * x - b;
              products +=
                method.solver->solve(x, r, {VectorXd::Ones(m), 1.}, tolerance, 300)
                  .multiplications;
              not_finite += !(x.allFinite() && r.allFinite());
            }
    std::cout << candidate.name << ": " << products << " products, " << not_finite
              << " results with a NaN" << std::endl;
    return not_finite == 0 && products > 1000;
  }

  // The methods with Hessians of their own: scaled, and that of the squares, which is
  // singular.
  bool run_other_formulations()
  {
    Random random(32);
    unsigned int not_finite = 0;
    double products         = 0.;
    for (unsigned int sample = 0; sample < 120; ++sample)
      for (const double condition : {3., 1e4})
        for (const double tolerance : {1e-8, 0.})
          {
            const Index m         = 1 + sample % 5;
            const MatrixXd matrix = random.spd(3 * m, condition);
            const DenseDualOperator Q(matrix, random.vector(3 * m, -1., 2.));
            const SlipBound bound = SlipBound::given(random.vector(m, 0.01, 3.));
            Mpgp scaled(Q);
            Squares squares(Q, 1 + sample % 4);
            for (DualMethod *const method : std::vector<DualMethod *>{&scaled, &squares})
              {
                DualIterate iterate{VectorXd::Zero(3 * m), -Q.right_hand_side()};
                method->solve(iterate,
                              {bound, {VectorXd::Ones(m), 1.}, {tolerance, 1., 15}});
                not_finite +=
                  !(iterate.lambda.allFinite() && iterate.gradient.allFinite());
              }
            products += Q.n_multiplications();
          }
    std::cout << "scaled, and rotated squares: " << products << " products, "
              << not_finite << " results with a NaN" << std::endl;
    return not_finite == 0 && products > 1000.;
  }

  // Releases by a step three times too long, and does not look at the result.
  class Overshooting : public Proportioning
  {
  public:
    using Proportioning::Proportioning;

  protected:
    void release() override
    {
      const VectorXd d = -3. * fixed_step_ * chopped_;
      VectorXd Ad;
      A_.vmult(Ad, d);
      x_ += d;
      gradient_ += Ad;
    }
  };

  // Whether the assertion ends this run, in a process of its own.
  bool overshooting_aborts()
  {
    std::cout << std::flush;
    const pid_t child = fork();
    if (child == 0)
      {
        // its message is expected: keep it from the screen
        if (std::freopen("/dev/null", "w", stderr) == nullptr)
          _exit(1);
        const MatrixXd matrix = MatrixXd::Identity(1, 1);
        const DenseOperator A(matrix);
        const HalfLines half_line(VectorXd::Zero(1));
        VectorXd x = VectorXd::Zero(1), r = VectorXd::Constant(1, -1.);
        Overshooting(A, half_line, 1.).solve(x, r, {VectorXd::Ones(1), 1.}, 1e-8, 10);
        _exit(0);
      }
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && WIFSIGNALED(status) &&
           WTERMSIG(status) == SIGABRT;
  }
} // namespace

int main()
{
  bool good = true;
  for (const Candidate &candidate : candidates())
    good = run(candidate) && good;

  good = run_other_formulations() && good;

  const bool aborts = overshooting_aborts();
  print("A method that raises the energy is stopped", aborts);
  return good && aborts ? 0 : 1;
}
