#ifndef stiction_contact_coulomb_fixed_point_h
#define stiction_contact_coulomb_fixed_point_h

#include <stiction/contact/certificate.h>
#include <stiction/contact/given_friction.h>
#include <stiction/elasticity/linear_algebra.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  class SchurComplement;
  class StiffnessSolver;
  struct ContactSolverParameters;

  /// One row of the convergence history.
  struct ContactStep
  {
    unsigned int step      = 0;  ///< number of the outermost iteration
    unsigned int sweeps    = 0;  ///< Gauss–Seidel sweeps so far
    double multiplications = 0.; ///< products with Q so far
    double residual        = 0.; ///< natural residual after the step
    double change          = 0.; ///< relative change of λ in the step
    double contraction     = 0.; ///< residual over the one before
    double normal_force    = 0.; ///< Σλ_ν in N
  };



  /// The answer and how it was found.
  struct ContactSolution
  {
    std::unique_ptr<LA::Vector> u; ///< displacement, m
    Eigen::VectorXd lambda;        ///< contact forces, N, length 3m
    std::unique_ptr<Certificate> certificate;

    bool converged = false; ///< as the certificate says
    std::string reason; ///< if not: what stopped the iteration, what to change
    unsigned int coulomb_iterations = 0;
    unsigned int sweeps             = 0;
  };



  /// Coulomb friction by successive approximations: given friction with the
  /// slip bound g = F λ_ν of the last contact forces, again and again until
  /// λ is its own bound.
  ///
  /// An approximation is solved only to a fixed part of the error with which
  /// it starts. With given friction or none the bound stays, and one
  /// approximation is all. The certificate alone decides on success; it is
  /// computed after every approximation and hands back the gradient Qλ − h
  /// free of rounding, because that is what its gaps and slips are.
  class CoulombFixedPoint
  {
  public:
    using Observer = std::function<void(const ContactStep &)>;

    /// All arguments must outlive the object.
    CoulombFixedPoint(const LinearElasticity &elasticity,
                      const ContactSurface &surface,
                      const SchurComplement &schur,
                      StiffnessSolver &stiffness_solver,
                      GivenFrictionSolver &given_friction_solver,
                      const ContactSolverParameters &parameters);

    /// Solves from zero contact forces. The observer sees every approximation
    /// with Coulomb friction, every sweep otherwise. Collective.
    ContactSolution
    solve(const Observer &observer);

  private:
    /// The displacement and the certificate that belong to the contact forces.
    void
    certify(ContactSolution &solution) const;

    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;
    const SchurComplement &schur_;
    StiffnessSolver &stiffness_solver_;
    GivenFrictionSolver &given_friction_solver_;
    const ContactSolverParameters &parameters_;
  };
} // namespace stiction

#endif
