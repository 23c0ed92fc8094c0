#include <stiction/elasticity/assembled_stiffness.h>
#include <stiction/elasticity/body.h>
#include <stiction/elasticity/boundary_functions.h>
#include <stiction/elasticity/cell_material.h>
#include <stiction/elasticity/element_stiffness.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/mesh_level.h>
#include <stiction/elasticity/rigid_body_modes.h>
#include <stiction/elasticity/stiffness_operator.h>
#include <stiction/elasticity/supported_stiffness.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <stdexcept>

namespace stiction
{
  using namespace dealii;

  struct LinearElasticity::BoundaryData
  {
    BoundaryFunctions displacement;
    BoundaryFunctions traction;
  };



  LinearElasticity::LinearElasticity(const Body &body,
                                     const Parameters &parameters)
    : body_(body)
    , lame_lambda_(parameters.material.youngs_modulus *
                   parameters.material.poisson_ratio /
                   ((1. + parameters.material.poisson_ratio) *
                    (1. - 2. * parameters.material.poisson_ratio)))
    , shear_modulus_(parameters.material.youngs_modulus /
                     (2. * (1. + parameters.material.poisson_ratio)))
  {
    read_boundary_conditions(parameters);
    mesh_ = std::make_unique<MeshLevel>(body);
    make_stiffness();
    assemble_load();
    constrain_load();
    if (parameters.needs_stiffness_matrix())
      constrain_stiffness();
  }



  LinearElasticity::~LinearElasticity() = default;



  bool
  LinearElasticity::is_hanging(const types::global_dof_index dof) const
  {
    return body_.is_hanging(dof);
  }



  void
  LinearElasticity::distribute(LA::Vector &u) const
  {
    if (body_.n_hanging_nodes() > 0)
      body_.hanging_nodes().distribute(u);
  }



  const LA::SparseMatrix &
  LinearElasticity::constrained_stiffness() const
  {
    if (!constrained_stiffness_)
      throw std::logic_error("the stiffness matrix was not assembled");
    return *constrained_stiffness_;
  }



