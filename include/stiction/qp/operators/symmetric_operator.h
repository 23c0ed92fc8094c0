#pragma once

#include <Eigen/Core>

#include <functional>

namespace stiction::qp
{
  class SlipBound;

  /// A symmetric positive definite linear map, known only by its action.
  ///
  /// The quadratic programs of this layer see their Hessian through it, so that
  /// the same solver serves a dense matrix and a product that costs an elastic
  /// solve. Multiplications are counted, because they are what a dual method
  /// pays for.
  class SymmetricOperator
  {
  public:
    /// dst = A src.
    using Product = std::function<void(Eigen::VectorXd &dst, const Eigen::VectorXd &src)>;

    /// @param product what it refers to must outlive the operator.
    SymmetricOperator(Eigen::Index size, Product product);

    /// Number of rows and of columns.
    Eigen::Index size() const { return size_; }

    /// dst = A src, both of length size(); counted.
    void vmult(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const;

    /// How many times vmult() was called.
    unsigned long n_multiplications() const { return n_multiplications_; }

  private:
    Eigen::Index size_;
    Product product_;
    mutable unsigned long n_multiplications_ = 0;
  };

  /// Moves x to a target, and its gradient Ax − b along; a product, unless it is there.
  void move_to(const Eigen::VectorXd &target, Eigen::VectorXd &x,
               Eigen::VectorXd &gradient, const SymmetricOperator &A);

  /// The same with the nearest contact forces of the slip bound (project()) as target.
  void make_feasible(Eigen::VectorXd &x, Eigen::VectorXd &gradient,
                     const SymmetricOperator &A, const SlipBound &slip_bound);
} // namespace stiction::qp
