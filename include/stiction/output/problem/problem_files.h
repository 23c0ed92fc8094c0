#pragma once

#include <stiction/qp/dual_problem.h>

#include <Eigen/Core>

#include <string>

namespace stiction
{
  /// Writes the discrete problem, and its solution if there is one, for other
  /// programs: problem.hdf5 as FCLIB has it (see write_fclib()), the Matrix
  /// Market files (see write_matrix_market()), and a README.txt that explains
  /// them all. Makes the directory. Not collective: one rank calls it.
  ///
  /// @param lambda, gradient the contact forces and Qλ − h, by blocks; both
  /// empty: not known.
  ///
  /// Throws InputError if a file cannot be written or there is no contact
  /// node.
  void export_problem(const std::string &directory, const DualProblem &problem,
                      const Eigen::VectorXd &lambda   = {},
                      const Eigen::VectorXd &gradient = {});

  /// Reads a discrete problem from a directory with Q.mtx (or else with
  /// problem.hdf5), a Matrix Market file *.mtx in the role of Q.mtx, or an
  /// FCLIB file *.hdf5 or *.h5. Areas and positions that the files do not have
  /// are left empty. Not collective: one rank calls it.
  ///
  /// Throws InputError, one sentence that names the file and the place in it,
  /// if the files do not make a problem.
  ///
  /// @param symmetric_part of any Q its symmetric part is taken.
  DualProblem import_problem(const std::string &path, bool symmetric_part = false);
} // namespace stiction
