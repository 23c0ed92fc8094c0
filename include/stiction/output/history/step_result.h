#pragma once

#include <stiction/contact/certificate/energy_balance.h>
#include <stiction/qp/node_status.h>

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace stiction
{
  class Certificate;
  class ContactSurface;
  struct State;

  /// What happens on a contact boundary at the end of a step. Forces are those on
  /// the body, moments are about the origin.
  struct BoundaryStep
  {
    std::string name;
    std::string section_name; ///< NAME of the section 'Contact pair NAME'; ""
    std::string opposite; ///< of a pair, the boundary that bears the opposite force; ""
    dealii::Tensor<1, 3> force, moment;
    double normal_force = 0.;
    dealii::Tensor<1, 3> center; ///< of pressure; zero without it
    /// Of the nodes that are open, that slip and that stick; no undecided ones.
    double open_area = 0., slip_area = 0., stick_area = 0.;
    dealii::Tensor<1, 3> obstacle_displacement;
    /// About its axis, rad, and what friction does on the body about that, N m.
    double obstacle_angle = 0., torque = 0.;
    /// By friction, in the step and since the start.
    double dissipated = 0., dissipated_total = 0.;
    bool is_tied = false; ///< forces pull as well, and have no centre of pressure
  };

  /// What the contact solver did, on all meshes of a step.
  struct SolverEffort
  {
    unsigned int newton_steps = 0, krylov_iterations = 0;
    unsigned long dual_multiplications = 0;
    double seconds                     = 0.;
  };

  /// A certified step.
  struct StepResult
  {
    unsigned int number = 0;
    double time         = 0.; ///< at its end
    double residual     = 0.; ///< the largest figure of the certificate
    std::vector<BoundaryStep> boundaries;
    EnergyBalance::Step energy;
    SolverEffort effort;

    /// Of all boundaries together, without pairs, whose forces cancel.
    dealii::Tensor<1, 3> force() const;
  };

  /// Of all contact boundaries, in their order, dissipated_total being that of the
  /// step alone.
  std::vector<BoundaryStep> boundary_steps(const ContactSurface &surface,
                                           const State &state,
                                           const Certificate &certificate,
                                           const std::vector<NodeStatus> &statuses);
} // namespace stiction
