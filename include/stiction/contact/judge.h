#ifndef stiction_contact_judge_h
#define stiction_contact_judge_h

#include <stiction/contact/contact_conditions.h>
#include <stiction/elasticity/linear_algebra.h>

#include <Eigen/Core>

#include <memory>

namespace stiction
{
  class Certificate;
  class ContactSurface;
  class DualOperator;
  class LinearElasticity;
  class StiffnessSolver;

  /// What decides whether contact forces solve the problem, whatever method
  /// found them.
  class Judge
  {
  public:
    virtual ~Judge() = default;

    /// The figures of these contact forces, computed afresh; valid until the
    /// next call. Collective.
    virtual const ContactConditions &
    judge(const Eigen::VectorXd &lambda) = 0;
  };



  /// The judge of a body: the displacement in equilibrium with the contact
  /// forces, and the certificate of both.
  class BodyJudge : public Judge
  {
  public:
    /// All arguments must outlive the object.
    BodyJudge(const LinearElasticity &elasticity,
              const ContactSurface &surface,
              StiffnessSolver &solver);
    ~BodyJudge() override;

    const ContactConditions &
    judge(const Eigen::VectorXd &lambda) override;

    /// The same for a displacement that a method brings along. Collective.
    const ContactConditions &
    judge(const LA::Vector &u, const Eigen::VectorXd &lambda);

    /// What the last call of judge() was about. Unit of u: m; hanging nodes
    /// have their displacement.
    const LA::Vector &
    displacement() const
    {
      return *u_;
    }
    Certificate &
    certificate()
    {
      return *certificate_;
    }

  private:
    const LinearElasticity &elasticity_;
    const ContactSurface &surface_;
    StiffnessSolver &solver_;
    std::unique_ptr<LA::Vector> u_;
    std::unique_ptr<Certificate> certificate_;
  };



  /// The judge of a problem that is known by Q and h alone: r = Qλ − h by a
  /// fresh product. There is no body whose equilibrium could be checked.
  class DualProblemJudge : public Judge
  {
  public:
    /// @param areas nodal areas, or empty: then all nodes count alike.
    DualProblemJudge(const DualOperator &Q,
                     const qp::SlipBound &slip_bound,
                     const Eigen::VectorXd &areas);

    /// Scales: S = Σ‖λ_i‖ shared out by areas, u0 = λᵀQλ/S.
    const ContactConditions &
    judge(const Eigen::VectorXd &lambda) override;

  private:
    const DualOperator &Q_;
    const qp::SlipBound &slip_bound_;
    Eigen::VectorXd share_; ///< of a node in the force, sum 1
    std::unique_ptr<ContactConditions> conditions_;
  };
} // namespace stiction

#endif
