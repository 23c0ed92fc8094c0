// r rotated squares in place of a circle. Their common part, the regular
// polygon with 4r edges and corners at g/cos(π/4r), is the image of the boxes;
// lift() finds its way back. The box problem that Proportioning solves has the
// solution that projected gradient steps find on the polygon. Against the disc
// a slipping node carries up to 1.0824 (r = 2) or 1.0196 (r = 4) times too
// much, at up to 22.5° or 11.25° aside, and the difference goes to zero as r
// grows.

#include <stiction/qp/operators/spectral_norm.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/rotated_squares.h>
#include <stiction/qp/solvers/proportioning.h>

#include <limits>
#include <stdexcept>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  const double pi = 3.141592653589793;

  // The corners of the polygon, one a column, as geometry says.
  MatrixXd corners(const unsigned int r, const double g)
  {
    MatrixXd result(2, 4 * r);
    for (unsigned int k = 0; k < 4 * r; ++k)
      {
        const double angle = (2. * k + 1.) * pi / (4. * r);
        result.col(k) << std::cos(angle), std::sin(angle);
      }
    return g / std::cos(pi / (4. * r)) * result;
  }

  // Replaces (x1, x2) by the nearest point of the polygon: itself if it is to
  // the left of all edges, otherwise the best of the nearest points of each.
  void project_onto_polygon(double &x1, double &x2, const MatrixXd &corner)
  {
    const Eigen::Vector2d x(x1, x2);
    Eigen::Vector2d best = x;
    double least         = std::numeric_limits<double>::infinity();
    bool inside          = true;
    for (Index k = 0; k < corner.cols(); ++k)
      {
        const Eigen::Vector2d a    = corner.col(k);
        const Eigen::Vector2d edge = corner.col((k + 1) % corner.cols()) - a;
        inside = inside && edge(0) * (x(1) - a(1)) - edge(1) * (x(0) - a(0)) >= 0.;
        const double part       = edge.dot(x - a) / edge.squaredNorm();
        const Eigen::Vector2d y = a + std::min(std::max(part, 0.), 1.) * edge;
        if ((y - x).norm() < least)
          {
            least = (y - x).norm();
            best  = y;
          }
      }
    if (inside)
      return;
    x1 = best(0);
    x2 = best(1);
  }

  void project_onto_polygons(VectorXd &x, const unsigned int r, const VectorXd &g)
  {
    const Index m = g.size();
    for (Index i = 0; i < m; ++i)
      {
        x(i) = std::max(x(i), 0.);
        if (g(i) > 0.)
          project_onto_polygon(x(i + m), x(i + 2 * m), corners(r, g(i)));
        else
          x(i + m) = x(i + 2 * m) = 0.;
      }
  }

  // As qp_tests::reference_solution(), on the polygons.
  VectorXd reference_on_polygons(const MatrixXd &A, const VectorXd &b,
                                 const unsigned int r, const VectorXd &g)
  {
    const double step = 1.9 / A.cwiseAbs().rowwise().sum().maxCoeff();
    VectorXd x        = VectorXd::Zero(b.size()), next;
    for (unsigned int k = 0; k < 1000; ++k)
      {
        next = x - step * (A * x - b);
        project_onto_polygons(next, r, g);
        if (next == x)
          break;
        x.swap(next);
      }
    return x;
  }

  // Forces by the layer under test, from a given start.
  SolverRun solve(const MatrixXd &matrix, const VectorXd &b, const unsigned int r,
                  const VectorXd &g, VectorXd &forces,
                  const ProportioningOptions &options = {})
  {
    const DenseOperator Q(matrix);
    const RotatedSquares squares(r, g);
    const SymmetricOperator A(squares.n_unknowns(),
                              [&](VectorXd &dst, const VectorXd &unknowns) {
                                VectorXd Q_forces;
                                Q.vmult(Q_forces, squares.to_forces(unknowns));
                                dst = squares.pull_back(Q_forces);
                              });
    const HalfLinesTimesBoxes boxes(squares.half_widths(), 2 * r);
    VectorXd mu       = squares.lift(forces);
    VectorXd gradient = squares.pull_back(matrix * squares.to_forces(mu) - b);
    const SolverRun statistics =
      Proportioning(A, boxes, spectral_norm(A), options)
        .solve(mu, gradient, {VectorXd::Ones(g.size()), 1.}, 1e-10, 20000);
    forces = squares.to_forces(mu);
    return statistics;
  }

  void check_set(const unsigned int r)
  {
    Random random(51);
    Largest support, transpose, lifted, infeasible, outside;
    unsigned int inside = 0, beyond = 0;
    for (unsigned int sample = 0; sample < 500; ++sample)
      {
        const Index m = 1 + sample % 3;
        VectorXd g    = random.vector(m, 0.1, 2.);
        if (sample % 10 == 0)
          g(0) = 0.;
        const RotatedSquares squares(r, g);

        // what the boxes reach in a direction, and what the polygon does
        const VectorXd u      = random.vector(3 * m);
        const VectorXd pulled = squares.pull_back(u);
        const VectorXd b      = squares.half_widths();
        const HalfLinesTimesBoxes boxes(b, 2 * r);
        for (Index i = 0; i < m; ++i)
          {
            double reached = 0.;
            for (Index k = i + m; k < pulled.size(); k += m)
              reached += b(i) * std::abs(pulled(k));
            const Eigen::Vector2d direction(u(i + m), u(i + 2 * m));
            const double expected = (corners(r, g(i)).transpose() * direction).maxCoeff();
            support.add(std::abs(reached - expected));
          }

        VectorXd mu = random.vector(squares.n_unknowns(), -3., 3.);
        transpose.add(std::abs(squares.to_forces(mu).dot(u) - mu.dot(pulled)));
        boxes.project(mu);
        VectorXd image = squares.to_forces(mu), again = image;
        project_onto_polygons(again, r, g);
        outside.add((again - image).norm());

        VectorXd forces = random.vector(3 * m, -2., 2.), nearest = forces;
        project_onto_polygons(nearest, r, g);
        for (Index i = 0; i < m; ++i)
          ++(nearest(i + m) == forces(i + m) ? inside : beyond);
        mu = squares.lift(forces);
        lifted.add((squares.to_forces(mu) - nearest).norm());
        VectorXd feasible = mu;
        boxes.project(feasible);
        infeasible.add((feasible - mu).norm());
      }
    std::cout << "Squares: " << r << std::endl;
    print_below("  support function, boxes less polygon", support, 1e-14);
    print_below("  transpose", transpose, 1e-12);
    print_below("  distance of images from the polygon", outside, 1e-14);
    print("  forces to lift inside and outside", inside >= 100 && beyond >= 100);
    print_below("  lifted forces less projected ones", lifted, 1e-14);
    print_below("  lifted forces outside of the boxes", infeasible, 1e-15);
  }

  void check_solutions(const unsigned int r)
  {
    Random random(52);
    unsigned int not_converged = 0, inside = 0, on_edge = 0, open = 0;
    unsigned int warm_products = 0;
    Largest distance, energy_above;
    for (unsigned int sample = 0; sample < 16; ++sample)
      {
        const Index m         = 1 + sample % 3;
        const MatrixXd matrix = random.spd(3 * m, 5.);
        const VectorXd b      = random.vector(3 * m, -1., 2.);
        VectorXd g            = random.vector(m, 0.1, 4.);
        if (sample % 5 == 0)
          g(0) = 0.;
        const VectorXd reference = reference_on_polygons(matrix, b, r, g);
        for (Index i = 0; i < m; ++i)
          {
            const Eigen::Vector2d t(reference(i + m), reference(i + 2 * m));
            ++(t.norm() < 0.99 * g(i) ? inside : on_edge);
            open += reference(i) == 0.;
          }

        for (const ProportioningOptions &options :
             {ProportioningOptions{}, ProportioningOptions{3., true}})
          for (const bool warm : {false, true})
            {
              VectorXd x = warm ? reference : random.vector(3 * m, -3., 3.);
              const SolverRun statistics = solve(matrix, b, r, g, x, options);
              not_converged += !statistics.converged;
              distance.add((x - reference).norm());
              energy_above.add(energy(matrix, b, x) - energy(matrix, b, reference));
              if (warm)
                warm_products += statistics.multiplications;
            }
      }
    std::cout << "Squares: " << r << std::endl;
    print("  nodes inside, nodes on an edge, open nodes",
          inside >= 3 && on_edge >= 10 && open >= 3);
    print_count("  runs that did not converge", not_converged);
    print_below("  distance from the reference", distance, 1e-7);
    print_below("  energy above the reference", energy_above, 1e-10);
    print_count("  products from the solution, lifted", warm_products);
  }

  // One node with Q = I that is pulled far beyond its bound in all directions:
  // on the disc it carries g along the load.
  void check_error(const unsigned int r)
  {
    const VectorXd g      = VectorXd::Constant(1, 2.);
    const MatrixXd matrix = MatrixXd::Identity(3, 3);
    Largest ratio, aside;
    double least = std::numeric_limits<double>::infinity();
    for (unsigned int k = 0; k < 720; ++k)
      {
        const double angle = (k + 0.3) * pi / 360.;
        VectorXd b(3), x = VectorXd::Zero(3);
        b << 1., 1e4 * std::cos(angle), 1e4 * std::sin(angle);
        solve(matrix, b, r, g, x);
        const double carried = std::hypot(x(1), x(2)) / 2.;
        ratio.add(carried);
        least = std::min(least, carried);
        aside.add(std::abs(std::remainder(std::atan2(x(2), x(1)) - angle, 2. * pi)) *
                  180. / pi);
      }
    std::cout << "Squares: " << r << std::endl;
    std::cout << "  largest friction over slip bound: " << ratio.value() << std::endl;
    print("  never below the bound", least >= 1. - 1e-12);
    const double bound = 180. / (4. * r);
    print("  largest angle within half a degree of " + std::to_string(bound),
          aside.value() > bound - 0.5 && aside.value() <= bound + 1e-9);
  }

  void check_limit()
  {
    Random random(53);
    const MatrixXd matrix    = random.spd(12, 5.);
    const VectorXd b         = random.vector(12, -1., 4.);
    const VectorXd g         = random.vector(4, 0.1, 1.);
    const VectorXd reference = reference_solution(matrix, b, 4, g);
    std::cout << "Distance from the solution on discs" << std::endl;
    for (const unsigned int r : {1, 2, 4, 8, 16, 32})
      {
        VectorXd x = VectorXd::Zero(12);
        solve(matrix, b, r, g, x);
        print_below("  squares: " + std::to_string(r) + ", error", (x - reference).norm(),
                    1. / r);
      }
  }

  bool throws(const unsigned int r, const double g)
  {
    try
      {
        RotatedSquares(r, VectorXd::Constant(1, g));
      }
    catch (const std::invalid_argument &)
      {
        return true;
      }
    return false;
  }
} // namespace

int main()
{
  std::cout << "The set" << std::endl;
  for (const unsigned int r : {1, 2, 3, 4, 8})
    check_set(r);
  std::cout << "The solution" << std::endl;
  for (const unsigned int r : {1, 2, 4, 8})
    check_solutions(r);
  std::cout << "A slipping node" << std::endl;
  for (const unsigned int r : {1, 2, 4})
    check_error(r);
  check_limit();
  print("No square, a negative bound, no number: all throw",
        throws(0, 1.) && throws(2, -1.) && throws(2, std::nan("")));
}
