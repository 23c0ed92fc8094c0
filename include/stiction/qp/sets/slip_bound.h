#pragma once

#include <Eigen/Core>

namespace stiction::qp
{
  struct Scaling;

  /// The slip bound as a function of the contact forces, node by node
  /// g_i = c_i + F_i max(λ_ν,i, 0): fixed (given friction, and none with c = 0)
  /// or by Coulomb's law. Different nodes may follow different laws. A node with
  /// c_i = ∞ is tied: it neither slips nor opens, and its force is any vector.
  class SlipBound
  {
  public:
    /// No contact nodes.
    SlipBound() = default;

    /// g_i ≥ 0, unit: N, infinite where a node is tied.
    static SlipBound given(Eigen::VectorXd g);

    /// g_i = F_i max(λ_ν,i, 0), F_i ≥ 0 without a unit.
    static SlipBound coulomb(Eigen::VectorXd F);

    /// Both, each at its own nodes: c_i ≥ 0 in N, F_i ≥ 0 without a unit.
    static SlipBound mixed(Eigen::VectorXd c, Eigen::VectorXd F);

    /// Whether the bound depends on the contact forces.
    bool is_coulomb() const { return is_coulomb_; }

    /// The largest F, 0 if there is none.
    double largest_coefficient() const
    {
      return coefficient_.size() > 0 ? coefficient_.maxCoeff() : 0.;
    }

    /// Solutions are proved to exist and to be unique for small coefficients
    /// only; examples of none or several are known from about this one on.
    static constexpr double large_coefficient = 1.;

    /// Whether there may be several solutions.
    bool may_have_several_solutions() const
    {
      return largest_coefficient() > large_coefficient;
    }

    /// Whether neither law alone describes it.
    bool is_mixed() const { return is_coulomb_ && !constant_.isZero(0.); }

    /// The fixed part c, and the coefficients F.
    const Eigen::VectorXd &constant() const { return constant_; }
    const Eigen::VectorXd &coefficient() const { return coefficient_; }

    /// g with given friction, F with Coulomb's; not for a mixed bound.
    const Eigen::VectorXd &data() const { return is_coulomb_ ? coefficient_ : constant_; }

    Eigen::Index n_nodes() const { return constant_.size(); }

    bool is_tied(Eigen::Index node) const;
    bool has_tied() const;

    /// Whether friction can act at a node without pressure, of a node that is not tied.
    bool is_given(const Eigen::Index node) const
    {
      return constant_(node) > 0. && !is_tied(node);
    }

    /// Whether friction can act without pressure anywhere.
    bool has_given() const;

    /// Whether no tangential force can act at a node at all.
    bool is_frictionless(const Eigen::Index node) const
    {
      return constant_(node) == 0. && coefficient_(node) == 0.;
    }

    /// The bound for contact forces (λ_ν; λ_t1; λ_t2); the first n_nodes()
    /// entries of @p lambda are looked at.
    Eigen::VectorXd at(const Eigen::VectorXd &lambda) const;

  private:
    SlipBound(Eigen::VectorXd c, Eigen::VectorXd F, bool is_coulomb);

    Eigen::VectorXd constant_, coefficient_;
    bool is_coulomb_ = false;
  };

  /// Replaces contact forces by the nearest ones within the slip bound that they
  /// themselves ask for; entries as below. Forces that are no numbers stay.
  void project(Eigen::VectorXd &x, const SlipBound &slip_bound);

  /// The natural residual (FeasibleSet::natural_residual()) of contact forces
  /// with the slip bound that they themselves ask for, entries (ν; t1; t2), or
  /// (t1; t2) for given friction on discs alone; NaN where an entry is none.
  double natural_residual(const Eigen::VectorXd &x, const Eigen::VectorXd &gradient,
                          const SlipBound &slip_bound, const Scaling &scaling);
} // namespace stiction::qp
