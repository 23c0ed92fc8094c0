#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/loads.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/model/prescribed_displacement.h>
#include <stiction/elasticity/stiffness/anchors.h>
#include <stiction/elasticity/stiffness/assembled_stiffness.h>
#include <stiction/elasticity/stiffness/constrained_matrix.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Eigen/LU>

#include <algorithm>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the sum of what single loads do: what is left of less is rounding, and a
    // certificate does not see it.
    constexpr double rounding_of_balance = 1e-10;
  } // namespace

  LinearElasticity::LinearElasticity(const Body &body, const BodyParameters &parameters)
    : body_(body)
    , parameters_(parameters)
    , time_(parameters.time)
    , materials_(std::make_unique<Materials>(body, parameters))
    , mesh_(std::make_unique<MeshLevel>(body))
  {
    read_conditions(time_);
    free_motions_ = std::make_unique<FreeMotions>(body, constraints_);
    stiffness_    = std::make_unique<StiffnessOperator<double>>(*mesh_, *materials_);
    assemble_load();
  }

  void LinearElasticity::set_time(const double time)
  {
    if (time == time_)
      return;
    time_ = time;
    read_conditions(time);
    assemble_load();
  }

  void LinearElasticity::read_conditions(const double time)
  {
    prescribed_displacement_ =
      std::make_unique<PrescribedDisplacement>(body_, parameters_, time);
    loads_ = std::make_unique<Loads>(body_, *prescribed_displacement_, parameters_, time);
    constraints_.clear();
    constraints_.reinit(body_.locally_relevant_dofs());
    constraints_.merge(body_.hanging_nodes());
    prescribed_displacement_->add_to(constraints_);
    constraints_.close();
  }

  void LinearElasticity::assemble_load()
  {
    load_ = zero_vector();
    loads_->assemble(*materials_, load_);
    constrain_load();
  }

  LinearElasticity::~LinearElasticity() = default;

  void LinearElasticity::choose_anchors(
    const std::vector<types::global_dof_index> &first_dofs)
  {
    if (free_motions_->n() == 0)
      return;
    anchors_ = stiction::choose_anchors(body_, constraints_, *free_motions_, first_dofs);
    constrain_load();
  }

  bool LinearElasticity::is_fixed(const types::global_dof_index dof) const
  {
    return is_prescribed(dof) ||
           std::find(anchors_.begin(), anchors_.end(), dof) != anchors_.end();
  }

  Eigen::VectorXd LinearElasticity::free_motion_of(const LA::Vector &u) const
  {
    const auto n = free_motions_->n();
    if (n == 0)
      return {};
    Eigen::MatrixXd system(n, n + 1); // the motions at the anchors, and u
    system.setZero();
    for (const Body::Node &node : body_.locally_owned_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        for (Eigen::Index k = 0; k < n; ++k)
          if (anchors_[k] == node.dofs[c])
            {
              system.row(k).head(n) = free_motions_->at(node.position, node.piece).row(c);
              system(k, n)          = u(node.dofs[c]);
            }
    sum_over_ranks(system, body_.communicator());
    return system.leftCols(n).partialPivLu().solve(system.col(n));
  }

  Eigen::VectorXd LinearElasticity::work_along_free_motions(const LA::Vector &force) const
  {
    Eigen::VectorXd work = Eigen::VectorXd::Zero(free_motions_->n());
    if (work.size() == 0)
      return work;
    for (const Body::Node &node : body_.locally_owned_nodes())
      if (!is_hanging(node.dofs[0]))
        work +=
          free_motions_->at(node.position, node.piece).transpose() *
          Eigen::Vector3d(force(node.dofs[0]), force(node.dofs[1]), force(node.dofs[2]));
    sum_over_ranks(work, body_.communicator());
    return work;
  }

  Eigen::VectorXd LinearElasticity::work_of_loads_along_free_motions() const
  {
    Eigen::VectorXd sizes = Eigen::VectorXd::Zero(free_motions_->n());
    for (const Body::Node &node : body_.locally_owned_nodes())
      if (sizes.size() > 0 && !is_hanging(node.dofs[0]))
        for (unsigned int c = 0; c < 3; ++c)
          sizes +=
            free_motions_->at(node.position, node.piece).row(c).transpose().cwiseAbs() *
            std::abs(load_(node.dofs[c]));
    sum_over_ranks(sizes, body_.communicator());
    const Eigen::VectorXd work = work_along_free_motions(load_);
    return (work.array().abs() > rounding_of_balance * sizes.array()).select(work, 0.);
  }

  void LinearElasticity::add_free_motion(const Eigen::VectorXd &amounts,
                                         LA::Vector &u) const
  {
    if (amounts.size() == 0)
      return;
    const std::vector<RigidMotion> motions = free_motions_->motions(amounts);
    for (const Body::Node &node : body_.locally_owned_nodes())
      {
        const Tensor<1, 3> moved = motions[node.piece].at(node.position);
        for (unsigned int c = 0; c < 3; ++c)
          u(node.dofs[c]) += moved[c];
      }
  }

  bool LinearElasticity::is_hanging(const types::global_dof_index dof) const
  {
    return body_.is_hanging(dof);
  }

  void LinearElasticity::prescribe(LA::Vector &u) const
  {
    for (const auto dof : body_.locally_owned_dofs())
      if (is_prescribed(dof))
        u(dof) = prescribed_value(dof);
  }

  void LinearElasticity::distribute(LA::Vector &u) const
  {
    if (body_.n_hanging_nodes() > 0)
      body_.hanging_nodes().distribute(u);
  }

  const LA::SparseMatrix &LinearElasticity::constrained_stiffness() const
  {
    if (constrained_stiffness_)
      return *constrained_stiffness_;
    // with hanging nodes deal.II's diagonal entry of a prescribed unknown is not CᵀKC's
    if (body_.n_hanging_nodes() == 0)
      {
        AffineConstraints<double> constraints(body_.locally_relevant_dofs());
        constraints.merge(constraints_);
        for (const auto dof : anchors_)
          if (body_.locally_relevant_dofs().is_element(dof))
            constraints.add_line(dof);
        constraints.close();
        constrained_stiffness_ = assemble_stiffness(*mesh_, *materials_, constraints);
        return *constrained_stiffness_;
      }
    LA::Vector fixed = zero_vector();
    for (const auto dof : body_.locally_owned_dofs())
      if (is_fixed(dof))
        fixed(dof) = 1.;
    constrained_stiffness_ = ConstrainedMatrix(*assemble(), fixed, {}).release();
    return *constrained_stiffness_;
  }

  LA::Vector LinearElasticity::stiffness_diagonal() const
  {
    LA::Vector diagonal              = zero_vector();
    const std::vector<double> blocks = stiffness_->diagonal_blocks();
    for (std::size_t i = 0; i < blocks.size() / 9; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        diagonal.local_element(3 * i + c) = blocks[9 * i + 4 * c];
    return diagonal;
  }

  LA::Vector LinearElasticity::zero_vector() const
  {
    return mesh_->zero_vector<double>();
  }

  LA::Vector LinearElasticity::internal_force(const LA::Vector &u) const
  {
    LA::Vector force = zero_vector();
    stiffness_->vmult(force, u);
    return force;
  }

  void LinearElasticity::constrain_load()
  {
    LA::Vector prescribed = zero_vector();
    prescribe(prescribed);
    constrained_load_ = load_;
    if (prescribed.linfty_norm() > 0.)
      constrained_load_ -= internal_force(prescribed);

    const LA::Vector diagonal = stiffness_diagonal();
    for (const auto dof : body_.locally_owned_dofs())
      if (is_fixed(dof))
        constrained_load_(dof) = diagonal(dof) * prescribed(dof);
  }

  std::unique_ptr<LA::SparseMatrix> LinearElasticity::assemble() const
  {
    return assemble_stiffness(*mesh_, *materials_, body_.hanging_nodes());
  }
} // namespace stiction
