#pragma once

#include <stiction/qp/operators/dual_operator.h>

#include <memory>
#include <string>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  class StiffnessSolver;

  /// The contact dual operator of a body, Q = B K⁻¹ Bᵀ and
  /// h = B K⁻¹ f − e: the condensation of the body to its contact
  /// nodes, by its definition. A product is an elastic solve: contact forces
  /// on the body, displacements of the contact nodes.
  ///
  /// In directions in which a node is held, the rows and columns of B are zero
  /// and Q has a positive entry on its diagonal: it is definite, and λ = 0
  /// there, whatever the entry.
  class SchurComplement : public DualOperator
  {
  public:
    /// The form chosen in the parameter file: "assembled" (a dense matrix) or
    /// "by solves" (this class). Collective; computes h by one solve.
    static std::unique_ptr<DualOperator> create(const std::string &form,
                                                const LinearElasticity &elasticity,
                                                const ContactSurface &surface,
                                                StiffnessSolver &solver);

    /// The block of K⁻¹ at ContactOperator::all_dofs(), without anchors: what an
    /// assembled Q is made of, whatever the frames. Collective.
    static Eigen::MatrixXd compliance(const LinearElasticity &elasticity,
                                      const ContactSurface &surface,
                                      StiffnessSolver &solver);

    /// Q of that as a dense matrix. Collective.
    static std::unique_ptr<DualOperator> assembled(Eigen::MatrixXd compliance,
                                                   const LinearElasticity &elasticity,
                                                   const ContactSurface &surface,
                                                   StiffnessSolver &solver);

    /// h of the present loads and obstacles: one solve. Collective.
    static Eigen::VectorXd right_hand_side_of(const LinearElasticity &elasticity,
                                              const ContactSurface &surface,
                                              StiffnessSolver &solver);

    /// All arguments must outlive the object. Collective.
    SchurComplement(const LinearElasticity &elasticity, const ContactSurface &surface,
                    StiffnessSolver &solver);

  protected:
    /// Estimated: a node gives way in proportion to the inverse of its own
    /// diagonal entries of K; the factor is that of one product with Q.
    Eigen::VectorXd compute_nodal_compliance() const override;

    void apply(DualBlock rows, DualBlock columns, Eigen::VectorXd &dst,
               const Eigen::VectorXd &src) const override;

  private:
    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;
    StiffnessSolver &solver_;
    const Eigen::VectorXd held_compliance_; ///< length 3m, 0 where not held
  };
} // namespace stiction
