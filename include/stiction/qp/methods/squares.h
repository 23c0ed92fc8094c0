#pragma once

#include <stiction/qp/methods/dual_method.h>
#include <stiction/qp/operators/dual_operator.h>

namespace stiction
{
  /// Given friction with every disc replaced by r rotated squares, the
  /// methods ALG_2 and ALG_4 that the paper compares with, as a quadratic
  /// program with bounds only in m + 2rm unknowns (qp::RotatedSquares).
  ///
  /// Solves another problem than the other methods: its forces may exceed the
  /// slip bound by 1/cos(π/4r) − 1 (8.2 % for r = 2, 2.0 % for r = 4), and
  /// their angle be off by 45°/r.
  class Squares : public DualMethod
  {
  public:
    /// The operator must outlive the method. @param r number of squares.
    Squares(const DualOperator &Q, unsigned int r);

    /// The iterate ends feasible for the polygons, not for the discs, and the
    /// residual is that of the problem with polygons.
    DualMethodResult solve(DualIterate &iterate, const Task &task) override;

    bool solves_coulomb() const override { return false; }

    std::string limitation() const override;

  private:
    qp::SymmetricOperator block_;
    const unsigned int r_;
  };
} // namespace stiction
