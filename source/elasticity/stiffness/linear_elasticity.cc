#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/boundary_parameters.h>
#include <stiction/elasticity/model/loads.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/model/prescribed_displacement.h>
#include <stiction/elasticity/stiffness/assembled_stiffness.h>
#include <stiction/elasticity/stiffness/constrained_matrix.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace stiction
{
  using namespace dealii;

  LinearElasticity::LinearElasticity(const Body &body, const BodyParameters &parameters)
    : body_(body)
    , parameters_(parameters)
    , time_(parameters.time)
    , materials_(std::make_unique<Materials>(body, parameters))
    , mesh_(std::make_unique<MeshLevel>(body))
  {
    read_conditions(time_);
    make_stiffness();
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
    make_constraints();
  }

  void LinearElasticity::assemble_load()
  {
    load_ = zero_vector();
    loads_->assemble(*materials_, load_);
    constrain_load();
  }

  LinearElasticity::~LinearElasticity() = default;

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
    if (stiffness_->matrix() == nullptr && body_.n_hanging_nodes() == 0)
      {
        constrained_stiffness_ = assemble_stiffness(*mesh_, *materials_, constraints_);
        return *constrained_stiffness_;
      }
    LA::Vector fixed = zero_vector();
    for (const auto dof : body_.locally_owned_dofs())
      if (is_prescribed(dof))
        fixed(dof) = 1.;
    const auto own = stiffness_->matrix() == nullptr ? assemble() : nullptr;
    constrained_stiffness_ =
      ConstrainedMatrix(own ? *own : *stiffness_->matrix(), fixed, {}).release();
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

  void LinearElasticity::make_constraints()
  {
    constraints_.clear();
    constraints_.reinit(body_.locally_relevant_dofs());
    constraints_.merge(body_.hanging_nodes());
    prescribed_displacement_->add_to(constraints_);
    constraints_.close();
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
      if (is_prescribed(dof))
        constrained_load_(dof) = diagonal(dof) * prescribed(dof);
  }

  void LinearElasticity::make_stiffness()
  {
    if (mesh_->is_trilinear() || body_.has_levels())
      stiffness_ = std::make_unique<StiffnessOperator<double>>(*mesh_, *materials_);
    else
      stiffness_ = std::make_unique<StiffnessOperator<double>>(*mesh_, assemble());
  }

  std::unique_ptr<LA::SparseMatrix> LinearElasticity::assemble() const
  {
    return assemble_stiffness(*mesh_, *materials_, body_.hanging_nodes());
  }

  void LinearElasticity::require_support() const
  {
    prescribed_displacement_->require_support(constraints_);
  }
} // namespace stiction
