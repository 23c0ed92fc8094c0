#ifndef stiction_contact_certificate_body_verifier_h
#define stiction_contact_certificate_body_verifier_h

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
    /// The places of pressed obstacles that go with contact forces, m.
    using Distances = std::function<Eigen::VectorXd(const Eigen::VectorXd &lambda)>;

    /// @param state what is certified; verify() changes it. All arguments must
    ///   outlive the object.
    BodyVerifier(const LinearElasticity &elasticity, const ContactSurface &surface,
                 StiffnessSolver &solver, State &state, Distances distances);
    ~BodyVerifier() override;

    const ContactConditions &verify(const Eigen::VectorXd &lambda) override;

    /// What the last call of verify() returned.
    const Certificate &certificate() const { return *certificate_; }

  private:
    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;
    StiffnessSolver &solver_;
    State &state_;
    const Distances distances_;
    std::unique_ptr<Certificate> certificate_;
  };
} // namespace stiction

#endif
