#ifndef stiction_contact_certificate_body_verifier_h
#define stiction_contact_certificate_body_verifier_h

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/qp/verifier.h>

#include <Eigen/Core>

#include <memory>

namespace stiction
{
  class Certificate;
  class ContactSurface;
  class LinearElasticity;
  class StiffnessSolver;

  /// The verifier of a body: the displacement in equilibrium with the contact
  /// forces, and the certificate of both.
  class BodyVerifier : public Verifier
  {
  public:
    /// All arguments must outlive the object.
    BodyVerifier(const LinearElasticity &elasticity, const ContactSurface &surface,
                 StiffnessSolver &solver);
    ~BodyVerifier() override;

    const ContactConditions &verify(const Eigen::VectorXd &lambda) override;

    /// The same for a displacement that a method brings along. Collective.
    const ContactConditions &verify(const LA::Vector &u, const Eigen::VectorXd &lambda);

    /// What the last call of verify() was about. Unit of u: m; hanging nodes
    /// have their displacement.
    const LA::Vector &displacement() const { return *u_; }
    Certificate &certificate() { return *certificate_; }

  private:
    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;
    StiffnessSolver &solver_;
    std::unique_ptr<LA::Vector> u_;
    std::unique_ptr<Certificate> certificate_;
  };
} // namespace stiction

#endif
