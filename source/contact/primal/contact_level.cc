#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>
#include <stiction/contact/primal/contact_level.h>
#include <stiction/contact/primal/contact_state.h>
#include <stiction/contact/primal/primal_active_set.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/levels/dof_subset_hierarchy.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>
#include <stiction/qp/contact_conditions.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/rigid_place.h>
#include <stiction/qp/unbalanced_load.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>

#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The components of a node as bits.
    constexpr unsigned char all_components = 7;

    // Of the foundation: what holds a motion with less hardly resists it, facets do. A
    // taper of half a degree holds with more.
    constexpr double hardly = 5e-5;

    // A smaller coefficient of friction resists as little as none.
    constexpr double no_friction = 0.01;

    // Of the foundation: holds what is loose about as far as bodies are pressed together.
    constexpr double holding_stiffness = 0.1;
  } // namespace

  ContactLevel::ContactLevel(const LinearElasticity &elasticity,
                             const ContactSurface &surface,
                             const BasisTransformation &basis)
    : elasticity_(elasticity)
    , basis_(basis)
    , surface_(&surface)
    , stiffness_(&elasticity.stiffness())
    , load_(mesh().zero_vector<double>())
    , B_(surface.B().dofs(), surface.B().frames())
    , areas_(surface.areas())
    , stiffness_of_cells_(surface.stiffness())
    , boundary_area_(surface.boundary_area())
  {
    for (const auto dof : load_.locally_owned_elements())
      if (elasticity.is_prescribed(dof))
        fixed_.push_back(load_.get_partitioner()->global_to_local(dof));
    for (const Body::Node &node : elasticity.body().locally_owned_nodes())
      pieces_.push_back(node.piece);
    find_inner_nodes();
    find_free_motions();
    update();
  }

  ContactLevel::ContactLevel(const ContactLevel &finer, const BasisTransformation &basis,
                             const LinearElasticity &elasticity,
                             const MeshHierarchy &hierarchy,
                             const DofSubsetHierarchy &dof_hierarchy,
                             const unsigned int level)
    : elasticity_(elasticity)
    , basis_(basis)
    , finer_(&finer)
    , transfer_(&hierarchy.transfer(level + 1))
    , on_finer_(dof_hierarchy.on_finer_level(level))
    , weights_(dof_hierarchy.prolongation(level + 1))
    , own_stiffness_(std::make_unique<StiffnessOperator<double>>(hierarchy.level(level),
                                                                 elasticity.materials()))
    , stiffness_(own_stiffness_.get())
    , load_(mesh().zero_vector<double>())
    , areas_(weights_.transpose() * finer.areas_)
    , boundary_area_(finer.boundary_area_)
  {
    // coarse vertices are fine nodes
    LA::Vector is_fixed = finer.mesh().zero_vector<double>();
    for (const unsigned int k : finer.fixed_)
      is_fixed.local_element(k) = 1.;
    LA::Vector coarse_is_fixed = mesh().zero_vector<double>();
    transfer_->inject(coarse_is_fixed, is_fixed);
    LA::Vector piece        = finer.mesh().zero_vector<double>();
    LA::Vector coarse_piece = mesh().zero_vector<double>();
    for (std::size_t i = 0; i < finer.pieces_.size(); ++i)
      piece.local_element(3 * i) = finer.pieces_[i];
    transfer_->inject(coarse_piece, piece);
    for (unsigned int i = 0; i < mesh().n_owned_nodes(); ++i)
      pieces_.push_back(static_cast<unsigned int>(coarse_piece.local_element(3 * i)));
    for (unsigned int k = 0; k < coarse_is_fixed.locally_owned_size(); ++k)
      if (coarse_is_fixed.local_element(k) != 0.)
        fixed_.push_back(k);

    stiffness_of_cells_ = {finer.stiffness_of_cells_.youngs_moduli(on_finer_),
                           finer.stiffness_of_cells_.softest};
    B_ = ContactOperator(DofSubset::of_nodes(dof_hierarchy.first_dofs(level)),
                         frames_of_finer_level());
    find_inner_nodes();
    find_free_motions();
    update();
  }

  void ContactLevel::update()
  {
    if (surface_ != nullptr)
      take_conditions_of_body();
    else
      take_conditions_of_finer_level();
    load_sum_ = sum_of_norms(load_);
    basis_.forces_to_relative(load_);

    const Eigen::Index n = elasticity_.free_motions().n(), p = motion_.n_pressed();
    balance_ = {Eigen::MatrixXd(3 * n_nodes(), p + n), Eigen::VectorXd(p + n)};
    balance_.G.leftCols(p) = motion_.directions();
    balance_.e.head(p)     = -motion_.forces();
    for (Eigen::Index j = 0; j < n; ++j)
      {
        LA::Vector u = mesh().zero_vector<double>();
        add_free_motion(Eigen::VectorXd::Unit(n, j), u);
        balance_.G.col(p + j) = -B_.apply_to_motion(u);
      }
    balance_.e.tail(n) = -elasticity_.work_of_loads_along_free_motions();
    find_driven_motions();
  }

  void ContactLevel::find_driven_motions()
  {
    driven_ = loose_ = loose_amounts_ = held_loose_ = Eigen::MatrixXd(3 * n_nodes(), 0);
    const Eigen::Index n                            = elasticity_.free_motions().n();
    if (n == 0)
      return;
    const Eigen::MatrixXd motions  = balance_.G.rightCols(n);
    const Eigen::MatrixXd resisted = qp::resisted_and_others(motions, slip_bound_).first;
    driven_                        = motions * resisted;
    if (resisted.cols() == 0)
      return;
    Eigen::VectorXd pressure = Eigen::VectorXd::Zero(3 * n_nodes());
    pressure.head(n_nodes()).setOnes();
    const Eigen::VectorXd &coefficient = slip_bound_.coefficient();
    const auto slippery                = coefficient.array() < no_friction;
    const auto [part, combinations] =
      PrimalActiveSet(
        pressure, Eigen::VectorXd::Zero(3 * n_nodes()), Eigen::VectorXd::Ones(n_nodes()),
        qp::SlipBound::mixed(slip_bound_.constant(), slippery.select(0., coefficient)))
        .resistance(driven_, foundation_);
    loose_amounts_ = resisted * combinations.leftCols((part.array() < hardly).count());
    loose_         = motions * loose_amounts_;
    if (finer_ != nullptr)
      held_loose_ = foundation_.replicate(3, 1).asDiagonal() * loose_;
  }

  void ContactLevel::apply_stiffness(LA::Vector &dst, const LA::Vector &u) const
  {
    basis_.vmult(*stiffness_, dst, u);
    if (held_loose_.cols() > 0)
      B_.add_transpose(holding_stiffness,
                       held_loose_ * (held_loose_.transpose() * B_.apply(u)), dst);
  }

  void ContactLevel::find_free_motions()
  {
    foundation_ = Eigen::VectorXd::Zero(n_nodes());
    if (elasticity_.free_motions().n() == 0)
      return;
    positions_  = mesh().node_positions();
    foundation_ = stiffness_of_cells_.foundation(areas_, elasticity_.body().diameter());
  }

  void ContactLevel::add_free_motion(const Eigen::VectorXd &amounts, LA::Vector &u) const
  {
    const std::vector<RigidMotion> motions = elasticity_.free_motions().motions(amounts);
    basis_.to_absolute(u);
    for (std::size_t i = 0; i < positions_.size(); ++i)
      {
        const Tensor<1, 3> moved = motions[pieces_[i]].at(positions_[i]);
        for (unsigned int c = 0; c < 3; ++c)
          u.local_element(3 * i + c) += moved[c];
      }
    basis_.to_relative(u);
  }

  void ContactLevel::add_loose_motion(const Eigen::Index motion, LA::Vector &u) const
  {
    add_free_motion(loose_amounts_.col(motion), u);
  }

  double ContactLevel::unbalanced_part(const qp::SlipBound &slip_bound) const
  {
    // the same on all ranks, also those that own no node of this level
    return elasticity_.free_motions().n() == 0
             ? 0.
             : qp::unbalanced_load(balance_, slip_bound).part;
  }

  void ContactLevel::take_conditions_of_body()
  {
    load_.copy_locally_owned_data_from(elasticity_.load());
    prescribed_.clear();
    for (const auto dof : load_.locally_owned_elements())
      if (elasticity_.is_prescribed(dof))
        prescribed_.push_back(elasticity_.prescribed_value(dof));
    B_          = ContactOperator(surface_->B().dofs(), surface_->B().frames());
    motion_     = surface_->motion();
    slip_bound_ = surface_->slip_bound();
  }

  std::vector<ContactFrame> ContactLevel::frames_of_finer_level() const
  {
    std::vector<ContactFrame> frames;
    for (const Eigen::Index i : on_finer_)
      frames.push_back(finer_->B_.frames()[i]);
    return frames;
  }

  void ContactLevel::take_conditions_of_finer_level()
  {
    B_ = ContactOperator(B_.dofs(), frames_of_finer_level());

    LA::Vector load = finer_->load_;
    finer_->basis_.forces_to_absolute(load);
    transfer_->restrict_to(load_, load);

    LA::Vector values        = finer_->mesh().zero_vector<double>();
    LA::Vector coarse_values = mesh().zero_vector<double>();
    finer_->set_prescribed_entries(finer_->prescribed_, values);
    transfer_->inject(coarse_values, values);
    prescribed_ = prescribed_entries(coarse_values);

    const auto m                 = static_cast<Eigen::Index>(on_finer_.size());
    const ObstacleMotion &motion = finer_->motion_;
    Eigen::MatrixXd directions(3 * m, motion.n_pressed());
    Eigen::VectorXd offset(3 * m), forces = motion.forces();
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index c = 0; c < 3; ++c)
        {
          const Eigen::Index k      = on_finer_[j] + c * finer_->n_nodes();
          offset(j + c * m)         = motion.offset_at_start()(k);
          directions.row(j + c * m) = motion.directions().row(k);
        }
    for (Eigen::Index j = 0; j < forces.size(); ++j)
      if ((directions.col(j).head(m).array() >= -least_approach).all())
        {
          directions.col(j).setZero();
          forces(j) = 0.;
        }
    motion_ = ObstacleMotion(std::move(offset), std::move(directions), std::move(forces));

    // no force of a tied node passes to those between that are not
    const qp::SlipBound &bound = finer_->slip_bound_;
    Eigen::VectorXd given      = bound.constant();
    for (Eigen::Index i = 0; i < given.size(); ++i)
      given(i) = bound.is_given(i) ? given(i) : 0.;
    Eigen::VectorXd constant = weights_.transpose() * given;
    for (Eigen::Index j = 0; j < m; ++j)
      if (bound.is_tied(on_finer_[j]))
        constant(j) = qp::tied;
    slip_bound_ = bound.is_coulomb()
                    ? qp::SlipBound::mixed(constant, bound.coefficient()(on_finer_))
                    : qp::SlipBound::given(constant);
  }

  ContactLevel::~ContactLevel() = default;

  const MeshLevel &ContactLevel::mesh() const { return stiffness_->level(); }

  void ContactLevel::find_inner_nodes()
  {
    free_components_.assign(mesh().n_owned_nodes(), all_components);
    for (const unsigned int k : fixed_)
      free_components_[k / 3] &= static_cast<unsigned char>(~(1u << k % 3));
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      if (load_.in_local_range(B_.dofs().dofs()[i]))
        free_components_[mesh().local_node(B_.dofs().dofs()[i])] = 0;
  }

  void ContactLevel::clear_prescribed(LA::Vector &v) const
  {
    for (const unsigned int k : fixed_)
      v.local_element(k) = 0.;
  }

  std::vector<double> ContactLevel::prescribed_entries(const LA::Vector &v) const
  {
    std::vector<double> entries;
    entries.reserve(fixed_.size());
    for (const unsigned int k : fixed_)
      entries.push_back(v.local_element(k));
    return entries;
  }

  void ContactLevel::set_prescribed_entries(const std::vector<double> &entries,
                                            LA::Vector &v) const
  {
    for (std::size_t k = 0; k < fixed_.size(); ++k)
      v.local_element(fixed_[k]) = entries[k];
  }

  void ContactLevel::add_prescribed_entries(const double factor,
                                            const std::vector<double> &entries,
                                            LA::Vector &v) const
  {
    for (std::size_t k = 0; k < fixed_.size(); ++k)
      v.local_element(fixed_[k]) += factor * entries[k];
  }

  Eigen::VectorXd ContactLevel::nodal_stiffness() const
  {
    Eigen::VectorXd stiffness =
      stiffness_of_cells_.youngs_moduli.cwiseProduct(areas_.cwiseSqrt());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      stiffness(i) /=
        (B_.frames()[i].own_part * B_.frames()[i].scales()).cwiseAbs2().maxCoeff();
    return stiffness;
  }

  Eigen::VectorXd ContactLevel::penetration_and_slip(
    const LA::Vector &u, const Eigen::VectorXd &distances) const
  {
    return B_.apply(u) - motion_.offset(distances);
  }

  void ContactLevel::bring_into_contact(ContactState &state, const Eigen::VectorXd &a,
                                        const double part) const
  {
    if (balance_.e.size() == 0 || n_nodes() == 0)
      return;
    const Eigen::VectorXd pressed = (a.array() > 0.).select(areas_, 0.);
    // ties hold bodies that touch nothing
    if (elasticity_.free_motions().n() > 0 && !slip_bound_.has_tied())
      {
        if (pressed.sum() > part * areas_.sum())
          return;
        const Eigen::VectorXd ways =
          qp::rigid_place(balance_, -state.w, nodal_stiffness(), slip_bound_).alpha;
        state.distances += ways.head(motion_.n_pressed());
        add_free_motion(ways.tail(elasticity_.free_motions().n()), state.u);
        state.w = penetration_and_slip(state.u, state.distances);
        return;
      }
    const Eigen::VectorXd ways =
      ways_to_press(motion_, -state.w.head(n_nodes()), areas_,
                    stiffness_of_cells_.youngs_moduli.maxCoeff());
    for (Eigen::Index j = 0; j < ways.size(); ++j)
      {
        const auto faces =
          motion_.directions().col(j).head(n_nodes()).array() < -least_approach;
        if (faces.select(pressed, 0.).sum() <= part * faces.select(areas_, 0.).sum())
          state.distances(j) += ways(j);
      }
    state.w = penetration_and_slip(state.u, state.distances);
  }

  double ContactLevel::regularization(const LinearElasticity &elasticity)
  {
    return elasticity.materials().are_nearly_incompressible() ? 1e-2 : 1e-4;
  }

  NodalConstraint ContactLevel::support(const Eigen::Index node, const bool has_factors,
                                        const Eigen::Matrix3d &projection,
                                        const Eigen::Matrix3d &spring) const
  {
    const ContactFrame &frame     = B_.frames()[node];
    const Eigen::Matrix3d R       = frame.axes();
    const Eigen::Vector3d is_free = (frame.scales().array() > 0.).matrix().cast<double>();
    const Eigen::Matrix3d M       = frame.own_part * frame.scales().asDiagonal() * R;

    const double part =
      has_factors ? regularization_of_factors : regularization(elasticity_);

    // RᵀIR differs from I by rounding, and what is not I counts as held
    const Eigen::Matrix3d on_frame = projection * is_free.asDiagonal();
    NodalConstraint support;
    if (!on_frame.isIdentity(0.))
      support.projection = R.transpose() * on_frame * R;
    support.spring =
      M.transpose() * spring * M + part * foundation_(node) * Eigen::Matrix3d::Identity();
    return support;
  }
} // namespace stiction
