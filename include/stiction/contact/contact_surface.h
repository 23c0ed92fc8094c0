#ifndef stiction_contact_contact_surface_h
#define stiction_contact_contact_surface_h

#include <stiction/elasticity/linear_algebra.h>
#include <stiction/elasticity/trace.h>
#include <stiction/qp/slip_bound.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <map>
#include <vector>

namespace stiction
{
  class LinearElasticity;
  class Parameters;
  enum class FrictionLaw;

  /// One node of the contact boundary that may touch the foundation.
  struct ContactNode
  {
    dealii::Point<3> position;     ///< undeformed, m
    dealii::Tensor<1, 3> normal;   ///< n, unit, towards the obstacle
    dealii::Tensor<1, 3> tangent1; ///< t1, unit
    dealii::Tensor<1, 3> tangent2; ///< t2 = t1 × n
    double gap = 0.;               ///< d along n, m; negative: interference
    /// A = ∫ φ over the contact boundary, m²; φ has what the shape functions of
    /// hanging nodes add to it.
    double area        = 0.;
    double coefficient = 0.; ///< F of Coulomb's law
    double slip_stress = 0.; ///< τ_c of given friction, Pa
  };



  /// The contact nodes with their frames, gaps, areas and friction data, and
  /// the maps B = (N; T1; T2) and Bᵀ between displacements of the body and
  /// contact quantities.
  ///
  /// The list is known to all ranks, in an order that does not depend on
  /// their number. Vectors over it are stored by blocks (normal; first
  /// tangent; second tangent), each of length m = n_nodes(). Nodes of the
  /// contact boundary whose displacement is prescribed are not contact nodes,
  /// nor are hanging nodes, which follow from others. The contact force is one
  /// number a node and direction, whatever the degree of the elements: λ_i
  /// works on the displacement of node i alone, so that λ_i/A_i is a traction
  /// and Σ A_i the area.
  class ContactSurface
  {
  public:
    /// Collects the contact nodes. Collective.
    ///
    /// Throws InputError if the contact boundary does not exist, is prescribed
    /// itself, has no free node, or if a formula (gap, coefficient, slip
    /// stress) cannot be read or has a value that is not allowed.
    ContactSurface(const LinearElasticity &elasticity,
                   const Parameters &parameters);

    Eigen::Index
    n_nodes() const
    {
      return static_cast<Eigen::Index>(nodes_.size());
    }

    const std::vector<ContactNode> &
    nodes() const
    {
      return nodes_;
    }

    FrictionLaw
    law() const
    {
      return law_;
    }

    /// Initial gaps d_i in m, length m.
    const Eigen::VectorXd &
    gaps() const
    {
      return gaps_;
    }

    /// Nodal areas A_i in m², length m.
    const Eigen::VectorXd &
    areas() const
    {
      return areas_;
    }

    /// |Γc|: the area of the whole contact boundary, its clamped rim included.
    double
    boundary_area() const
    {
      return boundary_area_;
    }

    /// The boundary id of the contact boundary.
    dealii::types::boundary_id
    boundary_id() const
    {
      return boundary_id_;
    }

    /// The contact node with this unknown as its first, -1 if there is none.
    Eigen::Index
    node_of(dealii::types::global_dof_index first_dof) const;

    /// The displacement unknowns of the contact nodes, by blocks (x; y; z).
    const Trace &
    trace() const
    {
      return trace_;
    }

    /// B u: (n·u; t1·u; t2·u), length 3m. Collective.
    Eigen::VectorXd
    apply_B(const LA::Vector &u) const;

    /// dst += factor Bᵀ λ. Collective.
    void
    add_transpose_B(double factor,
                    const Eigen::VectorXd &lambda,
                    LA::Vector &dst) const;

    /// From components (x; y; z) to (n; t1; t2) at every node: the orthogonal
    /// matrix R with B = R × restriction.
    Eigen::VectorXd
    to_local(const Eigen::VectorXd &v) const;

    /// Replaces a matrix of order 3m by R C Rᵀ, in one pass: C may be large.
    void
    rotate_to_local(Eigen::MatrixXd &C) const;

    /// The inverse of to_local(), Rᵀ v.
    Eigen::VectorXd
    to_cartesian(const Eigen::VectorXd &v) const;

    /// The slip bound as a function of the contact forces: 0, A_i τ_c(x_i) or
    /// F(x_i) max(λ_ν,i, 0) by the law. Unit: N.
    const qp::SlipBound &
    slip_bound() const
    {
      return slip_bound_;
    }

    /// Whether all normals agree, so that sums over tangential components
    /// have a meaning.
    bool
    is_plane() const;

  private:
    void
    collect_nodes(const LinearElasticity &elasticity);

    void
    evaluate_data(const Parameters &parameters);

    dealii::types::boundary_id boundary_id_;
    FrictionLaw law_;
    std::vector<ContactNode> nodes_;
    Trace trace_;
    Eigen::VectorXd gaps_, areas_;
    qp::SlipBound slip_bound_;
    double boundary_area_ = 0.;

    std::map<dealii::types::global_dof_index, Eigen::Index> node_of_dof_;
  };



  /// The unit tangents that go with a unit normal: t1 the normalised
  /// tangential part of e_x (of e_y if |n_x| > 0.9), t2 = t1 × n.
  void
  set_tangents(ContactNode &node);
} // namespace stiction

#endif
