#pragma once

#include <stiction/qp/dual_problem.h>

#include <Eigen/Core>

#include <string>

namespace stiction
{
  /// Writes the discrete problem as Matrix Market files, text that almost any
  /// program reads, into a directory that exists: Q.mtx, h.mtx,
  /// friction_coefficient.mtx (Coulomb) or slip_bound.mtx (given friction);
  /// areas.mtx and nodes.mtx if known; lambda.mtx and gradient.mtx if solved.
  /// Vectors by blocks (ν; t1; t2), 17 significant digits: every bit is kept.
  /// Those of these files that do not belong to the problem are removed, so
  /// that no earlier problem mixes with this one. Not collective.
  ///
  /// @param lambda, gradient the solution and Qλ − h; both empty: not known.
  ///
  /// Of Q the lower triangle is read. Throws InputError if a file cannot be
  /// written or there is no contact node.
  void write_matrix_market(const std::string &directory, const DualProblem &problem,
                           const Eigen::VectorXd &lambda   = {},
                           const Eigen::VectorXd &gradient = {});

  /// Reads the files that write_matrix_market() names, from a directory or
  /// from the one where the given file, in the role of Q.mtx, is. Each may be
  /// 'array' or 'coordinate', 'real' or 'integer', 'general' or 'symmetric';
  /// repeated coordinates are added. A stored solution is not looked at. Not
  /// collective.
  ///
  /// Throws InputError that names the file and, where there is one, the line,
  /// unless exactly one of the two laws of friction is there, sizes fit,
  /// numbers are numbers, friction is not negative, areas are positive, and Q
  /// is symmetric to 1e-8 with a positive diagonal.
  ///
  /// @param symmetric_part of any Q its symmetric part is taken.
  DualProblem read_matrix_market(const std::string &path, bool symmetric_part = false);
} // namespace stiction
