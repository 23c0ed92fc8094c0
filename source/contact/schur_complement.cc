#include <stiction/contact/contact_surface.h>
#include <stiction/contact/schur_complement.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/stiffness_solver.h>

#include <deal.II/lac/trilinos_vector.h>

namespace stiction
{
  namespace
  {
    unsigned long
    thirds(const DualBlock block)
    {
      switch (block)
        {
          case DualBlock::normal:
            return 1;
          case DualBlock::tangential:
            return 2;
          default:
            return 3;
        }
    }



    /// Q as a dense symmetric matrix.
    class AssembledSchurComplement : public SchurComplement
    {
    public:
      AssembledSchurComplement(const LinearElasticity &elasticity,
                               const ContactSurface &surface,
                               StiffnessSolver &solver)
        : SchurComplement(elasticity, surface)
      {
        // Q = R C Rᵀ with C the block of K⁻¹ at the contact unknowns
        const Eigen::MatrixXd RC =
          surface.to_local(solver.compliance(surface.trace()));
        Q_ = surface.to_local(RC.transpose());
        set_right_hand_side(solver);
      }

    protected:
      void
      apply(const DualBlock rows,
            const DualBlock columns,
            Eigen::VectorXd &dst,
            const Eigen::VectorXd &src) const override
      {
        dst.noalias() =
          Q_.block(begin(rows), begin(columns), length(rows), length(columns)) *
          src;
      }

    private:
      Eigen::MatrixXd Q_;
    };



    /// Q by its definition: contact forces on the body, an elastic solve, the
    /// displacements of the contact nodes.
    class SchurComplementBySolves : public SchurComplement
    {
    public:
      SchurComplementBySolves(const LinearElasticity &elasticity,
                              const ContactSurface &surface,
                              StiffnessSolver &solver)
        : SchurComplement(elasticity, surface)
        , solver_(solver)
      {
        set_right_hand_side(solver);
      }

    protected:
      void
      apply(const DualBlock rows,
            const DualBlock columns,
            Eigen::VectorXd &dst,
            const Eigen::VectorXd &src) const override
      {
        Eigen::VectorXd lambda = Eigen::VectorXd::Zero(3 * n_nodes());
        lambda.segment(begin(columns), length(columns)) = src;

        LA::Vector force = elasticity_.zero_vector();
        LA::Vector u     = elasticity_.zero_vector();
        surface_.add_transpose_B(1., lambda, force);
        solver_.solve(u, force);
        dst = surface_.apply_B(u).segment(begin(rows), length(rows));
      }

    private:
      StiffnessSolver &solver_;
    };
  } // namespace



  SchurComplement::SchurComplement(const LinearElasticity &elasticity,
                                   const ContactSurface &surface)
    : elasticity_(elasticity)
    , surface_(surface)
    , n_nodes_(surface.n_nodes())
  {
  }



  std::unique_ptr<SchurComplement>
  SchurComplement::create(const std::string &form,
                          const LinearElasticity &elasticity,
                          const ContactSurface &surface,
                          StiffnessSolver &solver)
  {
    if (form == "by solves")
      return std::make_unique<SchurComplementBySolves>(
        elasticity, surface, solver);
    return std::make_unique<AssembledSchurComplement>(
      elasticity, surface, solver);
  }



  void
  SchurComplement::set_right_hand_side(StiffnessSolver &solver)
  {
    LA::Vector u = elasticity_.zero_vector();
    solver.solve(u, elasticity_.constrained_load());
    h_ = surface_.apply_B(u);
    h_.head(n_nodes_) -= surface_.gaps();
  }



  void
  SchurComplement::vmult(const DualBlock rows,
                         const DualBlock columns,
                         Eigen::VectorXd &dst,
                         const Eigen::VectorXd &src) const
  {
    n_ninths_ += thirds(rows) * thirds(columns);
    apply(rows, columns, dst, src);
  }



  Eigen::Index
  SchurComplement::begin(const DualBlock block) const
  {
    return block == DualBlock::tangential ? n_nodes_ : 0;
  }



  Eigen::Index
  SchurComplement::length(const DualBlock block) const
  {
    return static_cast<Eigen::Index>(thirds(block)) * n_nodes_;
  }



  // ----------------------------------------------------------- SchurBlock

  SchurBlock::SchurBlock(const SchurComplement &schur, const DualBlock block)
    : schur_(schur)
    , block_(block)
  {
  }



  Eigen::Index
  SchurBlock::size() const
  {
    return static_cast<Eigen::Index>(thirds(block_)) * schur_.n_nodes();
  }



  void
  SchurBlock::apply(Eigen::VectorXd &dst, const Eigen::VectorXd &src) const
  {
    schur_.vmult(block_, block_, dst, src);
  }
} // namespace stiction
