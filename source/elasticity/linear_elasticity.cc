#include <stiction/elasticity/body.h>
#include <stiction/elasticity/boundary_functions.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/rigid_body_modes.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/numerics/vector_tools_boundary.h>

namespace stiction
{
  using namespace dealii;

  struct LinearElasticity::BoundaryData
  {
    BoundaryFunctions displacement;
    BoundaryFunctions traction;
  };



  namespace
  {
    // Whether a cell is the last one shifted: then its stiffness is the same.
    // The shape is that of the cell before, and becomes that of this one.
    bool
    is_translation(const DoFHandler<3>::cell_iterator &cell,
                   std::vector<Tensor<1, 3>> &shape)
    {
      const double tolerance = 1e-12 * cell->diameter();
      bool is_same           = !shape.empty();
      shape.resize(cell->n_vertices());
      for (const unsigned int v : cell->vertex_indices())
        {
          const Tensor<1, 3> edge = cell->vertex(v) - cell->vertex(0);
          is_same  = is_same && (edge - shape[v]).norm() <= tolerance;
          shape[v] = edge;
        }
      return is_same;
    }



    void
    integrate_stiffness(const FEValues<3> &values,
                        const double lame_lambda,
                        const double shear_modulus,
                        FullMatrix<double> &cell_matrix)
    {
      const FiniteElement<3> &fe = values.get_fe();
      const unsigned int n       = fe.n_dofs_per_cell();
      cell_matrix                = 0.;

      // a(φ_i e_a, φ_j e_b) = ∫ λ ∂aφ_i ∂bφ_j + G (∂bφ_i ∂aφ_j
      //                         + δ_ab ∇φ_i·∇φ_j)
      for (const unsigned int q : values.quadrature_point_indices())
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int a   = fe.system_to_component_index(i).first;
            const Tensor<1, 3> &gi = values.shape_grad(i, q);
            for (unsigned int j = 0; j < n; ++j)
              {
                const unsigned int b   = fe.system_to_component_index(j).first;
                const Tensor<1, 3> &gj = values.shape_grad(j, q);
                cell_matrix(i, j) +=
                  (lame_lambda * gi[a] * gj[b] +
                   shear_modulus * (gi[b] * gj[a] + (a == b ? gi * gj : 0.))) *
                  values.JxW(q);
              }
          }
    }
  } // namespace



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
    assemble();
  }



  LinearElasticity::~LinearElasticity() = default;



  const LA::SparseMatrix &
  LinearElasticity::constrained_stiffness() const
  {
    return *constrained_stiffness_;
  }



  LA::Vector
  LinearElasticity::stiffness_diagonal() const
  {
    LA::Vector diagonal = zero_vector();
    for (const auto dof : body_.locally_owned_dofs())
      diagonal(dof) = constrained_stiffness_->diag_element(dof);
    diagonal.compress(VectorOperation::insert);
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
    return LA::Vector(body_.locally_owned_dofs(), body_.communicator());
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

    boundary_               = std::make_unique<BoundaryData>();
    boundary_->displacement = parse_boundary_functions(
      parameters.boundary.prescribed_displacement, displacement_location);
    boundary_->traction =
      parse_boundary_functions(parameters.boundary.traction, traction_location);

    for (const auto &condition : boundary_->displacement)
      body_.require_boundary(condition.first, displacement_location);
    for (const auto &condition : boundary_->traction)
      {
        body_.require_boundary(condition.first, traction_location);
        if (boundary_->displacement.count(condition.first) != 0)
          throw InputError(traction_location + ": boundary " +
                           std::to_string(condition.first) +
                           " already has a prescribed displacement, a "
                           "traction there is carried by the support alone; "
                           "allowed is one of the two.");
      }

    constraints_.reinit(body_.locally_relevant_dofs());
    DoFTools::make_hanging_node_constraints(body_.dof_handler(), constraints_);
    together(body_.communicator(), [&]() {
      for (const auto &condition : boundary_->displacement)
        VectorTools::interpolate_boundary_values(body_.mapping(),
                                                 body_.dof_handler(),
                                                 condition.first,
                                                 *condition.second,
                                                 constraints_);
    });
    constraints_.close();
  }



  void
  LinearElasticity::assemble()
  {
    const DoFHandler<3> &dof_handler = body_.dof_handler();
    const IndexSet &owned            = body_.locally_owned_dofs();
    const IndexSet &relevant         = body_.locally_relevant_dofs();
    const MPI_Comm comm              = body_.communicator();

    // one pattern for both matrices: the entries of constrained rows stay
    DynamicSparsityPattern pattern(relevant);
    DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints_, true);
    SparsityTools::distribute_sparsity_pattern(pattern, owned, comm, relevant);

    stiffness_             = std::make_unique<LA::SparseMatrix>();
    constrained_stiffness_ = std::make_unique<LA::SparseMatrix>();
    stiffness_->reinit(owned, owned, pattern, comm);
    constrained_stiffness_->reinit(owned, owned, pattern, comm);
    load_             = std::make_unique<LA::Vector>(owned, comm);
    constrained_load_ = std::make_unique<LA::Vector>(owned, comm);

    const FiniteElement<3> &fe = dof_handler.get_fe();
    const QGauss<3> cell_quadrature(fe.degree + 1);
    const QGauss<2> face_quadrature(fe.degree + 1);
    FEValues<3> cell_values(body_.mapping(),
                            fe,
                            cell_quadrature,
                            update_gradients | update_JxW_values);
    FEFaceValues<3> face_values(body_.mapping(),
                                fe,
                                face_quadrature,
                                update_values | update_quadrature_points |
                                  update_JxW_values);

    const unsigned int n = fe.n_dofs_per_cell();
    FullMatrix<double> cell_matrix(n, n);
    Vector<double> cell_load(n);
    std::vector<types::global_dof_index> indices(n);
    std::vector<Tensor<1, 3>> last_shape;

    together(comm, [&]() {
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            cell_load = 0.;
            if (!is_translation(cell, last_shape))
              {
                cell_values.reinit(cell);
                integrate_stiffness(
                  cell_values, lame_lambda_, shear_modulus_, cell_matrix);
              }

            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() &&
                  boundary_->traction.count(face->boundary_id()) != 0)
                {
                  const ParsedFunction &traction =
                    *boundary_->traction.at(face->boundary_id());
                  face_values.reinit(cell, face);
                  for (const unsigned int q :
                       face_values.quadrature_point_indices())
                    for (unsigned int i = 0; i < n; ++i)
                      cell_load(i) +=
                        traction.value(face_values.quadrature_point(q),
                                       fe.system_to_component_index(i).first) *
                        face_values.shape_value(i, q) * face_values.JxW(q);
                }

            cell->get_dof_indices(indices);
            constraints_.distribute_local_to_global(cell_matrix,
                                                    cell_load,
                                                    indices,
                                                    *constrained_stiffness_,
                                                    *constrained_load_,
                                                    true);
            stiffness_->add(indices, cell_matrix);
            load_->add(indices, cell_load);
          }
    });

    stiffness_->compress(VectorOperation::add);
    constrained_stiffness_->compress(VectorOperation::add);
    load_->compress(VectorOperation::add);
    constrained_load_->compress(VectorOperation::add);
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
