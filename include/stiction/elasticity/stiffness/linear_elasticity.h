#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/model/body_parameters.h>
#include <stiction/elasticity/model/free_motions.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace stiction
{
  class Body;
  class Loads;
  class Materials;
  class MeshLevel;
  class PrescribedDisplacement;
  template<typename Number> class StiffnessOperator;

  /// The elastic body under its loads, without contact: K u = f.
  ///
  /// Products with K as it is, for the reactions at the supports, the strain
  /// energy and the certificate, are made cell by cell without a matrix. K with the
  /// prescribed displacements eliminated is assembled for the solvers that need a matrix.
  ///
  /// Where there are hanging nodes, u = C û, K is CᵀKC and f is Cᵀf: the
  /// unknowns of hanging nodes have neither stiffness nor load, so that no sum
  /// over unknowns sees them. distribute() gives them their displacement.
  class LinearElasticity
  {
  public:
    /// Makes the stiffness, and the loads at 'Boundary conditions/Time'.
    ///
    /// The body and what the parameters refer to must outlive the object.
    ///
    /// Throws InputError for materials or boundary conditions that cannot be
    /// read, that the mesh does not have, or that contradict each other.
    LinearElasticity(const Body &body, const BodyParameters &parameters);
    ~LinearElasticity();

    /// Makes loads and prescribed displacements those of another time, in place; K
    /// stays as it is. Collective. Throws InputError where a formula has no finite
    /// value.
    void set_time(double time);

    /// The t of the present loads.
    double time() const { return time_; }

    const Body &body() const { return body_; }

    const Materials &materials() const { return *materials_; }

    /// Whether the displacement of an owned unknown, or one of a neighbouring
    /// cell, is prescribed, and where.
    bool is_prescribed(const dealii::types::global_dof_index dof) const
    {
      return constraints_.is_constrained(dof) && !is_hanging(dof);
    }
    double prescribed_value(const dealii::types::global_dof_index dof) const
    {
      return constraints_.get_inhomogeneity(dof);
    }

    /// Gives u its prescribed values.
    void prescribe(LA::Vector &u) const;

    /// The rigid motions that nothing but contact can hold.
    const FreeMotions &free_motions() const { return *free_motions_; }

    /// Chooses as many anchors as there are free motions: unknowns that
    /// constrained_stiffness() holds, so that it is positive definite. For loads that
    /// do no work along free motions nothing acts there, and its inverse gives the
    /// displacement but for such a motion. Collective.
    ///
    /// @param first_dofs of nodes that are left out if others are enough.
    void choose_anchors(const std::vector<dealii::types::global_dof_index> &first_dofs);

    /// The anchors, the same on all ranks.
    const std::vector<dealii::types::global_dof_index> &anchors() const
    {
      return anchors_;
    }

    /// The amounts α of the free motions for which u − Zα is zero at the anchors, m.
    /// Collective.
    Eigen::VectorXd free_motion_of(const LA::Vector &u) const;

    /// Whether the displacement of an owned unknown is prescribed or it is an anchor.
    bool is_fixed(dealii::types::global_dof_index dof) const;

    /// Zᵀ f of free motions Z and nodal forces f, N. Collective.
    Eigen::VectorXd work_along_free_motions(const LA::Vector &force) const;

    /// That of the loads, 0 where it is what rounding leaves of loads that balance one
    /// another. Collective.
    Eigen::VectorXd work_of_loads_along_free_motions() const;

    /// u += Σ α_j Z_j with free motions Z.
    void add_free_motion(const Eigen::VectorXd &amounts, LA::Vector &u) const;

    /// Whether an unknown follows from those of other nodes.
    bool is_hanging(dealii::types::global_dof_index dof) const;

    /// Gives hanging nodes the displacement that follows from the others.
    /// Collective.
    void distribute(LA::Vector &u) const;

    /// The prescribed displacements and the hanging nodes.
    const dealii::AffineConstraints<double> &constraints() const { return constraints_; }

    /// K with prescribed displacements and anchors eliminated symmetrically: positive
    /// definite. Unit: N/m. Assembled by the first call, which is collective.
    const LA::SparseMatrix &constrained_stiffness() const;

    /// K without any boundary condition, assembled; rows of hanging nodes are zero.
    /// Collective.
    std::unique_ptr<LA::SparseMatrix> assemble() const;

    /// The diagonal of K; zero at hanging nodes. Collective.
    LA::Vector stiffness_diagonal() const;

    /// The right-hand side that goes with it. Unit: N (m × diagonal entry in
    /// constrained rows, 0 at anchors).
    const LA::Vector &constrained_load() const { return constrained_load_; }

    /// The nodal forces of the loads, at constrained unknowns too. Unit:
    /// N.
    const LA::Vector &load() const { return load_; }

    /// A distributed vector of zeros for displacements or nodal forces.
    LA::Vector zero_vector() const;

    /// K u, prescribed displacements being displacements like any. Unit: N.
    /// Collective.
    LA::Vector internal_force(const LA::Vector &u) const;

    /// The nodes of the mesh, and K on them.
    const MeshLevel &mesh() const { return *mesh_; }
    const StiffnessOperator<double> &stiffness() const { return *stiffness_; }

    /// Where the body is held, and what pulls at it.
    const PrescribedDisplacement &prescribed_displacement() const
    {
      return *prescribed_displacement_;
    }
    const Loads &loads() const { return *loads_; }

  private:
    /// Reads supports and loads at a time.
    void read_conditions(double time);

    void assemble_load();

    /// The right-hand side with prescribed displacements eliminated.
    void constrain_load();

    const Body &body_;
    const BodyParameters parameters_;
    double time_;
    std::unique_ptr<Materials> materials_;
    std::unique_ptr<PrescribedDisplacement> prescribed_displacement_;
    std::unique_ptr<Loads> loads_;
    dealii::AffineConstraints<double> constraints_;
    std::unique_ptr<FreeMotions> free_motions_;
    std::vector<dealii::types::global_dof_index> anchors_;
    std::unique_ptr<MeshLevel> mesh_;
    std::unique_ptr<StiffnessOperator<double>> stiffness_;
    mutable std::unique_ptr<LA::SparseMatrix> constrained_stiffness_;
    LA::Vector constrained_load_, load_;
  };
} // namespace stiction
