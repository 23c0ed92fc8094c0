#pragma once

#include <stiction/qp/methods/dual_method.h>
#include <stiction/qp/operators/dual_operator.h>

#include <Eigen/Cholesky>

namespace stiction
{
  /// The alternating direction method of multipliers, for given and Coulomb friction: a
  /// few dozen iterations on any mesh, at the price of dense Cholesky factorisations of
  /// order 3m. λ minimises ½ λᵀQλ − λᵀh with a quadratic pull towards z, z is λ moved to
  /// the nearest admissible forces, and u sums up what separates them.
  ///
  /// The pull is that of the nodal compliances (another force a node), times a
  /// factor that grows when λ and z disagree by more than z moves and shrinks
  /// when it is the other way round, less and less often, because each change
  /// asks for a new Cholesky factor of Q + D. Over-relaxed by 1.7. With Coulomb
  /// friction the disc of a node has the radius F z_ν of the same iteration.
  /// Converges for given friction (Boyd et al. 2011) whatever the factor.
  class Admm : public DualMethod
  {
  public:
    /// The operator must outlive the method. Throws std::invalid_argument if
    /// it has no matrix.
    explicit Admm(const DualOperator &Q);

    DualMethodResult solve(DualIterate &iterate, const Task &task) override;

    bool solves_coulomb() const override { return true; }

  private:
    /// Factorises Q + factor·D.
    void factorize(double factor);

    const Eigen::MatrixXd *matrix_;
    qp::SymmetricOperator Q_;
    const Eigen::VectorXd pull_; ///< the diagonal of D, m/N
    double factor_ = 1.;
    Eigen::LLT<Eigen::MatrixXd> cholesky_;
  };
} // namespace stiction
