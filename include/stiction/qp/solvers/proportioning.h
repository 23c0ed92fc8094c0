#pragma once

#include <stiction/qp/solvers/active_set_method.h>

namespace stiction::qp
{
  /// What Proportioning does in its steps. {3, true} in variables with one scale a
  /// node (Mpgp) takes a third to a quarter of the products that the standard method
  /// of the literature takes on the first two rows of the paper's Table 1.
  struct ProportioningOptions
  {
    /// Γ > 0 weighs the free gradient against the chopped one: the larger it
    /// is, the longer the free nodes are improved before a release.
    double gamma = 1.;

    /// Releases are first tried as P(x − α r) with a SpectralStep α, and kept
    /// if the energy falls.
    bool spectral_release = false;
  };

  /// Conjugate gradients with proportioning and gradient projections for any
  /// feasible set: the paper's reference [1] for its first quadratic program
  /// (on half-lines), with the rules of MPRGP (Dostál and Schöberl 2005).
  ///
  /// A release is a proportioning step: on half-lines the exact minimiser
  /// along the chopped gradient, elsewhere the projected gradient step of
  /// fixed length. On half-lines this converges R-linearly at a rate given by
  /// the spectrum of A alone.
  class Proportioning : public ActiveSetMethod
  {
  public:
    /// As ActiveSetMethod.
    Proportioning(const SymmetricOperator &A, const FeasibleSet &set, double norm,
                  const ProportioningOptions &options = {});

  protected:
    bool must_release(const Scaling &scaling, double tolerance) const override;

    void release() override;

  private:
    const ProportioningOptions options_;
  };
} // namespace stiction::qp
