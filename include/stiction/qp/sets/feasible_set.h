#pragma once

#include <Eigen/Core>

#include <limits>

namespace stiction::qp
{
  /// The units in which a residual is measured.
  ///
  /// At node i a multiplier is worth force(i) (N) and a gradient entry is
  /// worth weight(i)·displacement (m), so that figures of different nodes,
  /// units and materials can be compared. Weights come from materials that
  /// differ, or from scaled variables (Mpgp).
  struct Scaling
  {
    Eigen::VectorXd force;       ///< length n_nodes, > 0
    double displacement    = 1.; ///< > 0
    Eigen::VectorXd weight = {}; ///< length n_nodes, > 0, or empty: all are 1

    double displacement_at(const Eigen::Index node) const
    {
      return weight.size() == 0 ? displacement : weight(node) * displacement;
    }
  };

  /// A closed convex set that is a product of small sets, one a node.
  ///
  /// A vector x of the set has n_components() entries a node, stored by
  /// blocks: component c of node i is entry i + c·n_nodes(). All a solver
  /// needs to know of its constraints is in the four functions below.
  class FeasibleSet
  {
  public:
    FeasibleSet(Eigen::Index n_nodes, unsigned int n_components);
    virtual ~FeasibleSet() = default;

    Eigen::Index n_nodes() const { return n_nodes_; }

    unsigned int n_components() const { return n_components_; }

    Eigen::Index size() const { return n_nodes_ * n_components_; }

    /// Replaces x by the nearest point of the set (Euclidean, node by node).
    virtual void project(Eigen::VectorXd &x) const = 0;

    /// The largest α ≥ 0 with x + α d in the set, for feasible x; infinity
    /// where the set does not end along d.
    virtual double largest_feasible_step(const Eigen::VectorXd &x,
                                         const Eigen::VectorXd &d) const = 0;

    /// Splits the gradient at the feasible x into its free part (the gradient
    /// at nodes inside their set, zero on the boundary) and its chopped part:
    /// on the boundary (x − P(x − step·gradient))/step, zero inside.
    ///
    /// x solves the quadratic program if and only if both are zero.
    virtual void split(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                       double step, Eigen::VectorXd &free,
                       Eigen::VectorXd &chopped) const = 0;

    /// The distance from optimality of the feasible x, without a unit:
    /// max over the nodes of ‖π − P(π − w)‖ with π = x_i/force_i and
    /// w = gradient_i/(weight_i displacement). Zero if and only if x is
    /// optimal.
    double natural_residual(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                            const Scaling &scaling) const;

  private:
    Eigen::Index n_nodes_;
    unsigned int n_components_;
  };

  /// The slip bound of a node that is tied: no force is too large in any direction,
  /// along the normal neither.
  constexpr double tied = std::numeric_limits<double>::infinity();

  constexpr bool is_tied(const double slip_bound) { return slip_bound == tied; }

  /// x_i ≥ 0 in the first block and |x_i| ≤ b_i in each of the others: bounds only.
  /// Where b_i is infinite, x_i is any number, in the first block too.
  class Intervals : public FeasibleSet
  {
  public:
    void project(Eigen::VectorXd &x) const override;

    /// Bounds are met entry by entry: a node may have free and chopped entries
    /// at once.
    void split(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient, double step,
               Eigen::VectorXd &free, Eigen::VectorXd &chopped) const override;

    double largest_feasible_step(const Eigen::VectorXd &x,
                                 const Eigen::VectorXd &d) const override;

  protected:
    /// @param half_widths b, the same in all of @p n_more blocks.
    Intervals(const Eigen::VectorXd &half_widths, unsigned int n_more);

  private:
    Eigen::VectorXd upper_, lower_; ///< of all entries
  };

  /// x_i ≥ 0: the normal contact forces, Λ_ν of the paper's problem (D); any number
  /// where the node is tied.
  class HalfLines : public Intervals
  {
  public:
    /// @param slip_bound of each node; which ones are tied is all that counts.
    explicit HalfLines(const Eigen::VectorXd &slip_bound)
      : Intervals(slip_bound, 0)
    {
    }
  };

  /// Half-lines times intervals, as for the rotated squares that replace the circles.
  /// Half-widths may be zero, and infinite where a node is tied.
  class HalfLinesTimesBoxes : public Intervals
  {
  public:
    /// n_intervals ≥ 0 blocks of intervals, all with the same half-widths.
    /// Throws std::invalid_argument if one is negative or not a number.
    HalfLinesTimesBoxes(const Eigen::VectorXd &half_widths, unsigned int n_intervals);
  };

  /// x_i² + x_{i+m}² ≤ g_i²: the tangential contact forces, Λ_t of the
  /// paper's problem (D). Radii may be zero, and infinite where a node is tied.
  class Discs : public FeasibleSet
  {
  public:
    /// Throws std::invalid_argument if a radius is negative or not a number.
    explicit Discs(Eigen::VectorXd radii);

    const Eigen::VectorXd &radii() const { return radii_; }

    void project(Eigen::VectorXd &x) const override;

    void split(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient, double step,
               Eigen::VectorXd &free, Eigen::VectorXd &chopped) const override;

    double largest_feasible_step(const Eigen::VectorXd &x,
                                 const Eigen::VectorXd &d) const override;

    /// Whether x_i lies on its circle, up to rounding: i is in the paper's
    /// active set A(x). A node of radius zero always is.
    bool is_active(const Eigen::VectorXd &x, Eigen::Index i) const;

  private:
    Eigen::VectorXd radii_;
  };

  /// Half-lines times discs: the whole feasible set of the paper's problem
  /// (D), with entries (λ_ν; λ_t1; λ_t2). Where a node is tied it is the whole space.
  class HalfLinesTimesDiscs : public FeasibleSet
  {
  public:
    /// Throws as Discs.
    explicit HalfLinesTimesDiscs(Eigen::VectorXd radii);

    void project(Eigen::VectorXd &x) const override;

    void split(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient, double step,
               Eigen::VectorXd &free, Eigen::VectorXd &chopped) const override;

    double largest_feasible_step(const Eigen::VectorXd &x,
                                 const Eigen::VectorXd &d) const override;

  private:
    HalfLines half_lines_;
    Discs discs_;
  };
} // namespace stiction::qp
