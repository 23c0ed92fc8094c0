#pragma once

#include <stiction/qp/contact_conditions.h>
#include <stiction/qp/contact_scales.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;
  class StiffnessSolver;

  /// The one error measure that stops, reports and tests every method.
  ///
  /// Computed from the displacement u, the contact forces λ and the data of
  /// the problem alone: the stiffness matrix is applied afresh; no solver's
  /// own residual, no factorisation and no product with Q enters. All figures
  /// are relative to scales taken from the solution, so that no unit matters:
  ///
  /// S = max(Σ‖f_j‖, Σ‖R_j‖, Σ‖λ_i‖) over nodes (loads, support reactions,
  /// contact forces), p0 = S/|Γc|, u0 = uᵀKu/S, less of it where the contact
  /// face is stiffer than other parts of the body (contact_scaling()). With
  /// π = λ_i/(A_i p0) and w = r_i/u0, r = (d − n·u; −slip), γ = g_i/(A_i p0).
  ///
  /// In a load history S and S u0 are at least a millionth of what they were in any
  /// step before: what is left in a body that was let go is rounding.
  ///
  /// rounding() is Σ ε‖diag(K_jj) u_j‖/S, ε = 2⁻⁵³: what rounding the
  /// displacement of each node alone changes the forces inside the body by.
  ///
  /// With orthotropic friction λ and the slip are the contact variables of
  /// ContactFrame, in which the ellipse is a disc: the slip angle is 0 where
  /// the slip is normal to the ellipse.
  class Certificate : public ContactConditions
  {
  public:
    /// The figures that only a body has, by their names in summary.json.
    struct BodyFigures
    {
      /// Σ‖(f − Bᵀλ − Ku)_j‖/S over the free unknowns: equilibrium at every
      /// node, where it is more than the rounding of Ku there, else that.
      double equilibrium_residual = 0.;
      /// ‖Σ(loads + contact forces + reactions)‖/S, the largest of all bodies, or the sum
      /// of the lengths of what nodal forces on one side of a pair lack on the other, if
      /// that is more.
      double force_balance = 0.;
      /// The same for the moments, relative to S times the body's size.
      double moment_balance = 0.;
      /// max_j |force of obstacle j − P_j|/P_j, P_j being the prescribed one;
      /// negative: there is none.
      double obstacle_force = -1.;
      /// Bound on the relative energy error ‖û − u*‖_K/‖û‖_K of the problem
      /// with the slip bound frozen at its last value; negative: not computed.
      double duality_gap = -1.;
    };

    /// Of several bodies the one with loads whose own forces are balanced worst. The
    /// figures are relative to those of all bodies, which may be far larger.
    struct WorstBalanced
    {
      unsigned int body = 0; ///< its place in Body::pieces()
      /// ‖Σ(loads + contact forces + reactions)‖ over the most of what these three are by
      /// their lengths.
      double lacking = 0.;
    };
    const WorstBalanced &worst_balanced() const { return worst_balanced_; }

    /// Computes all figures but the duality gap. Collective.
    Certificate(const LinearElasticity &elasticity, const ContactSurface &surface,
                const State &state);

    /// Adds the figure of duality_gap(), which takes an elastic solve.
    void set_duality_gap(const double gap) { body_figures_.duality_gap = gap; }

    const BodyFigures &body_figures() const { return body_figures_; }

    std::vector<std::pair<std::string, double>> deciding_figures() const override;

    /// As if the obstacles, and a body that contact alone holds, were where they are.
    bool is_solved(double tolerance) const override;

    /// Young's moduli are named where their ratio alone takes the digits.
    std::string why_out_of_reach(double tolerance) const override;

    /// Whether there are neither loads nor contact forces, and no node resists: then S is
    /// that of no force.
    bool bears_nothing() const { return bears_nothing_; }

    /// S, N.
    double force_scale() const { return force_scale_; }

    /// S u0, J.
    double energy_scale() const { return energy_scale_; }

    /// uᵀKu/2 in J.
    double strain_energy() const { return strain_energy_; }

    /// The same of one of Body::pieces().
    double strain_energy(const unsigned int piece) const
    {
      return strain_energies_[piece];
    }

    /// Load times displacement, prescribed displacements included, in J.
    double load_work() const { return load_work_; }

  private:
    /// What forces of pairs lack on the other side, N. Collective.
    double lost_between_sides() const;

    void compute_body_figures(const State &state);

    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;
    BodyFigures body_figures_;
    WorstBalanced worst_balanced_;
    std::vector<double> strain_energies_;
    bool bears_nothing_ = false;
    double force_scale_ = 1., energy_scale_ = 0., strain_energy_ = 0., load_work_ = 0.;
  };
} // namespace stiction
