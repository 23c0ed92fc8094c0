#pragma once

#include <stiction/contact/interface/contact_operator.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/obstacles/obstacle_motion.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>
#include <stiction/qp/contact_scales.h>
#include <stiction/qp/operators/equality_constraint.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>

#include <deal.II/base/point.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace stiction
{
  class ContactSurface;
  struct ContactState;
  class LevelTransfer;
  class LinearElasticity;
  class MeshHierarchy;
  class MeshLevel;
  class DofSubsetHierarchy;
  template<typename Number> class StiffnessOperator;

  /// The contact problem on one level of the mesh, in displacements: K without
  /// a matrix, loads, contact nodes with their frames and data.
  ///
  /// Displacements are those of a basis in which contact nodes count from what lies
  /// opposite, u = T û: in it a pair of bodies is a body with an obstacle. K is TᵀKT, the
  /// load Tᵀf, and B acts on contact nodes alone.
  ///
  /// On a coarser level it is the problem in the subspace of that level: loads,
  /// areas and given slip bounds are restricted, obstacles, frames and
  /// coefficients taken at the vertices. Vectors over the contact nodes are
  /// replicated, by blocks (ν; t1; t2).
  class ContactLevel
  {
  public:
    /// The problem itself. All arguments must outlive the object. Collective.
    ContactLevel(const LinearElasticity &elasticity, const ContactSurface &surface,
                 const BasisTransformation &basis);

    /// The problem on level @p level, @p finer being the one on the next finer
    /// level. Collective.
    ContactLevel(const ContactLevel &finer, const BasisTransformation &basis,
                 const LinearElasticity &elasticity, const MeshHierarchy &hierarchy,
                 const DofSubsetHierarchy &dof_hierarchy, unsigned int level);
    ~ContactLevel();

    /// Takes loads, supports, gaps, frames and friction afresh from the arguments of the
    /// constructor, or from the finer level. Collective.
    void update();

    Eigen::Index n_nodes() const { return areas_.size(); }

    const MeshLevel &mesh() const;

    const BasisTransformation &basis() const { return basis_; }

    /// dst = K u. On a coarser level springs from the undeformed place, a tenth of the
    /// foundation, act along loose_motions(): its facets would drive the body far, and
    /// elsewhere than those of the mesh itself. Collective.
    void apply_stiffness(LA::Vector &dst, const LA::Vector &u) const;

    const LA::Vector &load() const { return load_; }

    /// Σ‖f_j‖ over the nodes, N.
    double load_sum() const { return load_sum_; }

    const qp::SlipBound &slip_bound() const { return slip_bound_; }

    const Eigen::VectorXd &areas() const { return areas_; }

    /// E_i√A_i: about the mean diagonal entry of K at a contact node, N/m; less
    /// where a scale of the frame makes it seem more compliant.
    Eigen::VectorXd nodal_stiffness() const;

    /// Gives u its prescribed values, and v zeros in their places.
    void prescribe(LA::Vector &u) const { set_prescribed_entries(prescribed_, u); }
    void clear_prescribed(LA::Vector &v) const;

    /// The entries of v at the prescribed unknowns this rank owns, and the way
    /// back.
    std::vector<double> prescribed_entries(const LA::Vector &v) const;
    void set_prescribed_entries(const std::vector<double> &entries, LA::Vector &v) const;
    void add_prescribed_entries(double factor, const std::vector<double> &entries,
                                LA::Vector &v) const;

    /// The obstacles, as the nodes of this level see them. One that is pressed on
    /// but meets no node of it has neither direction nor force.
    const ObstacleMotion &motion() const { return motion_; }

    /// From displacements to those of the contact nodes, and forces back.
    const ContactOperator &B() const { return B_; }

    /// w = Bu − e with the obstacles at distances δ. Collective.
    Eigen::VectorXd penetration_and_slip(const LA::Vector &u,
                                         const Eigen::VectorXd &distances) const;

    /// The part of the loads that no contact forces within a slip bound balance, zero if
    /// some do: a patch of contact may be a single node of a coarse level.
    double unbalanced_part(const qp::SlipBound &slip_bound) const;

    /// Moves pressed obstacles onto the body, see ways_to_press(), or bodies that contact
    /// alone holds, see qp::rigid_place(), where next to nothing of them meets.
    ///
    /// @param a the normal part of λ + ρw: above zero at nodes that meet.
    /// @param part of the area that faces an obstacle, or of all: no more than that is
    ///   next to nothing.
    void bring_into_contact(ContactState &state, const Eigen::VectorXd &a,
                            double part) const;

    /// ContactStiffness::foundation() of a body that contact alone holds: it makes
    /// singular systems regular, in a step (PrimalActiveSet::tether()) or, this part of
    /// it, in the preconditioner. Zero where supports hold the body.
    const Eigen::VectorXd &foundation() const { return foundation_; }

    /// A body may be softer against bending than against shortening by its
    /// slenderness to the third power, and springs that are stiffer than the body
    /// are no approximation of it; softer ones leave more to iterations, but not to a
    /// factorisation. Where rubber moves far, the rounding of a preconditioner in single
    /// precision changes its volume, which resists by hundreds of times more.
    static double regularization(const LinearElasticity &elasticity);
    static constexpr double regularization_of_factors = 1e-8;

    /// How the contact nodes move under the motions of the body that can be driven,
    /// 3m × any: all free ones but those that nothing ever resists.
    const Eigen::MatrixXd &driven_motions() const { return driven_; }

    /// Of these the ones that hardly anything resists even where all nodes are pressed
    /// and stick as they can, 3m × any: a ball turns so in a cup without friction.
    const Eigen::MatrixXd &loose_motions() const { return loose_; }

    /// u += one of these.
    void add_loose_motion(Eigen::Index motion, LA::Vector &u) const;

    /// A support given in contact variables, with the regularization of a preconditioner,
    /// or that of one with factors: @p projection a diagonal one that treats both
    /// tangents alike, @p spring of forces y for displacements w.
    NodalConstraint support(
      Eigen::Index node, bool has_factors = false,
      const Eigen::Matrix3d &projection = Eigen::Matrix3d::Identity(),
      const Eigen::Matrix3d &spring     = Eigen::Matrix3d::Zero()) const;

    /// The scales of the certificate for a displacement u with R = f − Ku and
    /// λ = BR.
    struct Scales
    {
      double force = 1.;   ///< S, N
      qp::Scaling scaling; ///< of the contact figures
    };
    Scales scales(const LA::Vector &u, const LA::Vector &R,
                  const Eigen::VectorXd &lambda) const;

    /// Those of earlier steps, from which on the forces and energies of scales() count.
    void set_earlier_scales(const State::Scales &scales) { earlier_scales_ = scales; }

    /// Σ ε‖diag(K_jj) u_j‖ over all nodes, ε = 2⁻⁵³: what rounding u alone
    /// changes the forces inside the body by, N. Collective.
    double rounding_of_forces(const LA::Vector &u) const;

    /// Whether at each node the forces are no more than what rounding displacements of
    /// the size of u changes them by. Collective.
    bool is_rounding(const LA::Vector &forces, const LA::Vector &u) const;

    /// Σ‖v_j‖ over the nodes but contact nodes, of components that are not
    /// prescribed. Collective.
    double sum_of_norms_inside(const LA::Vector &v) const;

  private:
    void find_inner_nodes();
    void find_free_motions();
    /// Also the loose ones among them.
    void find_driven_motions();
    /// u += Zα on this level.
    void add_free_motion(const Eigen::VectorXd &amounts, LA::Vector &u) const;
    void take_conditions_of_body();
    void take_conditions_of_finer_level();
    std::vector<ContactFrame> frames_of_finer_level() const;
    /// Σ‖v_j‖ over the owned nodes of all ranks, of the components whose bits are set;
    /// without such a list of all. Collective.
    static double sum_of_norms(const LA::Vector &v,
                               const std::vector<unsigned char> &components = {});

    const LinearElasticity &elasticity_;
    const BasisTransformation &basis_;
    const ContactSurface *const surface_ = nullptr; ///< of the problem itself
    const ContactLevel *const finer_     = nullptr; ///< of the others
    const LevelTransfer *const transfer_ = nullptr; ///< to it
    std::vector<Eigen::Index> on_finer_;            ///< where the contact nodes are there
    Eigen::SparseMatrix<double> weights_; ///< interpolation of the contact nodes

    std::unique_ptr<StiffnessOperator<double>> own_stiffness_;
    const StiffnessOperator<double> *stiffness_; ///< in the absolute basis
    LA::Vector load_;
    double load_sum_ = 0.; ///< Σ‖f_j‖
    State::Scales earlier_scales_;

    std::vector<unsigned int> fixed_; ///< local unknowns
    std::vector<double> prescribed_;
    /// The components that are not prescribed, as bits, of each owned node that
    /// is no contact node; 0 for those.
    std::vector<unsigned char> free_components_;

    ContactOperator B_;
    Eigen::VectorXd areas_;
    ObstacleMotion motion_;
    ContactStiffness stiffness_of_cells_;
    double boundary_area_ = 0.;
    qp::SlipBound slip_bound_;

    std::vector<unsigned int> pieces_;        ///< of the owned nodes
    std::vector<dealii::Point<3>> positions_; ///< of them, if a body has free motions
    EqualityConstraint balance_;              ///< see rigid_balance()
    Eigen::VectorXd foundation_;
    Eigen::MatrixXd driven_;
    Eigen::MatrixXd loose_, loose_amounts_; ///< of contact nodes, of free motions
    Eigen::MatrixXd held_loose_; ///< of a coarser level: the loose ones in the foundation
  };
} // namespace stiction
