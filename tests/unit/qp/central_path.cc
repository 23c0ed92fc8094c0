// The central path begins near to forces and their duals: at every node in the scales
// force minus dual remains what it is, products are the square of the residual, and both
// are inside of their cones, for all laws and from answers on; a residual that is too
// small counts as a hundredth.

#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/central_path.h>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

int main()
{
  Random random(1);
  const Index m      = 24;
  const VectorXd all = VectorXd::Ones(m);
  VectorXd some = VectorXd::Zero(m), others = some;
  for (Index i = 0; i < m; ++i)
    (i % 4 == 1 ? some : others)(i) = i % 5 == 2 ? 0. : 1.;
  VectorXd tied_nodes = VectorXd::Zero(m);
  for (Index i = 1; i < m; i += 4)
    tied_nodes(i) = tied;
  const Scaling scaling{random.vector(m, 0.5, 2.), 3.};

  const std::vector<std::pair<std::string, SlipBound>> laws = {
    {"no friction", SlipBound::given(0. * all)},
    {"given friction", SlipBound::given(0.3 * all)},
    {"F = 0.3", SlipBound::coulomb(0.3 * all)},
    {"mixed", SlipBound::mixed(0.3 * some, 0.5 * others)},
    {"some tied", SlipBound::mixed(tied_nodes, 0.5 * others)}};
  for (const auto &[law, bound] : laws)
    {
      Largest moved, wrong_product, wrong_mean;
      bool is_inside = true;
      for (const double residual : {0.1, 0.03, 0.01, 1e-8})
        {
          VectorXd lambda, w;
          choose_solution(random, bound, lambda, w);
          lambda += residual * random.vector(3 * m, -1., 1.);
          w += residual * random.vector(3 * m, -1., 1.);
          CentralPath path(bound, scaling);
          path.begin_near(lambda, w, residual);
          const double mu = std::pow(std::max(residual, 0.01), 2) * path.unit();
          wrong_mean.add(path.mean_product() / mu - 1.);
          for (const Index i : path.bounded())
            for (Index c = 0; c < (path.has_friction(i) ? 3 : 1); ++c)
              {
                const double f = scaling.force(i), d = scaling.displacement_at(i);
                const Index k = i + c * m;
                moved.add((path.lambda()(k) - lambda(k)) / f - (path.w()(k) - w(k)) / d);
              }
          const VectorXd g = bound.at(path.lambda());
          for (const Index i : path.bounded())
            {
              wrong_product.add(path.lambda()(i) * path.w()(i) / mu - 1.);
              is_inside =
                is_inside && path.lambda()(i) > 0. &&
                (!path.has_friction(i) ||
                 std::hypot(path.lambda()(i + m), path.lambda()(i + 2 * m)) < g(i));
            }
        }
      std::cout << law << std::endl;
      print_below("Force minus dual moved by", moved, 1e-9);
      print_below("Products are wrong by", wrong_product, 1e-12);
      print_below("Mean of all products is wrong by", wrong_mean, 1e-9);
      print("Inside of the cones", is_inside);
    }
}
