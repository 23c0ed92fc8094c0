#ifndef stiction_qp_slip_bound_h
#define stiction_qp_slip_bound_h

#include <Eigen/Core>

namespace stiction::qp
{
  struct Scaling;

  /// The slip bound g as a function of the contact forces: fixed (given
  /// friction, and none with g = 0) or F λ_ν (Coulomb friction).
  class SlipBound
  {
  public:
    /// No contact nodes.
    SlipBound() = default;

    /// g_i ≥ 0, unit: N.
    static SlipBound
    given(Eigen::VectorXd g);

    /// g_i = F_i max(λ_ν,i, 0), F_i ≥ 0 without a unit.
    static SlipBound
    coulomb(Eigen::VectorXd F);

    /// Whether the bound depends on the contact forces.
    bool
    is_coulomb() const
    {
      return is_coulomb_;
    }

    /// g with given friction, F with Coulomb's.
    const Eigen::VectorXd &
    data() const
    {
      return data_;
    }

    Eigen::Index
    n_nodes() const
    {
      return data_.size();
    }

    /// The bound for contact forces (λ_ν; λ_t1; λ_t2); the first n_nodes()
    /// entries of @p lambda are looked at.
    Eigen::VectorXd
    at(const Eigen::VectorXd &lambda) const;

  private:
    SlipBound(Eigen::VectorXd data, bool is_coulomb);

    Eigen::VectorXd data_;
    bool is_coulomb_ = false;
  };


  /// The natural residual (FeasibleSet::natural_residual()) of contact forces
  /// with the slip bound that they themselves ask for, entries (ν; t1; t2), or
  /// (t1; t2) for given friction on discs alone; NaN where an entry is none.
  double
  natural_residual(const Eigen::VectorXd &x,
                   const Eigen::VectorXd &gradient,
                   const SlipBound &slip_bound,
                   const Scaling &scaling);
} // namespace stiction::qp

#endif
