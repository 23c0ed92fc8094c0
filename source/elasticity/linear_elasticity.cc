#include <stiction/elasticity/body.h>
#include <stiction/elasticity/element_stiffness.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/loads.h>
#include <stiction/elasticity/materials.h>
#include <stiction/elasticity/mesh_level.h>
#include <stiction/elasticity/prescribed_displacement.h>
#include <stiction/elasticity/stiffness_operator.h>
#include <stiction/parameters.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <stdexcept>

namespace stiction
{
  using namespace dealii;

  LinearElasticity::LinearElasticity(const Body &body,
                                     const Parameters &parameters)
    : body_(body)
    , materials_(std::make_unique<Materials>(body, parameters))
    , prescribed_displacement_(
        std::make_unique<PrescribedDisplacement>(body, parameters))
    , mesh_(std::make_unique<MeshLevel>(body))
  {
    const Loads loads(body, *prescribed_displacement_, parameters);
    make_constraints();
    stiffness_ =
      std::make_unique<StiffnessOperator<double>>(*mesh_, *materials_);
    load_ = std::make_unique<LA::Vector>(zero_vector());
    loads.assemble(*materials_, *load_);
    constrain_load();
    if (parameters.needs_stiffness_matrix())
      assemble_stiffness();
  }



  LinearElasticity::~LinearElasticity() = default;



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
  LinearElasticity::make_constraints()
  {
    constraints_.reinit(body_.locally_relevant_dofs());
    DoFTools::make_hanging_node_constraints(body_.dof_handler(), constraints_);
    prescribed_displacement_->add_to(constraints_);
    constraints_.close();
  }



  void
  LinearElasticity::constrain_load()
  {
    LA::Vector prescribed = zero_vector();
    bool is_moved         = false;
    for (const auto dof : body_.locally_owned_dofs())
      if (constraints_.is_constrained(dof))
        {
          prescribed(dof) = constraints_.get_inhomogeneity(dof);
          is_moved        = is_moved || prescribed(dof) != 0.;
        }
    constrained_load_ = std::make_unique<LA::Vector>(*load_);
    if (Utilities::MPI::max(is_moved ? 1 : 0, body_.communicator()) == 1)
      *constrained_load_ -= internal_force(prescribed);

    const LA::Vector diagonal = stiffness_diagonal();
    for (const auto dof : body_.locally_owned_dofs())
      if (constraints_.is_constrained(dof))
        (*constrained_load_)(dof) = diagonal(dof) * prescribed(dof);
  }



  void
  LinearElasticity::assemble_stiffness()
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
      materials_->assign(cell);
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
    prescribed_displacement_->require_support(constraints_);
  }
} // namespace stiction
