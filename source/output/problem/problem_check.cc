#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/base/memory.h>
#include <stiction/output/problem/problem_check.h>
#include <stiction/qp/dual_problem.h>

#include <cmath>
#include <stdexcept>

namespace stiction::problem_check
{
  std::string text(const double value) { return format("%.10g", value); }

  void require(const double value, const Allowed allowed,
               const std::function<std::string()> &place)
  {
    // written so that NaN fails
    const bool in_range = std::abs(value) <= largest;
    if (in_range && (allowed == Allowed::number ||
                     (allowed == Allowed::not_negative ? value >= 0. : value > 0.)))
      return;

    throw InputError(place() + " is " + text(value) + ", must be a number" +
                     (allowed == Allowed::number         ? " from -1e100"
                      : allowed == Allowed::not_negative ? " from 0"
                                                         : " above 0 and up") +
                     " to 1e100.");
  }

  void require_all(const Eigen::VectorXd &values, const Allowed allowed,
                   const std::function<std::string(Eigen::Index)> &place)
  {
    for (Eigen::Index i = 0; i < values.size(); ++i)
      require(values(i), allowed, [&]() { return place(i); });
  }

  void require_memory(const double order, const std::string &place)
  {
    // never more than Q itself; what a solver needs besides, it asks for
    const double needed    = sizeof(double) * order * order;
    const double available = available_memory(MPI_COMM_SELF);
    if (needed > available)
      throw InputError(place + " is a matrix of order " + text(order) + ", which takes " +
                       text(std::ceil(needed / 1e9)) +
                       " GB of memory, must fit into the " +
                       text(std::floor(available / 1e9)) + " GB of this machine.");
  }

  double make_symmetric(
    Eigen::MatrixXd &Q, const bool symmetric_part,
    const std::function<std::string(Eigen::Index, Eigen::Index)> &place)
  {
    const Eigen::Index n = Q.rows();
    for (Eigen::Index i = 0; i < n; ++i)
      require(Q(i, i), Allowed::positive, [&]() { return place(i, i); });

    const Eigen::VectorXd scale = Q.diagonal().cwiseSqrt();
    double worst                = 0.;
    Eigen::Index row = 0, column = 0;
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = j + 1; i < n; ++i)
        {
          const double difference = std::abs(Q(i, j) - Q(j, i)) / (scale(i) * scale(j));
          if (!(difference <= worst))
            {
              worst  = difference;
              row    = i;
              column = j;
            }
        }
    if (!(worst <= symmetry || symmetric_part))
      throw InputError(place(row, column) + " is " + text(Q(row, column)) +
                       ", the entry across the diagonal " + text(Q(column, row)) +
                       ", must be equal, the matrix being symmetric, to 1e-8 "
                       "of the diagonal; of all pairs these differ most, by " +
                       text(worst) +
                       " of it, 'Dual operator/Symmetric part = true' takes "
                       "the symmetric part.");
    for (Eigen::Index j = 0; j < n; ++j)
      for (Eigen::Index i = j + 1; i < n; ++i)
        Q(i, j) = Q(j, i) = 0.5 * (Q(i, j) + Q(j, i));
    return worst;
  }

  void require_writable(const DualProblem &problem, const Eigen::VectorXd &lambda,
                        const Eigen::VectorXd &gradient, const std::string &place)
  {
    const Eigen::Index m = problem.slip_bound.n_nodes();
    if (m == 0)
      throw InputError(place + ": cannot be written, there must be at least "
                               "one contact node.");

    const auto is_empty_or = [](const Eigen::Index size, const Eigen::Index needed) {
      return size == 0 || size == needed;
    };
    if (problem.Q.rows() != 3 * m || problem.Q.cols() != 3 * m ||
        problem.h.size() != 3 * m || !is_empty_or(problem.areas.size(), m) ||
        !is_empty_or(problem.positions.size(), 3 * m) ||
        !is_empty_or(lambda.size(), 3 * m) || lambda.size() != gradient.size())
      throw std::invalid_argument("sizes of a discrete problem do not fit");
  }
} // namespace stiction::problem_check
