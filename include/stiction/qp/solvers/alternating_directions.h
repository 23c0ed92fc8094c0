#ifndef stiction_qp_solvers_alternating_directions_h
#define stiction_qp_solvers_alternating_directions_h

#include <stiction/qp/solvers/solver_run.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <functional>

namespace stiction::qp
{
  class SlipBound;
  class SymmetricOperator;
  struct Scaling;

  /// Contact with friction by the alternating direction method of multipliers:
  /// x minimises ½ xᵀQx − xᵀh with a quadratic pull towards z, z is x moved to
  /// the nearest admissible forces, and u sums up what separates them.
  ///
  /// The pull is that of the nodal compliances (another force a node), times a
  /// factor that grows when x and z disagree by more than z moves and shrinks
  /// when it is the other way round, less and less often, because each change
  /// asks for a new Cholesky factor of Q + D. Over-relaxed by 1.7. With Coulomb
  /// friction the disc of a node has the radius F z_ν of the same iteration.
  /// Converges for given friction (Boyd et al. 2011) whatever the factor.
  class AlternatingDirections
  {
  public:
    /// Called after each iteration with the natural residual.
    using Observer = std::function<void(double residual)>;

    /// @param matrix Q, of order 3m.
    /// @param Q the same as an operator, which counts products. Both must
    ///   outlive the object.
    /// @param nodal_compliance how much a node gives way to its own force alone,
    ///   length m, m/N.
    AlternatingDirections(const Eigen::MatrixXd &matrix, const SymmetricOperator &Q,
                          const Eigen::VectorXd &nodal_compliance);

    /// Moves x until its natural residual is at most tolerance. The returned x
    /// is feasible for its own slip bound.
    ///
    /// @param gradient in: Qx − h at the given x; out: at the returned one.
    SolverRun solve(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                    const SlipBound &slip_bound, const Scaling &scaling, double tolerance,
                    unsigned int max_iterations, const Observer &observer);

  private:
    /// Factorises Q + factor·D.
    void factorize(double factor);

    const Eigen::MatrixXd &matrix_;
    const SymmetricOperator &Q_;
    const Eigen::VectorXd pull_; ///< the diagonal of D, m/N
    double factor_                 = 1.;
    unsigned int n_factorizations_ = 0;
    Eigen::LLT<Eigen::MatrixXd> cholesky_;
  };
} // namespace stiction::qp

#endif
