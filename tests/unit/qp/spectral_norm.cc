// spectral_norm() is an upper estimate of the largest eigenvalue, sharp to a
// few per cent: never more than 1 % below it (the steps of length 1.9/norm
// are then below 2/‖A‖), never more than 10 % above, always the same, and
// independent of the unit of A.

#include <stiction/qp/operators/spectral_norm.h>

#include "qp_tests.h"

using namespace stiction::qp;
using namespace qp_tests;

namespace
{
  // Estimates over true values, and what they cost.
  struct Ratios
  {
    void add(const MatrixXd &matrix, const double largest_eigenvalue)
    {
      const DenseOperator A(matrix);
      const double norm  = spectral_norm(A);
      const double ratio = norm / largest_eigenvalue;
      below.add(1. - ratio);
      above.add(ratio - 1.);
      products.add(static_cast<double>(A.n_multiplications()));
      differ += (spectral_norm(DenseOperator(matrix)) != norm);
      for (const int power : {-60, -30, 1, 60})
        {
          const MatrixXd scaled = std::ldexp(1., power) * matrix;
          const double other    = spectral_norm(DenseOperator(scaled));
          units.add(std::abs(std::ldexp(other, -power) / norm - 1.));
        }
      ++n;
    }

    void print_all(const std::string &name) const
    {
      std::cout << name << ", " << n << " matrices" << std::endl;
      print_below("  largest part that is missing", below, 0.01);
      print_below("  largest part that is too much", above, 0.1);
      print("  at most 30 products each", products.value() <= 30.);
      print_count("  second runs that differ", differ);
      print_below("  largest change with the unit", units, 1e-13);
    }

    Largest below, above, products, units;
    unsigned int differ = 0, n = 0;
  };
} // namespace

int main()
{
  const double pi = 3.141592653589793;
  Random random(10);

  {
    Ratios ratios;
    for (const Index n : {1, 2, 3, 5, 15, 40, 89, 150})
      ratios.add(MatrixXd::Identity(n, n), 1.);
    ratios.add(MatrixXd::Constant(1, 1, 1e-12), 1e-12);
    ratios.add(MatrixXd::Constant(1, 1, 1e12), 1e12);
    ratios.print_all("Identity and 1x1");
  }

  // Its largest eigenvalues are clustered and belong to the roughest modes.
  {
    Ratios ratios;
    for (const Index n : {2, 3, 5, 10, 15, 40, 89, 150})
      {
        MatrixXd laplacian = MatrixXd::Zero(n, n);
        laplacian.diagonal().setConstant(2.);
        laplacian.diagonal(1).setConstant(-1.);
        laplacian.diagonal(-1).setConstant(-1.);
        ratios.add(laplacian, 2. + 2. * std::cos(pi / static_cast<double>(n + 1)));
      }
    ratios.print_all("Laplacian in one dimension");
  }

  {
    Ratios ratios;
    for (const Index n : {5, 10, 40, 150})
      for (const double gap : {0., 1e-12, 1e-6, 1e-3, 1e-2})
        {
          // the four largest within 3·gap, at scattered places
          VectorXd diagonal = random.vector(n, 0.1, 0.8);
          for (const int i : {0, 1, 2, 3})
            diagonal((7 * i + 3) % n) = 1. - gap * i;
          ratios.add(diagonal.asDiagonal(), 1.);
        }
    ratios.print_all("Diagonal with clustered largest eigenvalues");
  }

  // A few modes far above all others, as in a contact dual operator.
  {
    Ratios ratios;
    for (unsigned int sample = 0; sample < 30; ++sample)
      {
        VectorXd eigenvalues = random.vector(60, 0.001, 0.05);
        eigenvalues(0)       = 1.;
        eigenvalues(1)       = random.uniform(0.5, 1.);
        eigenvalues(2)       = random.uniform(0.1, 1.);
        ratios.add(random.symmetric(eigenvalues), 1.);
      }
    ratios.print_all("Random, a few modes above the others");
  }

  // At small orders the start vector may happen to be almost an eigenvector,
  // of any eigenvalue.
  {
    Ratios ratios;
    for (unsigned int sample = 0; sample < 1200; ++sample)
      {
        VectorXd eigenvalues = random.vector(1 + sample % 12, 0.01, 1.);
        eigenvalues(0)       = 1.;
        ratios.add(random.symmetric(eigenvalues), 1.);
      }
    ratios.print_all("Random, of order 1 to 12");
  }

  std::cout << "Nothing to do" << std::endl;
  print("  order zero gives zero", spectral_norm(DenseOperator(MatrixXd(0, 0))) == 0.);
  print("  the zero matrix gives zero",
        spectral_norm(DenseOperator(MatrixXd::Zero(4, 4))) == 0.);
}
