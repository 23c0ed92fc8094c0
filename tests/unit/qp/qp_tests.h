#pragma once

#include <stiction/qp/operators/symmetric_operator.h>
#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "../../random_numbers.h"

/// What the tests of the qp layer share: random problems, a slow reference
/// solver that uses nothing of the layer under test, and words for the output.
namespace qp_tests
{
  using Eigen::Index;
  using Eigen::MatrixXd;
  using Eigen::VectorXd;

  class Random : public RandomNumbers
  {
  public:
    using RandomNumbers::RandomNumbers;

    int integer(const int n)
    {
      return static_cast<int>(one_of(static_cast<unsigned int>(n)));
    }

    VectorXd vector(const Index n, const double a = -1., const double b = 1.)
    {
      VectorXd v(n);
      for (double &entry : v)
        entry = uniform(a, b);
      return v;
    }

    /// A symmetric matrix with the given eigenvalues and random eigenvectors.
    MatrixXd symmetric(const VectorXd &eigenvalues)
    {
      MatrixXd A = eigenvalues.asDiagonal();
      for (Index i = 0; i < A.rows(); ++i)
        {
          const VectorXd w  = vector(A.rows()).normalized();
          const VectorXd Aw = A * w; // A ← H A H with H = I − 2wwᵀ
          A += (4. * w.dot(Aw)) * w * w.transpose() -
               2. * (w * Aw.transpose() + Aw * w.transpose());
        }
      return 0.5 * (A + A.transpose());
    }

    /// Symmetric positive definite, spectrum within [1/condition, 1].
    MatrixXd spd(const Index n, const double condition)
    {
      VectorXd eigenvalues(n);
      for (double &eigenvalue : eigenvalues)
        eigenvalue = log_uniform(1. / condition, 1.);
      return symmetric(eigenvalues);
    }
  };

  /// The largest of many figures, and NaN for good once one of them was.
  class Largest
  {
  public:
    void add(const double figure)
    {
      if (!std::isnan(value_) && !(figure <= value_))
        value_ = figure;
    }

    double value() const { return value_; }

  private:
    double value_ = 0.;
  };

  inline const char *yes(const bool holds) { return holds ? "yes" : "no"; }

  inline void print(const std::string &claim, const bool holds)
  {
    std::cout << claim << ": " << yes(holds) << std::endl;
  }

  /// The figure itself is shown only when the claim is false.
  inline void print_below(const std::string &what, const double figure,
                          const double bound)
  {
    std::cout << what << " below " << bound << ": ";
    if (figure < bound)
      std::cout << "yes" << std::endl;
    else
      std::cout << "no, " << figure << std::endl;
  }

  inline void print_below(const std::string &what, const Largest &figure,
                          const double bound)
  {
    print_below(what, figure.value(), bound);
  }

  inline void print_count(const std::string &what, const unsigned int count)
  {
    std::cout << what << ": " << count << std::endl;
  }

  /// A matrix, which must outlive it, as an operator.
  struct DenseOperator : stiction::qp::SymmetricOperator
  {
    explicit DenseOperator(const MatrixXd &matrix)
      : SymmetricOperator(matrix.rows(), [&matrix](VectorXd &dst, const VectorXd &src) {
        dst.noalias() = matrix * src;
      })
    {
    }
  };

  /// ½ xᵀAx − xᵀb
  inline double energy(const MatrixXd &A, const VectorXd &b, const VectorXd &x)
  {
    const VectorXd Ax = A * x;
    return x.dot(0.5 * Ax - b);
  }

  /// The nearest point of the half-lines (first n_half_lines entries) times
  /// the discs (two blocks of entries after them), as one would write it; with half-lines
  /// a node of infinite radius is free along the normal, too.
  inline void project(VectorXd &x, const Index n_half_lines, const VectorXd &radii)
  {
    for (Index i = 0; i < n_half_lines; ++i)
      if (i >= radii.size() || !std::isinf(radii(i)))
        x(i) = std::max(x(i), 0.);
    const Index m = radii.size();
    for (Index i = n_half_lines; i < n_half_lines + m; ++i)
      {
        const double norm = std::sqrt(x(i) * x(i) + x(i + m) * x(i + m));
        if (norm > radii(i - n_half_lines))
          {
            x(i) *= radii(i - n_half_lines) / norm;
            x(i + m) *= radii(i - n_half_lines) / norm;
          }
      }
  }

  /// min ½ xᵀAx − xᵀb over the set of project(), by projected gradient steps
  /// (1e5, or until they move nothing) that recompute everything.
  inline VectorXd reference_solution(const MatrixXd &A, const VectorXd &b,
                                     const Index n_half_lines, const VectorXd &radii)
  {
    // the largest row sum bounds the largest eigenvalue
    const double step = 1.9 / A.cwiseAbs().rowwise().sum().maxCoeff();
    VectorXd x        = VectorXd::Zero(b.size()), next;
    for (unsigned int k = 0; k < 100000; ++k)
      {
        next = x - step * (A * x - b);
        project(next, n_half_lines, radii);
        if (next == x)
          break;
        x.swap(next);
      }
    return x;
  }

  /// Q of a body on a soft layer: six soft modes.
  inline MatrixXd weakly_held(Random &random, const Index n, const double ratio)
  {
    MatrixXd Q = random.spd(n, 30.);
    for (unsigned int k = 0; k < 6; ++k)
      {
        const VectorXd v = random.vector(n);
        Q += ratio * v * v.transpose() / v.squaredNorm();
      }
    return Q;
  }

  /// Forces x, and r for them, that satisfy all conditions: a third of the
  /// nodes are open, the others stick or slip; tied ones bear forces of all directions.
  inline void choose_solution(Random &random, const stiction::qp::SlipBound &bound,
                              VectorXd &x, VectorXd &r)
  {
    const Index m         = bound.n_nodes();
    x                     = VectorXd::Zero(3 * m);
    r                     = VectorXd::Zero(3 * m);
    const VectorXd amount = random.vector(3 * m, 0.1, 1.);
    for (Index i = 0; i < m; ++i)
      (i % 3 == 0 ? r(i) : x(i)) = amount(i);
    const VectorXd g     = bound.at(x);
    const VectorXd angle = random.vector(m, 0., 6.28);
    for (Index i = 0; i < m; ++i)
      {
        if (bound.is_tied(i))
          {
            r(i) = 0.;
            for (const Index k : {i, i + m, i + 2 * m})
              x(k) = amount(k) - 0.5;
            continue;
          }
        const bool slips = i % 2 == 0;
        const double t   = slips ? g(i) : 0.9 * amount(i + m) * g(i);
        x(i + m)         = t * std::cos(angle(i));
        x(i + 2 * m)     = t * std::sin(angle(i));
        if (slips)
          {
            r(i + m)     = -amount(i + 2 * m) * std::cos(angle(i));
            r(i + 2 * m) = -amount(i + 2 * m) * std::sin(angle(i));
          }
      }
  }
} // namespace qp_tests
