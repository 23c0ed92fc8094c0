#ifndef stiction_elasticity_linear_elasticity_h
#define stiction_elasticity_linear_elasticity_h

#include <stiction/elasticity/linear_algebra.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <string>

namespace stiction
{
  class Body;
  class MeshLevel;
  class Parameters;
  template<typename Number>
  class StiffnessOperator;

  /// The elastic body under its loads, without contact: K u = f.
  ///
  /// Products with K as it is, for the reactions at the supports, the strain
  /// energy and the certificate, are made cell by cell without a matrix, or
  /// with the assembled one if the body is not simple. K with the prescribed
  /// displacements eliminated is assembled for the solvers that need a matrix.
  ///
  /// Where there are hanging nodes, u = C û, K is CᵀKC and f is Cᵀf: the
  /// unknowns of hanging nodes have neither stiffness nor load, so that no sum
  /// over unknowns sees them. distribute() gives them their displacement.
  class LinearElasticity
  {
  public:
    /// Assembles the loads, and the stiffness matrix unless the solver chosen
    /// in the parameters works without one.
    ///
    /// Throws InputError for boundary conditions that cannot be read, on
    /// boundaries the mesh does not have, or that contradict each other.
    LinearElasticity(const Body &body, const Parameters &parameters);
    ~LinearElasticity();

    const Body &
    body() const
    {
      return body_;
    }

    /// Lamé's λ and G = μ in Pa.
    double
    lame_lambda() const
    {
      return lame_lambda_;
    }
    double
    shear_modulus() const
    {
      return shear_modulus_;
    }

    /// Whether the displacement of an owned unknown, or one of a neighbouring
    /// cell, is prescribed, and where.
    bool
    is_prescribed(const dealii::types::global_dof_index dof) const
    {
      return constraints_.is_constrained(dof) && !is_hanging(dof);
    }
    double
    prescribed_value(const dealii::types::global_dof_index dof) const
    {
      return constraints_.get_inhomogeneity(dof);
    }

    /// Whether an unknown follows from those of other nodes.
    bool
    is_hanging(dealii::types::global_dof_index dof) const;

    /// Gives hanging nodes the displacement that follows from the others.
    /// Collective.
    void
    distribute(LA::Vector &u) const;

    /// The prescribed displacements and the hanging nodes.
    const dealii::AffineConstraints<double> &
    constraints() const
    {
      return constraints_;
    }

    /// K with prescribed displacements eliminated symmetrically: positive
    /// definite if the body is held. Unit: N/m. Throws std::logic_error if it
    /// was not assembled.
    const LA::SparseMatrix &
    constrained_stiffness() const;

    /// The diagonal of K; zero at hanging nodes. Collective.
    LA::Vector
    stiffness_diagonal() const;

    /// The right-hand side that goes with it. Unit: N (m × diagonal entry in
    /// constrained rows).
    const LA::Vector &
    constrained_load() const;

    /// The nodal forces of the tractions, at constrained unknowns too. Unit:
    /// N.
    const LA::Vector &
    load() const;

    /// A distributed vector of zeros for displacements or nodal forces.
    LA::Vector
    zero_vector() const;

    /// K u, prescribed displacements being displacements like any. Unit: N.
    /// Collective.
    LA::Vector
    internal_force(const LA::Vector &u) const;

    /// The nodes of the mesh, and K on them.
    const MeshLevel &
    mesh() const
    {
      return *mesh_;
    }
    const StiffnessOperator<double> &
    stiffness() const
    {
      return *stiffness_;
    }

    /// Throws InputError, naming the free rigid-body motions, if the
    /// prescribed displacements do not hold the body.
    void
    require_support() const;

  private:
    void
    read_boundary_conditions(const Parameters &parameters);

    void
    assemble_load();

    /// K, cell by cell or assembled.
    void
    make_stiffness();

    /// K with prescribed displacements eliminated.
    void
    constrain_stiffness();

    /// That of a simple body.
    void
    assemble_simple_stiffness();

    /// The right-hand side with prescribed displacements eliminated.
    void
    constrain_load();

    const Body &body_;
    const double lame_lambda_, shear_modulus_;

    struct BoundaryData;
    std::unique_ptr<BoundaryData> boundary_;

    dealii::AffineConstraints<double> constraints_;
    std::unique_ptr<MeshLevel> mesh_;
    std::unique_ptr<StiffnessOperator<double>> stiffness_;
    std::unique_ptr<LA::SparseMatrix> constrained_stiffness_;
    std::unique_ptr<LA::Vector> constrained_load_, load_;
    std::string support_location_;
  };
} // namespace stiction

#endif
