// stiction_side write FILE   writes the problem for libfclib to read
// stiction_side read FILE    reads what libfclib has written
//
// The other side is a program of its own: libfclib and deal.II stand on two
// builds of HDF5 that cannot live in one.

#include <stiction/output/problem/fclib.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <string>

#include "exchange.h"

using namespace stiction;

namespace
{
  Eigen::Index in_blocks(const int k) { return k % 3 * exchange::m + k / 3; }

  Eigen::VectorXd in_blocks(const std::array<double, exchange::n> &values)
  {
    Eigen::VectorXd result(exchange::n);
    for (int k = 0; k < exchange::n; ++k)
      result(in_blocks(k)) = values[k];
    return result;
  }

  DualProblem the_problem()
  {
    DualProblem problem;
    problem.Q.resize(exchange::n, exchange::n);
    for (int i = 0; i < exchange::n; ++i)
      for (int j = 0; j < exchange::n; ++j)
        problem.Q(in_blocks(i), in_blocks(j)) = exchange::W(i, j);
    problem.h          = -in_blocks(exchange::q());
    problem.slip_bound = qp::SlipBound::coulomb(
      Eigen::Map<const Eigen::VectorXd>(exchange::mu.data(), exchange::m));
    problem.areas     = Eigen::VectorXd::Constant(exchange::m, 0.5);
    problem.positions = Eigen::MatrixXd::Random(exchange::m, 3);
    return problem;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 3)
    return 2;
  const std::string task = argv[1], file = argv[2];

  const DualProblem problem = the_problem();
  if (task == "write")
    {
      write_fclib(file, problem, in_blocks(exchange::reaction),
                  in_blocks(exchange::velocity));
      return 0;
    }

  const DualProblem read = read_fclib(file);
  if (read.Q == problem.Q && read.h == problem.h && read.slip_bound.is_coulomb() &&
      read.slip_bound.data() == problem.slip_bound.data() && read.areas.size() == 0 &&
      read.positions.size() == 0)
    return 0;
  std::cout << file << " is read as another problem:\nQ\n"
            << read.Q << "\nh\n"
            << read.h.transpose() << "\nF\n"
            << read.slip_bound.data().transpose() << std::endl;
  return 1;
}
