#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>

namespace stiction
{
  struct DualProblem;

  /// What must hold for a discrete problem that comes from a file, whatever
  /// the format. The messages begin with a place that only the format knows.
  namespace problem_check
  {
    /// Numbers above this size would overflow in their products; no unit
    /// system needs them.
    constexpr double largest = 1e100;

    enum class Allowed
    {
      number,       ///< any number, NaN and infinity are none
      not_negative, ///< a number >= 0
      positive      ///< a number > 0
    };

    /// Throws InputError unless the value is allowed. The place, such as
    /// "FILE, line 7", is only made up if it is needed.
    void require(double value, Allowed allowed,
                 const std::function<std::string()> &place);

    /// The same for all entries of a vector.
    void require_all(const Eigen::VectorXd &values, Allowed allowed,
                     const std::function<std::string(Eigen::Index)> &place);

    /// Throws InputError if a dense matrix of that order would not fit into
    /// the memory of this machine. Not collective, but needs MPI.
    void require_memory(double order, const std::string &place);

    /// Rounding of a symmetric matrix, relative to its diagonal.
    constexpr double symmetry = 1e-8;

    /// Makes Q_ij and Q_ji equal to their mean and returns the largest
    /// |Q_ij − Q_ji| / sqrt(Q_ii Q_jj) there was. A symmetric matrix keeps
    /// every bit. Whether the matrix is positive definite is left to those who
    /// solve with it.
    ///
    /// Throws InputError unless the diagonal is positive and that number at
    /// most the constant symmetry.
    ///
    /// @param symmetric_part any such number will do.
    double make_symmetric(
      Eigen::MatrixXd &Q, bool symmetric_part,
      const std::function<std::string(Eigen::Index, Eigen::Index)> &place);

    /// For writers: throws InputError, beginning with @p place, if the problem
    /// has no contact node, which no file format can say, and
    /// std::invalid_argument if the sizes of its parts do not fit. The
    /// solution may be empty.
    void require_writable(const DualProblem &problem, const Eigen::VectorXd &lambda,
                          const Eigen::VectorXd &gradient, const std::string &place);

    /// A number for a message.
    std::string text(double value);
  } // namespace problem_check
} // namespace stiction
