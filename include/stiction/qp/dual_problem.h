#pragma once

#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/Core>

namespace stiction
{
  /// The discrete contact problem by itself, without the body it came from:
  /// what is exported, imported, and solved from a file.
  ///
  /// Vectors are stored by blocks (ν; t1; t2), m entries each.
  struct DualProblem
  {
    Eigen::MatrixXd Q; ///< dual Hessian, 3m × 3m, symmetric, m/N
    Eigen::VectorXd h; ///< dual right-hand side, 3m, m
    qp::SlipBound slip_bound;
    Eigen::VectorXd areas;     ///< nodal areas, m², length m; empty: unknown
    Eigen::MatrixXd positions; ///< nodes, m × 3, m; empty: unknown

    /// The largest |Q_ij − Q_ji| of the file that Q is the symmetric part of,
    /// over sqrt(Q_ii Q_jj).
    double asymmetry = 0.;
  };
} // namespace stiction
