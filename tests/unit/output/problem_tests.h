#pragma once

// What the tests of problem files share.

#include <stiction/base/errors.h>
#include <stiction/qp/dual_problem.h>

#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <string>

namespace problem_tests
{
  using Eigen::Index;

  inline const char *yes(const bool condition) { return condition ? "yes" : "NO"; }

  // Numbers with all their bits in use.
  inline Eigen::MatrixXd random(const Index rows, const Index columns, const double from)
  {
    static std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(from, 1.);
    return Eigen::MatrixXd::NullaryExpr(rows, columns,
                                        [&]() { return uniform(generator); });
  }

  // A problem of m nodes, Q positive definite and exactly symmetric.
  inline stiction::DualProblem some_problem(const Index m, const bool coulomb,
                                            const bool with_mesh)
  {
    stiction::DualProblem problem;
    problem.Q                                        = random(3 * m, 3 * m, -1.);
    problem.Q.triangularView<Eigen::StrictlyUpper>() = problem.Q.transpose();
    problem.Q.diagonal().array() += 3. * m;
    problem.Q /= 1e9;
    problem.h    = random(3 * m, 1, -1.) / 1e3;
    problem.h(0) = -0.; // the sign of a zero is a bit, too
    problem.h(1) = 5e-324;

    Eigen::VectorXd friction = random(m, 1, 0.);
    friction(m - 1)          = 0.;
    problem.slip_bound       = coulomb ? stiction::qp::SlipBound::coulomb(friction)
                                       : stiction::qp::SlipBound::given(friction);
    if (with_mesh)
      {
        problem.areas     = random(m, 1, 0.1);
        problem.positions = random(m, 3, -1.);
      }
    return problem;
  }

  inline bool same_bits(const Eigen::MatrixXd &a, const Eigen::MatrixXd &b)
  {
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           (a.size() == 0 ||
            std::memcmp(a.data(), b.data(), sizeof(double) * a.size()) == 0);
  }

  inline bool same_bits(const stiction::DualProblem &a, const stiction::DualProblem &b)
  {
    return same_bits(a.Q, b.Q) && same_bits(a.h, b.h) &&
           a.slip_bound.is_coulomb() == b.slip_bound.is_coulomb() &&
           same_bits(a.slip_bound.data(), b.slip_bound.data()) &&
           same_bits(a.areas, b.areas) && same_bits(a.positions, b.positions);
  }

  inline void write_text(const std::string &file, const std::string &text)
  {
    std::ofstream(file, std::ios::binary) << text;
  }

  // Prints what the reader says.
  inline void refused(const std::string &what, const std::function<void()> &read)
  {
    std::cout << what << "\n  ";
    try
      {
        read();
        std::cout << "NOT REFUSED" << std::endl;
      }
    catch (const stiction::InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
  }
} // namespace problem_tests
