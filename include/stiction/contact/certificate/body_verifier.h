#pragma once

#include <stiction/qp/verifier.h>

#include <Eigen/Core>

#include <functional>
#include <memory>

namespace stiction
{
  class Certificate;
  class ContactSurface;
  class LinearElasticity;
  struct State;
  class StiffnessSolver;

  /// The verifier of a body: brings the displacement into equilibrium with the
  /// contact forces and certifies both.
  class BodyVerifier : public Verifier
  {
  public:
    /// What only the balance of the body finds, see rigid_balance().
    struct Places
    {
      Eigen::VectorXd distances;   ///< of pressed obstacles, m
      Eigen::VectorXd free_motion; ///< amounts of the free motions, m
      /// What the contact forces lack to balance the loads, N: the body is brought into
      /// equilibrium with the sum.
      Eigen::VectorXd lacking;
    };
    using PlacesOf = std::function<Places(const Eigen::VectorXd &lambda)>;

    /// @param state what is certified; verify() changes it. @param places that go with
    ///   contact forces. All arguments must outlive the object.
    BodyVerifier(const LinearElasticity &elasticity, const ContactSurface &surface,
                 StiffnessSolver &solver, State &state, PlacesOf places);
    ~BodyVerifier() override;

    const ContactConditions &verify(const Eigen::VectorXd &lambda) override;

    /// What the last call of verify() returned.
    const Certificate &certificate() const { return *certificate_; }

  private:
    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;
    StiffnessSolver &solver_;
    State &state_;
    const PlacesOf places_;
    std::unique_ptr<Certificate> certificate_;
  };
} // namespace stiction