  LA::Vector
  LinearElasticity::stiffness_diagonal() const
  {
    LA::Vector diagonal              = zero_vector();
    const std::vector<double> blocks = stiffness_->diagonal_blocks();
    for (std::size_t i = 0; i < blocks.size() / 9; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        diagonal.local_element(3 * i + c) = blocks[9 * i + 4 * c];
    return diagonal;
  }



  const LA::Vector &
  LinearElasticity::constrained_load() const
  {
    return *constrained_load_;
  }



  const LA::Vector &
  LinearElasticity::load() const
  {
    return *load_;
  }



  LA::Vector
  LinearElasticity::zero_vector() const
  {
    return mesh_->zero_vector<double>();
  }



  LA::Vector
  LinearElasticity::internal_force(const LA::Vector &u) const
  {
    LA::Vector force = zero_vector();
    stiffness_->vmult(force, u);
    return force;
  }



  void
  LinearElasticity::read_boundary_conditions(const Parameters &parameters)
  {
    const std::string displacement_location =
      parameters.source.locate("Boundary conditions/Prescribed displacement");
    const std::string traction_location =
      parameters.source.locate("Boundary conditions/Traction");
    support_location_ = displacement_location;

    boundary_ = std::make_unique<BoundaryData>();
    boundary_->displacement =
      parse_boundary_functions(parameters.boundary.prescribed_displacement,
                               displacement_location,
                               body_.boundary_names(),
                               3,
                               true);
    boundary_->traction = parse_boundary_functions(
      parameters.boundary.traction, traction_location, body_.boundary_names());

    for (const auto &condition : boundary_->traction)
      {
        const auto prescribed = boundary_->displacement.find(condition.first);
        if (prescribed != boundary_->displacement.end() &&
            prescribed->second.components.n_selected_components() == 3)
          throw InputError(traction_location + ": boundary " +
                           body_.boundary_names().describe(condition.first) +
                           " already has a prescribed displacement, a "
                           "traction there is carried by the support alone; "
                           "allowed is one of the two.");
      }

    constraints_.reinit(body_.locally_relevant_dofs());
    constraints_.merge(body_.hanging_nodes());
    together(body_.communicator(), [&]() {
      for (const auto &condition : boundary_->displacement)
        VectorTools::interpolate_boundary_values(body_.mapping(),
                                                 body_.dof_handler(),
                                                 condition.first,
                                                 *condition.second.function,
                                                 constraints_,
                                                 condition.second.components);
    });
    constraints_.close();
  }



  void
  LinearElasticity::assemble_load()
  {
    load_                      = std::make_unique<LA::Vector>(zero_vector());
    const FiniteElement<3> &fe = body_.dof_handler().get_fe();
    const QGauss<2> quadrature(fe.degree + 1);
    FEFaceValues<3> values(body_.mapping(),
                           fe,
                           quadrature,
                           update_values | update_quadrature_points |
                             update_JxW_values);
    std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
    const auto add = [&](const types::global_dof_index dof,
                         const double force) {
      if (!is_hanging(dof))
        (*load_)(dof) += force;
      else
        for (const auto &master :
             *body_.hanging_nodes().get_constraint_entries(dof))
          (*load_)(master.first) += master.second * force;
    };

    together(body_.communicator(), [&]() {
      for (const auto &cell : body_.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() &&
                boundary_->traction.count(face->boundary_id()) != 0)
              {
                const ParsedFunction &traction =
                  *boundary_->traction.at(face->boundary_id()).function;
                values.reinit(cell, face);
                cell->get_dof_indices(indices);
                for (const unsigned int q : values.quadrature_point_indices())
                  for (const unsigned int i : values.dof_indices())
                    add(indices[i],
                        traction.value(values.quadrature_point(q),
                                       fe.system_to_component_index(i).first) *
                          values.shape_value(i, q) * values.JxW(q));
              }
    });
    load_->compress(VectorOperation::add);
  }



  void
  LinearElasticity::constrain_load()
  {
    LA::Vector prescribed = zero_vector();
    bool is_moved         = false;
    for (const auto dof : body_.locally_owned_dofs())
      if (is_prescribed(dof))
        {
          prescribed(dof) = prescribed_value(dof);
          is_moved        = is_moved || prescribed(dof) != 0.;
        }
    constrained_load_ = std::make_unique<LA::Vector>(*load_);
    if (Utilities::MPI::max(is_moved ? 1 : 0, body_.communicator()) == 1)
      *constrained_load_ -= internal_force(prescribed);

    const LA::Vector diagonal = stiffness_diagonal();
    for (const auto dof : body_.locally_owned_dofs())
      if (is_prescribed(dof))
        (*constrained_load_)(dof) = diagonal(dof) * prescribed(dof);
  }



  void
  LinearElasticity::make_stiffness()
  {
    if (body_.is_simple())
      stiffness_ = std::make_unique<StiffnessOperator<double>>(
        *mesh_, lame_lambda_, shear_modulus_);
    else
      stiffness_ = std::make_unique<StiffnessOperator<double>>(
        *mesh_, assemble_stiffness(body_, [&](const auto &) {
          return isotropic_material(lame_lambda_, shear_modulus_);
        }));
  }



  void
  LinearElasticity::constrain_stiffness()
  {
    if (stiffness_->matrix() == nullptr)
      {
        assemble_simple_stiffness();
        return;
      }
    LA::Vector fixed = zero_vector();
    for (const auto dof : body_.locally_owned_dofs())
      if (is_prescribed(dof))
        fixed(dof) = 1.;
    constrained_stiffness_ =
      SupportedStiffness(*stiffness_->matrix(), fixed, {}).release();
  }



  void
  LinearElasticity::assemble_simple_stiffness()
  {
    const DoFHandler<3> &dof_handler = body_.dof_handler();
    const IndexSet &owned            = body_.locally_owned_dofs();
    const IndexSet &relevant         = body_.locally_relevant_dofs();
    const MPI_Comm comm              = body_.communicator();

    DynamicSparsityPattern pattern(relevant);
    DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints_, true);
    SparsityTools::distribute_sparsity_pattern(pattern, owned, comm, relevant);
    constrained_stiffness_ = std::make_unique<LA::SparseMatrix>();
    constrained_stiffness_->reinit(owned, owned, pattern, comm);

    ElementStiffness element_stiffness;
    std::vector<types::global_dof_index> indices(24);
    mesh_->for_each_cell([&](HexahedralCell cell) {
      cell.lame_lambda   = lame_lambda_;
      cell.shear_modulus = shear_modulus_;
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int c = 0; c < 3; ++c)
          indices[3 * v + c] = mesh_->first_dof(cell.nodes[v]) + c;
      constraints_.distribute_local_to_global(
        element_stiffness(cell), indices, *constrained_stiffness_);
    });
    constrained_stiffness_->compress(VectorOperation::add);
  }



  void
  LinearElasticity::require_support() const
  {
    const std::string free_motions =
      free_rigid_body_motions(body_, constraints_);
    if (!free_motions.empty())
      throw InputError(support_location_ + ": the body is not held, free are " +
                       free_motions +
                       "; prescribe the displacement of a boundary other than "
                       "the contact boundary.");
  }
} // namespace stiction
