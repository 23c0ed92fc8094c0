#pragma once

#include <stiction/qp/dual_problem.h>

#include <Eigen/Core>

#include <string>

namespace stiction
{
  /// Writes the discrete problem as a "local" problem of FCLIB 3, the library
  /// of frictional contact problems, to an HDF5 file: W = Q, q = −h, spacedim
  /// 3, components interleaved (ν, t1, t2) node by node. Not collective.
  ///
  /// FCLIB's own condition u = W r + q, r ∈ cone, u_t against r_t is ours, so
  /// the solution has r = λ and u = Qλ − h with the same signs. FCLIB knows
  /// Coulomb friction only: a given slip bound is the extra dataset
  /// /fclib_local/given_slip_bound, with mu = 0 and a title that says so.
  /// Further extra datasets, if known: /fclib_local/areas and
  /// /fclib_local/positions (m × 3). FCLIB's reader passes over all of them.
  ///
  /// @param lambda, gradient the solution and Qλ − h, by blocks; both empty:
  /// not known.
  ///
  /// Of Q the lower triangle is read. Throws InputError if the file cannot be
  /// written or there is no contact node.
  void write_fclib(const std::string &path, const DualProblem &problem,
                   const Eigen::VectorXd &lambda   = {},
                   const Eigen::VectorXd &gradient = {});

  /// Reads what write_fclib() or FCLIB itself has written: W as triplets, by
  /// columns or by rows, repeated entries being added. Components are put in
  /// blocks again; a stored solution is not looked at. Not collective.
  ///
  /// Throws InputError that names the file and the dataset unless the file
  /// holds a local problem of spacedim 3 without equality constraints (V, R,
  /// s), with sizes that fit, numbers that are numbers, friction that is not
  /// negative, areas that are positive, and W symmetric to 1e-8 with a
  /// positive diagonal.
  ///
  /// @param symmetric_part of any W its symmetric part is taken.
  DualProblem read_fclib(const std::string &path, bool symmetric_part = false);
} // namespace stiction
