#pragma once

#include <Eigen/Core>

#include <vector>

namespace stiction::qp
{
  /// The circles replaced by r squares each, as in the methods ALG_2 and ALG_4
  /// that the paper compares with, written as bounds on other unknowns.
  ///
  /// The squares ‖R_j λ_t‖_∞ ≤ g, R_j the rotation by (j − 1)π/(2r), have in
  /// common the regular polygon with 4r edges around the circle; its corners
  /// are at g/cos(π/4r). It is also the sum of r small squares,
  /// λ_t = Σ_j R_jᵀ μ_j with ‖μ_j‖_∞ ≤ tan(π/4r) g. In the unknowns μ the
  /// constraints are bounds (HalfLinesTimesBoxes), at the price of r times as
  /// many of them and, for r > 1, of a singular Hessian CᵀQC.
  ///
  /// Vectors are in blocks of n_nodes() entries: forces (λ_ν; λ_t1; λ_t2), and
  /// box unknowns (λ_ν; μ_1x; μ_1y; μ_2x; ...; μ_ry), 1 + 2r blocks.
  class RotatedSquares
  {
  public:
    /// @param r number of squares a node, ≥ 1
    /// @param slip_bound g, unit: N
    ///
    /// Throws std::invalid_argument if r is zero, or an entry of g is negative
    /// or not a number.
    RotatedSquares(unsigned int r, Eigen::VectorXd slip_bound);

    Eigen::Index n_nodes() const { return slip_bound_.size(); }

    /// Length of a vector of box unknowns.
    Eigen::Index n_unknowns() const { return n_nodes() * (1 + 2 * n_squares_); }

    /// tan(π/4r) g
    Eigen::VectorXd half_widths() const;

    /// C: the forces that box unknowns stand for.
    Eigen::VectorXd to_forces(const Eigen::VectorXd &unknowns) const;

    /// Cᵀ: the gradient with respect to the box unknowns, from the one with
    /// respect to the forces.
    Eigen::VectorXd pull_back(const Eigen::VectorXd &gradient) const;

    /// Feasible box unknowns that stand for the given forces, or where these
    /// are not feasible for the nearest ones: to start from.
    ///
    /// Let n be the normal of the edge towards which the projected λ_t points,
    /// and τ ⟂ n. All generators R_jᵀe_x, R_jᵀe_y at an acute or obtuse angle
    /// to n carry ± tan(π/4r) n·λ_t, which adds up to (n·λ_t) n, and the one
    /// along τ carries τ·λ_t. (On the edge this is the only way to write λ_t;
    /// inside it is the same, shrunk.)
    Eigen::VectorXd lift(const Eigen::VectorXd &forces) const;

  private:
    unsigned int n_squares_;
    Eigen::VectorXd slip_bound_;
    double factor_;                     ///< tan(π/4r)
    std::vector<double> cosine_, sine_; ///< of k π/(2r), k = 0 ... 4r − 1
  };
} // namespace stiction::qp
