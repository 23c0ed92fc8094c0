#pragma once

#include <Eigen/Core>

namespace stiction::qp
{
  class SlipBound;
  class SymmetricOperator;

  /// dx/dα where r = Qx − h + Gα and x solves the contact conditions: how contact forces
  /// follow multipliers as long as the same nodes touch and slip. Of size 3m × n, N/m.
  ///
  /// @param Q of size 3m. @param G 3m × n.
  /// @param x, gradient the solution and its r.
  /// @param nodal_compliance about tr(Q_ii)/3 at every node, length m, > 0.
  Eigen::MatrixXd sensitivity(const SymmetricOperator &Q, const Eigen::MatrixXd &G,
                              const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                              const Eigen::VectorXd &nodal_compliance,
                              const SlipBound &slip_bound);
} // namespace stiction::qp
