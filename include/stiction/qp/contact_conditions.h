#pragma once

#include <stiction/qp/sets/feasible_set.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  /// How far contact forces λ (N) and r = (remaining gap; −slip) (m) are from
  /// satisfying the contact and friction conditions.
  ///
  /// All figures are relative to scales that the caller provides, a force and a
  /// displacement at every node, so that no unit matters: π = λ_i/force_i,
  /// w = r_i/displacement_i, γ = g_i/force_i.
  class ContactConditions
  {
  public:
    /// The figures, by their names in summary.json.
    struct ContactFigures
    {
      /// max_i ‖π − P_γ(π − w)‖: the contact and friction conditions.
      double kkt_residual = 0.;
      /// max(−w_ν, 0); |w_ν| where the node is tied.
      double penetration = 0.;
      /// max π_ν min(|w_ν|, 1): a pressure across a gap is as wrong across a
      /// wide one. Times a gap that no displacement closes it would ask for
      /// digits that nothing depends on.
      double complementarity = 0.;
      /// max(‖π_t‖ − γ, −π_ν, 0).
      double cone_violation = 0.;
      /// Largest angle in degrees between λ_t and the slip, where both are
      /// above 1e-6 of their scales.
      double slip_angle = 0.;
    };

    /// Computes the figures.
    ContactConditions(Eigen::VectorXd lambda, Eigen::VectorXd gradient,
                      Eigen::VectorXd slip_bound, qp::Scaling scaling);
    virtual ~ContactConditions() = default;

    const ContactFigures &contact_figures() const { return contact_figures_; }

    /// The figures that decide, with their names.
    virtual std::vector<std::pair<std::string, double>> deciding_figures() const;

    /// Whether all of them are at most the tolerance (a NaN never is).
    bool converged(double tolerance) const;

    /// The same without figures that only other places of the obstacles can
    /// lower.
    virtual bool is_solved(const double tolerance) const { return converged(tolerance); }

    /// The largest figure that normal forces and gaps make alone, max_i |π_ν − max(π_ν −
    /// w_ν, 0)| where nodes are not tied, whatever friction lacks; infinite if nothing is
    /// pressed.
    double normal_residual() const;

    /// What rounding alone makes of the figures, an estimate.
    double rounding() const { return rounding_; }
    void set_rounding(const double rounding) { rounding_ = rounding; }

    /// If rounding is above the tolerance and explains every figure: that, and
    /// what to change; otherwise empty.
    virtual std::string why_out_of_reach(double tolerance) const;

    /// The largest of them; a NaN is larger than any number.
    std::pair<std::string, double> worst_figure() const;

    /// "kkt_residual is 3e-4": the same in words.
    std::string worst() const;

    /// The scales in which the figures are measured.
    const qp::Scaling &scaling() const { return scaling_; }

    /// r = (remaining gap; −slip) at the contact nodes. Unit: m.
    const Eigen::VectorXd &gradient() const { return gradient_; }

    /// The contact forces and slip bounds the figures belong to. Unit: N.
    const Eigen::VectorXd &lambda() const { return lambda_; }
    const Eigen::VectorXd &slip_bound() const { return slip_bound_; }

  protected:
    /// For a class that computes gradient and scales itself: sets λ and g, and
    /// leaves the rest to compute_contact_figures().
    ContactConditions(Eigen::VectorXd lambda, Eigen::VectorXd slip_bound);

    void compute_contact_figures();

    Eigen::VectorXd lambda_, slip_bound_, gradient_;
    qp::Scaling scaling_;
    double rounding_ = 0.;

  private:
    ContactFigures contact_figures_;
  };
} // namespace stiction
