#pragma once

#include <stiction/contact/interface/contact_operator.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/obstacles/obstacle_motion.h>
#include <stiction/contact/pairs/smooth_parts.h>
#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/qp/contact_scales.h>
#include <stiction/qp/sets/slip_bound.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace stiction
{
  class ContactBoundary;
  struct ContactParameters;
  class LinearElasticity;
  struct Mortar;
  class ParameterFile;

  /// One node of a contact boundary that may touch its obstacle.
  ///
  /// Of an ellipse of friction, the coefficient and the slip stress are those
  /// of the disc it becomes in contact variables: along t1, or along the one
  /// free direction.
  struct ContactNode : ContactFrame
  {
    /// Of its three displacement unknowns.
    dealii::types::global_dof_index first_dof = 0;
    dealii::Point<3> position; ///< undeformed, m
    dealii::Point<3> center;   ///< of the places that its force acts at, m
    double gap = 0.;           ///< d along n, m; negative: interference
    /// u − U, by how much the node has moved from its place relative to that of the
    /// obstacle, where gap and normal are taken, m: r_ν = d − n·(u − U) is the distance
    /// there.
    dealii::Tensor<1, 3> moved;
    double gap_at_start = 0.;          ///< d where nothing has moved, m
    dealii::Tensor<1, 3> way_at_start; ///< d n there
    /// How far the surface of an obstacle that turns moves past it a radian, m, and has
    /// moved since the end of the last step: the point that it faces. The torque of a
    /// force is arm·F.
    dealii::Tensor<1, 3> arm, turning;
    /// A = ∫ φ over the contact boundary, m²; φ has what the shape functions of
    /// hanging nodes add to it, A what nodes beside it lend,
    /// ContactSurface::lend_areas().
    double area = 0.;
    /// Of a pair: of what is around it, how much has something opposite. With less than
    /// half a node is beyond the edge of what lies opposite, or next to a corner of it.
    double cover    = 1.;
    double mesh_gap = 0.; ///< of a pair, between the meshes along the normal, m
    double facets   = 0.; ///< of a pair, see Mortar::facets, m
    /// Of a pair, at the rim of a part, unit, out of the other side; elsewhere zero.
    dealii::Tensor<1, 3> opposite_normal;
    /// The largest of the cells behind it, Pa; of a pair that of the softer body.
    double youngs_modulus = 0.;
    double coefficient    = 0.; ///< F of Coulomb's law
    double slip_stress    = 0.; ///< τ_c of given friction, Pa
    unsigned int boundary = 0;  ///< whose node it is, of boundaries()
    unsigned int part     = 0;  ///< of this boundary, see SmoothParts
  };

  /// The contact nodes with their frames, gaps, areas and friction data, and
  /// the operator B to them: B = (N; T1; T2), with the scales of ContactFrame
  /// for ellipses of friction and directions in which a node is held.
  ///
  /// The list is known to all ranks, in an order that does not depend on
  /// their number. Vectors over it are stored by blocks (normal; first
  /// tangent; second tangent), each of length m = n_nodes(). Nodes of a
  /// contact boundary whose displacement is prescribed, wholly or along the
  /// normal, are not contact nodes, nor are those that face away from the
  /// obstacle, nor hanging nodes, which follow from others. A node of several
  /// contact boundaries, or on a sharp edge of one, is one of the first of them, and of
  /// the part with the smallest gap; nodes of the others beside it bear what acts on it
  /// there.
  ///
  /// The contact force is one number a node and direction, whatever the degree
  /// of the elements: λ_i works on the displacement of node i alone, so that
  /// λ_i/A_i is a traction and Σ A_i the area.
  class ContactSurface
  {
  public:
    /// Collects the contact nodes, at the time of the loads. Collective.
    ///
    /// Throws InputError if a contact boundary does not exist, is prescribed
    /// itself, has no node that can touch its obstacle, or if what is said of
    /// it (obstacle, gap, displacement, rotation, force, coefficient, slip stress) cannot
    /// be read or has a value that is not allowed.
    ///
    /// @param history from which slip is counted; empty: from where obstacles come to
    ///   touch the body as it is made.
    /// @param there where the body and pressed obstacles are about which gaps of
    ///   boundaries that slide far are linearised; none: where they are made.
    /// @param before of the same mesh, at any time: what lies opposite to pairs, which
    ///   takes long to find, is taken from it.
    ContactSurface(const LinearElasticity &elasticity,
                   const ContactParameters &parameters, const SlipHistory &history = {},
                   const State *there = nullptr, const ContactSurface *before = nullptr);

    ContactSurface(ContactSurface &&) noexcept;
    ContactSurface &operator=(ContactSurface &&) noexcept;
    ~ContactSurface();

    Eigen::Index n_nodes() const { return static_cast<Eigen::Index>(nodes_.size()); }

    const std::vector<ContactNode> &nodes() const { return nodes_; }

    /// Of each contact node the first of its three unknowns.
    std::vector<dealii::types::global_dof_index> first_dofs() const
    {
      const auto &dofs = B_.dofs().dofs();
      return {dofs.begin(), dofs.begin() + n_nodes()};
    }

    /// The contact boundaries, in the order of the parameter file.
    const std::vector<ContactBoundary> &boundaries() const { return boundaries_; }

    /// By how much their obstacles have turned, radians.
    std::vector<double> angles() const;

    /// ... and that which a node faces has since the end of the last step.
    double turned(const ContactNode &node) const;

    /// Initial gaps d_i in m, length m, with the obstacles where the parameter file
    /// places them.
    Eigen::VectorXd gaps() const { return motion_.offset_at_start().head(n_nodes()); }

    /// What the displacements of the obstacles are to the contact nodes. Those that
    /// a force presses on are in the order of their boundaries.
    const ObstacleMotion &motion() const { return motion_; }

    /// From where the slip of the next step is counted: relative_displacement(), and of
    /// an obstacle that bears nothing the shortest way on which it comes to touch. That
    /// is no slip, though nodes beside the first that is touched see it along themselves
    /// where surfaces are curved. Collective.
    Eigen::VectorXd slip_origin(const State &state) const;

    /// Whether friction depends on pressure or slip, so that set_friction() has to
    /// follow the state.
    bool has_friction_of_state() const;

    /// How the slip bound stands for friction that depends on the state.
    enum class FrictionForm
    {
      value,  ///< by the coefficients and slip stresses at the state
      tangent ///< and by how F λ_ν changes with λ_ν there, where that gives a bound
    };

    /// Makes the slip bound that of friction at these contact forces, empty: at none,
    /// and on these ways slipped, m. Either form gives the same bound at the forces.
    ///
    /// Throws InputError for values that are not allowed.
    void set_friction(const Eigen::VectorXd &lambda, const Eigen::VectorXd &path,
                      FrictionForm form);

    /// U of the contact nodes, how far the obstacles are from where their entries place
    /// them, but for what they turned, with pressed ones at distances δ; length 3m by
    /// Cartesian components, m.
    Eigen::VectorXd obstacle_displacements(const Eigen::VectorXd &distances) const;

    /// r: gaps d − n·u and slips since the end of the last step, in contact variables, m.
    /// Collective.
    Eigen::VectorXd gap_and_slip(const State &state) const;

    /// Adds to the contact forces friction at dragged nodes, those that supports hold in
    /// both tangential directions opposite to an obstacle: as large as the law allows and
    /// against the slip; without slip what it was, up to that. The supports bear it and
    /// nothing else moves, so that solvers know nothing of it. Collective.
    ///
    /// @param before the contact forces at the end of the last step; none if of another
    ///   length.
    void add_friction_on_supports(State &state, const Eigen::VectorXd &before) const;

    /// Contact variables, if they are known, without what dragged nodes have in
    /// tangential directions.
    Eigen::VectorXd without_dragged(Eigen::VectorXd variables) const;

    /// Contact forces on obstacles and masters' side, by blocks (x; y; z), N.
    Eigen::VectorXd forces(const Eigen::VectorXd &lambda) const;

    /// dst += factor Bᵀ λ, with what acts in held directions. Collective.
    void add_forces(double factor, const Eigen::VectorXd &lambda, LA::Vector &dst) const;

    /// U − u of the contact nodes since slip is counted, with what obstacles turned
    /// since, length 3m by Cartesian components, m. Collective.
    Eigen::VectorXd slip_since_origin(const State &state) const;

    /// U − u of the contact nodes, see SlipHistory. Collective.
    Eigen::VectorXd relative_displacement(const State &state) const;

    /// From the contact nodes to what they face where nothing has moved, length 3m by
    /// Cartesian components, m.
    Eigen::VectorXd ways_at_start() const;

    /// What obstacles do to come to touch the body where nothing has moved, by the
    /// shortest way, length 3m, m; see slip_origin().
    Eigen::VectorXd approach_at_start() const;

    /// How far the obstacle of a contact boundary is from where its own entry
    /// places it, m, with pressed obstacles at distances δ.
    dealii::Tensor<1, 3> obstacle_displacement(dealii::types::boundary_id id,
                                               const Eigen::VectorXd &distances) const;

    /// Whether pressed obstacles at these distances are deeper in the body than it
    /// is large.
    bool are_obstacles_too_deep(const Eigen::VectorXd &distances) const;

    /// Nodal areas A_i in m², length m.
    const Eigen::VectorXd &areas() const { return areas_; }

    /// |Γc|: the area of all contact boundaries, clamped rims included.
    double boundary_area() const { return boundary_area_; }

    /// Of the cells behind the contact nodes, and of the softest ones.
    const ContactStiffness &stiffness() const { return stiffness_; }

    /// The ids of the contact boundaries.
    std::set<dealii::types::boundary_id> boundary_ids() const;

    /// The contact boundary with this id; there must be one.
    const ContactBoundary &boundary(dealii::types::boundary_id id) const;

    const ContactBoundary &boundary_of(const ContactNode &node) const;

    /// Whether a boundary of the mesh is a contact boundary, not so for masters of pairs.
    bool is_contact_boundary(dealii::types::boundary_id id) const;

    /// Whether there is something rigid to touch: not all are contact pairs.
    bool has_obstacles() const;

    /// Whether gaps and normals of some boundary are those at the answer.
    bool slides_far() const;

    /// Whether a boundary of the mesh is the master of a contact pair.
    bool is_other_side(dealii::types::boundary_id id) const;

    /// The place among the nodes opposite of that with this first unknown, -1 if it is
    /// none.
    Eigen::Index opposite_node_of(dealii::types::global_dof_index first_dof) const;

    /// Takes what contact nodes have to the nodes opposite, as the mean of those that
    /// they face: rows have no sign and sum to 1, or to 0 where there is nothing.
    /// Tractions on the one side become minus those on the other.
    const Eigen::SparseMatrix<double, Eigen::RowMajor> &to_other_side() const
    {
      return to_other_side_;
    }

    /// Whether the forces of a pair that is not tied are on a side that wavers, see
    /// SlaveSide.
    bool has_wavering_side() const;

    /// Nodes left out because they face away from the obstacle.
    std::size_t n_facing_away() const { return facing_away_.size(); }

    /// How far the displacement brings a node that faces away from the obstacle
    /// into it, m, which nothing prevents. Collective.
    double penetration_of_facing_away(const State &state) const;

    /// How far nodes of each contact boundary on which none of its forces act, since they
    /// are prescribed across it or belong to an earlier boundary, are beyond what lies
    /// opposite, m. Collective.
    std::vector<double> penetration_of_idle(const State &state) const;

    /// The parts of the contact boundaries between sharp edges; of tied ones, in which
    /// normals do not count, none.
    const SmoothParts &parts() const { return parts_; }

    /// The contact nodes that bear the forces of a part of a contact boundary at a node,
    /// with their parts of its area, which add to 1: the node itself, or those beside it,
    /// see lend_areas(); or none.
    std::vector<std::pair<Eigen::Index, double>> bearers_at(
      dealii::types::global_dof_index first_dof, dealii::types::boundary_id id,
      unsigned int part) const;

    /// The contact node with this unknown as its first, -1 if there is none.
    Eigen::Index node_of(dealii::types::global_dof_index first_dof) const;

    /// From displacements to those of the contact nodes, and forces back; as solvers see
    /// them, with nothing in directions that are held.
    const ContactOperator &B() const { return B_; }

    /// The slip bound as a function of the contact forces: 0, A_i τ_c(x_i) or
    /// F(x_i) max(λ_ν,i, 0) by the law of the node's boundary; where friction depends
    /// on the state, that of the last set_friction(). Unit: N.
    const qp::SlipBound &slip_bound() const { return slip_bound_; }

    /// The largest coefficient of Coulomb friction, in any direction.
    double largest_coefficient() const;

  private:
    /// Chooses the sides of pairs, finds what lies opposite to the slaves, and the parts
    /// of the boundaries.
    /// Throws InputError if one would be the slave of two, and if a tie would be lost or
    /// its sides are far apart.
    void join_pairs(const LinearElasticity &elasticity);

    /// The same, as it was done before.
    void join_pairs_as(const ContactSurface &before);

    void collect_nodes(const LinearElasticity &elasticity);

    /// Gives nodes the places relative to their obstacles about which gaps are
    /// linearised. Collective.
    void move_nodes(const State *there);

    /// Throws InputError with the reason, of a pair with more of it, unless every
    /// boundary has nodes.
    void require_nodes(const std::string &entry, const std::string &reason,
                       const std::string &of_pair = "") const;

    /// Normals and gaps, and out with the nodes that face away.
    void place_obstacles();

    void evaluate_data();

    /// Takes the slip of the steps before off the tangential offsets.
    void count_slip_from(Eigen::VectorXd origin);

    /// Finds what lies opposite to a node. @return whether something does.
    bool place(ContactNode &node) const;
    /// Takes area and gap of a node of a pair from its mortar.
    /// @return whether enough has something opposite; of degree 2 areas may be negative.
    bool place_in_pair(ContactNode &node) const;
    /// Makes lenders of nodes of degree 2 with hardly anything opposite, where integrals
    /// of shape functions, which change signs, nearly vanish or are negative. Collective.
    void lend_slivers(const LinearElasticity &elasticity);
    /// Has nodes bear forces for slivers beside them and for nodes of an earlier
    /// boundary: gives them a part of their areas, and the means of gaps, arms and
    /// places. Of the latter those without such a neighbour become idle. Collective.
    void lend_areas(const LinearElasticity &elasticity);
    /// What lies opposite, where nodes bear forces for others as well. Collective.
    ContactOperator::OtherSide with_loans(
      const LinearElasticity &elasticity, const ContactOperator::OtherSide &opposite,
      const ContactOperator::OtherSide &of_lenders) const;
    /// Gives the nodes that are left their numbers and makes B.
    void number_nodes(const LinearElasticity &elasticity);
    /// B of some nodes, with what lies opposite to them.
    ContactOperator contact_operator(const LinearElasticity &elasticity,
                                     const std::vector<ContactNode> &nodes) const;
    /// @param own the unknowns of the nodes.
    ContactOperator::OtherSide other_side(const LinearElasticity &elasticity,
                                          const DofSubset &own,
                                          const std::vector<ContactNode> &nodes) const;
    void find_weights_of_other_side();

    /// The ways on which obstacles come to touch, by blocks (x; y; z): those of their
    /// nearest nodes, nothing where a gap is closed or a force positive.
    ///
    /// @param gaps length m. @param ways to the obstacles, 3m. @param lambda or empty.
    Eigen::VectorXd approaches(const Eigen::VectorXd &gaps, const Eigen::VectorXd &ways,
                               const Eigen::VectorXd &lambda) const;

    /// Gives dragged nodes the scales of free ones, after B was made.
    void find_dragged_nodes();

    /// Throws InputError if a force presses no node.
    void displace_obstacles();

    std::vector<ContactBoundary> boundaries_;
    std::vector<double> angles_before_; ///< of the obstacles
    /// Of the parts of each, none of those with obstacles.
    std::vector<std::vector<Mortar>> mortars_;
    SmoothParts parts_;
    std::vector<ContactNode> nodes_, facing_away_;
    std::vector<ContactNode> idle_;    ///< of a boundary whose forces do not act on them
    ContactOperator idle_B_;           ///< of these
    std::vector<ContactNode> lenders_; ///< nodes for which others bear, see lend_areas()
    /// Of the area of node i, the part that lender j had.
    Eigen::SparseMatrix<double, Eigen::RowMajor> loans_;
    /// By the first unknown of a lender, the place of its boundary and the part of that.
    std::map<std::tuple<dealii::types::global_dof_index, std::size_t, unsigned int>,
             std::vector<std::pair<Eigen::Index, double>>>
      bearers_;
    std::vector<Eigen::Index> dragged_;
    Eigen::VectorXd origin_; ///< of count_slip_from(), empty: none
    DofSubset facing_away_dofs_;
    ContactOperator B_;
    Eigen::VectorXd areas_;
    ObstacleMotion motion_;
    qp::SlipBound slip_bound_;
    double boundary_area_ = 0.;
    ContactStiffness stiffness_;

    std::map<dealii::types::global_dof_index, Eigen::Index> node_of_dof_,
      opposite_node_of_dof_;
    Eigen::SparseMatrix<double, Eigen::RowMajor> to_other_side_;
  };

} // namespace stiction
