#ifndef stiction_qp_operators_symmetric_operator_h
#define stiction_qp_operators_symmetric_operator_h

#include <Eigen/Core>

namespace stiction::qp
{
  class SlipBound;

  /// A symmetric positive definite linear map, known only by its action.
  ///
  /// The quadratic programs of this layer see their Hessian through this
  /// interface, so that the same solver serves a dense matrix and a product
  /// that costs an elastic solve. Multiplications are counted, because they
  /// are what a dual method pays for.
  class SymmetricOperator
  {
  public:
    virtual ~SymmetricOperator() = default;

    /// Number of rows and of columns.
    virtual Eigen::Index size() const = 0;

    /// dst = A src, both of length size(); counted.
    void vmult(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const;

    /// How many times vmult() was called.
    unsigned long n_multiplications() const { return n_multiplications_; }

  protected:
    virtual void apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const = 0;

  private:
    mutable unsigned long n_multiplications_ = 0;
  };

  /// Moves contact forces into the set of their slip bound (project()), and their
  /// gradient Ax − b along; a product, unless they are in it.
  void make_feasible(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                     const SymmetricOperator &A, const SlipBound &slip_bound);

  /// A dense symmetric matrix as an operator. The matrix is not copied and
  /// must outlive the operator.
  class DenseOperator : public SymmetricOperator
  {
  public:
    explicit DenseOperator(const Eigen::MatrixXd &matrix);

    Eigen::Index size() const override;

  protected:
    void apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const override;

  private:
    const Eigen::MatrixXd &matrix_;
  };
} // namespace stiction::qp

#endif
