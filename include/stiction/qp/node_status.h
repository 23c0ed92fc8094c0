#pragma once

#include <stiction/qp/sets/slip_bound.h>

#include <Eigen/Core>

#include <vector>

namespace stiction
{
  class ContactConditions;

  /// Whether a contact node touches its obstacle. The numbers are those of the
  /// output files.
  enum class NormalStatus
  {
    open      = 0,
    closed    = 1,
    undecided = 3
  };

  /// What friction does at a contact node. The numbers are those of the output
  /// files.
  enum class TangentialStatus
  {
    none      = 0, ///< no friction can act
    slip      = 1,
    stick     = 2,
    undecided = 3,
    tied      = 4 ///< to what it is paired with, always closed
  };

  /// What a contact node does, along the normal and across it: with given
  /// friction a node slips or sticks whether it touches or not.
  struct NodeStatus
  {
    NormalStatus normal;
    TangentialStatus tangential;

    bool is_undecided() const
    {
      return normal == NormalStatus::undecided ||
             tangential == TangentialStatus::undecided;
    }
  };

  /// The status of all contact nodes. With π, w and γ of ContactConditions,
  /// a = π − w, and F the coefficient of friction (0 with given friction), a
  /// node is
  ///
  /// - closed and tied if the law says so, otherwise
  /// - closed if a_ν > m, open if a_ν < −5ε, else undecided;
  /// - without friction if there is none at all, or if it is open and friction
  ///   needs pressure; undecided if friction needs pressure and whether the
  ///   node is closed is undecided;
  /// - otherwise slipping if ‖a_t‖ − γ > 5ε, sticking if it is below
  ///   −(1 + F)m, else undecided.
  ///
  /// Of a solution, a_ν is the pressure of a closed node and minus the gap of
  /// an open one, ‖a_t‖ − γ the slip or minus what friction could carry in
  /// addition: the signs tell. They tell nothing where the number is no larger
  /// than its error. The certificate tells gap and slip to ε u0, ε being its
  /// largest figure; a gap that is wrong by ε u0 at a node of stiffness k makes
  /// a force that is wrong by k ε u0. So m = 5ε(1 + k u0/force_i), and an error
  /// F m of the slip bound follows from that of the pressure. Figures below a
  /// hundredth of the tolerance do not lower ε: what lies below it may be
  /// rounding. The factor 5 is measured: problems with known solutions, a third of
  /// their nodes at a switch, which all dual methods solved to tolerances from 1e-4
  /// to 1e-10, had gaps and slips wrong by up to 1.02 ε, forces by up to
  /// 2.6 ε(1 + k u0/force_i).
  ///
  /// @param slip_bound the law that the slip bounds of @p conditions follow.
  /// @param stiffness k, the force that moves each node alone by a unit, N/m; its size
  ///   is enough.
  std::vector<NodeStatus> node_statuses(const ContactConditions &conditions,
                                        const qp::SlipBound &slip_bound,
                                        const Eigen::VectorXd &stiffness,
                                        double tolerance);
} // namespace stiction
