#pragma once

#include <stiction/contact/interface/slip_history.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>

namespace stiction
{
  /// All that a computation has found: from it and the data of the problem
  /// follow the certificate and every result.
  struct State
  {
    LA::Vector u;              ///< displacement, m; hanging nodes have theirs
    Eigen::VectorXd lambda;    ///< contact forces, N, length 3m
    Eigen::VectorXd distances; ///< δ of pressed obstacles, m, see ObstacleMotion
    SlipHistory history;

    /// The largest S and uᵀKu of the certificates of the steps before, N and J. Beside
    /// them a body that was let go is judged, whose own forces are rounding.
    struct Scales
    {
      double force = 0., energy = 0.;
    } scales = {};
  };

  /// What was found at a time.
  struct StepEnd
  {
    double time;
    State state;
  };
} // namespace stiction
