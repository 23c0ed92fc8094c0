#pragma once

#include <stiction/qp/methods/dual_method.h>

#include <memory>

namespace stiction
{
  /// Coulomb friction by successive approximations, in the paper's order:
  /// given friction with the slip bound g = Fλ_ν of the last contact forces,
  /// again and again until λ is its own bound.
  ///
  /// An approximation is solved only to a fixed part of the error with which
  /// it starts; the factor by which that error falls is observed.
  class CoulombFixedPoint : public DualMethod
  {
  public:
    /// @param given_friction the method for each approximation.
    explicit CoulombFixedPoint(std::unique_ptr<DualMethod> given_friction);

    DualMethodResult solve(DualIterate &iterate, const Task &task) override;

    bool solves_coulomb() const override { return true; }

    DualMethodStatistics statistics() const override;

  private:
    std::unique_ptr<DualMethod> given_friction_;
    unsigned int iterations_ = 0;
    double contraction_      = 0.;
  };
} // namespace stiction
