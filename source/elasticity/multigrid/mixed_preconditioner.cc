#include "mixed_preconditioner.h"

#include "held_directions.h"

#include <stiction/elasticity/levels/dof_subset_hierarchy.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>
#include <stiction/elasticity/stiffness/hanging_nodes.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the residual of K u = b: more iterations with K gain as much.
    constexpr double reduction = 0.1;

    // Images in the ring, the new one among them, which is made orthogonal to the others:
    // with all of them iterations are a tenth fewer, and take more memory than anything
    // else.
    constexpr unsigned int n_kept = 10;

    // Displacements and pressures, or the residuals of both equations.
    struct Mixed
    {
      LA::Vector u;
      Eigen::VectorXd p;

      void add(const double a, const Mixed &other)
      {
        u.add(a, other.u);
        p += a * other.p;
      }

      double operator*(const Mixed &other) const
      {
        return u * other.u +
               Utilities::MPI::sum(p.dot(other.p), u.get_mpi_communicator());
      }
    };
  } // namespace

  // The equations of one level.
  class MixedPreconditioner::System
  {
  public:
    System(const Materials &materials, const Materials &softened, const MeshLevel &mesh,
           const std::vector<types::global_dof_index> &first_dofs,
           const BasisTransformation &basis, const LA::Vector &fixed)
      : mesh_(mesh)
      , basis_(basis)
      , A_(mesh, softened)
      , hanging_(mesh)
      , held_(mesh, fixed, with_masters(first_dofs, basis))
      , forces_(mesh.zero_vector<double>())
    {
      find_cells(materials, softened);
    }

    // With springs to the ground, without which bodies that hold each other, and that
    // nothing else holds, make the equations singular.
    void set_supports(const NodalSupports &supports)
    {
      held_.supports = supports;
      for (Eigen::Index j = 0; j < basis_.ground().size(); ++j)
        {
          held_.supports.emplace_back();
          held_.supports.back().spring = basis_.ground()(j) * Eigen::Matrix3d::Identity();
        }
    }

    Mixed zero() const
    {
      return {mesh_.zero_vector<double>(), Eigen::VectorXd::Zero(C_.size())};
    }

    void project(LA::Vector &v) const { held_.project(v); }

    // The left-hand sides of both equations.
    void vmult(Mixed &dst, const Mixed &src)
    {
      LA::Vector &u = forces_;
      u.copy_locally_owned_data_from(src.u);
      basis_.to_absolute(u);
      A_.vmult(dst.u, u);
      basis_.forces_to_relative(dst.u);
      dst.p = volume_strains(u) - C_.cwiseProduct(src.p);
      held_.add_springs(dst.u, src.u);
      add_forces(dst.u, 1., src.p);
    }

    // r.u of K u = b, in which the pressures follow from the displacements, and not yet
    // what they are in r.
    void find_residual(LA::Vector &of_displacements, const Mixed &r)
    {
      of_displacements = r.u;
      add_forces(of_displacements, 1., r.p.cwiseQuotient(C_));
    }

    // The pressures that r asks for, and what is left of r.u then.
    void find_pressures(Mixed &d, LA::Vector &left, const Mixed &r)
    {
      d.p  = -r.p.cwiseQuotient(C_ + D_);
      left = r.u;
      add_forces(left, -1., d.p);
    }

  private:
    struct Cell
    {
      std::array<unsigned int, 8> nodes;
      std::array<double, 24> b; // its row of B
    };

    static BasisTransformation::Dofs with_masters(BasisTransformation::Dofs nodes,
                                                  const BasisTransformation &basis)
    {
      nodes.insert(nodes.end(), basis.masters().begin(), basis.masters().end());
      return nodes;
    }

    // B u, of absolute displacements, which get hanging ones.
    Eigen::VectorXd volume_strains(LA::Vector &u) const
    {
      u.update_ghost_values();
      hanging_.interpolate(u.begin());
      Eigen::VectorXd strains(C_.size());
      for (std::size_t e = 0; e < cells_.size(); ++e)
        {
          double sum = 0.;
          for (unsigned int k = 0; k < 24; ++k)
            sum += cells_[e].b[k] * u.begin()[unknown(cells_[e], k)];
          strains(static_cast<Eigen::Index>(e)) = sum;
        }
      u.zero_out_ghost_values();
      return strains;
    }

    // dst += a Bᵀ p, without what it has in held directions.
    void add_forces(LA::Vector &dst, const double a, const Eigen::VectorXd &p)
    {
      forces_ = 0.;
      for (std::size_t e = 0; e < cells_.size(); ++e)
        for (unsigned int k = 0; k < 24; ++k)
          forces_.begin()[unknown(cells_[e], k)] +=
            a * p(static_cast<Eigen::Index>(e)) * cells_[e].b[k];
      hanging_.distribute(forces_.begin());
      forces_.compress(VectorOperation::add);
      basis_.forces_to_relative(forces_);
      dst += forces_;
      held_.project(dst);
    }

    static std::size_t unknown(const Cell &cell, const unsigned int k)
    {
      return 3 * std::size_t(cell.nodes[k / 3]) + k % 3;
    }

    // Rows are scaled so that a pressure acts on nodes with as much as a displacement
    // does, which the norm of both needs: b of a strain in units of force.
    void find_cells(const Materials &materials, const Materials &softened)
    {
      Material volume        = Material::isotropic(1., 0.);
      volume.lame_lambda     = 1.;
      volume.shear_modulus   = 0.;
      volume.mean_dilatation = true;
      volume.stiffness =
        outer_product(unit_symmetric_tensor<3>(), unit_symmetric_tensor<3>());
      ElementStiffness element;
      std::vector<double> C, D;
      mesh_.for_each_cell([&](HexahedralCell cell) {
        const Material &soft = softened.of(cell.material_id);
        const double rest = materials.of(cell.material_id).lame_lambda - soft.lame_lambda;
        if (!(rest > 0.))
          return;
        cell.material               = &volume;
        cell.unit                   = 1.;
        const FullMatrix<double> &K = element(cell); // v vᵀ, v u: strain × √volume
        double trace                = 0.;
        unsigned int j              = 0; // the largest entry of v
        for (unsigned int k = 0; k < 24; ++k)
          {
            trace += K(k, k);
            j = K(k, k) > K(j, j) ? k : j;
          }
        const double stiffness = 2. * soft.shear_modulus + soft.lame_lambda;
        Cell own{cell.nodes, {}};
        for (unsigned int k = 0; k < 24; ++k)
          own.b[k] = stiffness * std::sqrt(trace / K(j, j)) * K(k, j);
        cells_.push_back(own);
        D.push_back(stiffness * trace);
        C.push_back(D.back() * stiffness / rest);
      });
      const auto size = static_cast<Eigen::Index>(C.size());
      C_              = Eigen::Map<const Eigen::VectorXd>(C.data(), size);
      D_              = Eigen::Map<const Eigen::VectorXd>(D.data(), size);
    }

    const MeshLevel &mesh_;
    const BasisTransformation &basis_;
    StiffnessOperator<double> A_;
    HangingNodes hanging_;
    HeldDirections held_;
    LA::Vector forces_;       // scratch
    std::vector<Cell> cells_; // those with pressures
    Eigen::VectorXd C_, D_;
  };

  bool MixedPreconditioner::serves(const LinearElasticity &elasticity)
  {
    return elasticity.mesh().is_trilinear() &&
           elasticity.materials().are_nearly_incompressible();
  }

  MixedPreconditioner::MixedPreconditioner(const LinearElasticity &elasticity,
                                           const MeshHierarchy &hierarchy,
                                           const DofSubsetHierarchy &supported_nodes,
                                           const std::vector<BasisTransformation> &bases,
                                           const std::vector<LA::Vector> &fixed,
                                           const bool is_geometric)
    : softened_(elasticity.materials().softened())
    , simple_(softened_.without_mean_dilatation())
    , cycle_(elasticity, simple_, hierarchy, supported_nodes, bases, is_geometric)
  {
    for (unsigned int l = 0; l < hierarchy.n_levels(); ++l)
      systems_.push_back(std::make_unique<System>(
        elasticity.materials(), softened_, hierarchy.level(l),
        supported_nodes.first_dofs(l), cycle_.basis(l), fixed[l]));
  }

  MixedPreconditioner::~MixedPreconditioner() = default;

  void MixedPreconditioner::set_supports(const unsigned int level,
                                         const NodalSupports &supports)
  {
    cycle_.set_supports(level, supports);
    systems_[level]->set_supports(supports);
  }

  bool MixedPreconditioner::vmult(const unsigned int level, LA::Vector &dst,
                                  const LA::Vector &src)
  {
    System &system = *systems_[level];
    Mixed x = system.zero(), r = x;
    r.u.copy_locally_owned_data_from(src);
    system.project(r.u);
    const double goal = reduction * r.u.l2_norm();
    LA::Vector left   = r.u;
    LA::VectorOf<float> z;
    z.reinit(left.get_partitioner());

    std::vector<Mixed> directions, images; // the last ones, in a ring
    std::array<double, n_kept> squares{};
    for (unsigned int k = 0; k < max_iterations && left.l2_norm() > goal; ++k)
      {
        const unsigned int own = k % n_kept;
        if (k < n_kept)
          {
            directions.push_back(system.zero());
            images.push_back(system.zero());
          }
        Mixed &d = directions[own], &image = images[own];
        system.find_pressures(d, left, r);
        const double factor = cycle_.vmult(level, z, left);
        for (unsigned int i = 0; i < z.locally_owned_size(); ++i)
          d.u.local_element(i) = factor * z.local_element(i);
        system.vmult(image, d);
        for (unsigned int j = 0; j < images.size(); ++j)
          if (j != own)
            {
              const double part = image * images[j] / squares[j];
              image.add(-part, images[j]);
              d.add(-part, directions[j]);
            }
        squares[own] = image * image;
        if (!(squares[own] > 0.))
          break;
        const double amount = r * image / squares[own];
        x.add(amount, d);
        r.add(-amount, image);
        system.find_residual(left, r);
      }
    dst.copy_locally_owned_data_from(x.u);
    return left.l2_norm() <= goal;
  }
} // namespace stiction
