#include "held_directions.h"
#include "mixed_preconditioner.h"
#include "multigrid_level.h"

#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/multigrid/background_multigrid.h>
#include <stiction/elasticity/multigrid/coarse_solver.h>
#include <stiction/elasticity/levels/dof_subset_hierarchy.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/partitioner.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The largest eigenvalue is a local matter, the same on all fine levels: it
    // is estimated up to this size.
    constexpr types::global_dof_index max_estimated = 300000;

    // Above this order a level without a coarser one has grids behind it.
    constexpr types::global_dof_index max_coarsest = 4000;

    template<typename To, typename From>
    void copy(To &to, const From &from, const double factor = 1.)
    {
      for (unsigned int k = 0; k < from.locally_owned_size(); ++k)
        to.local_element(k) =
          static_cast<typename To::value_type>(factor * from.local_element(k));
    }

    // The scale of numbers of this size that costs them no digit.
    double power_of_two(const double size)
    {
      return size > 0. ? std::ldexp(1., std::ilogb(size)) : 1.;
    }

    // Whether a solver made for one serves the other: the same directions are
    // held, and the springs differ by little.
    bool are_alike(const NodalSupports &a, const NodalSupports &b)
    {
      constexpr double little = 0.1;
      for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].projection != b[i].projection ||
            (a[i].spring - b[i].spring).squaredNorm() >
              little * little * a[i].spring.squaredNorm())
          return false;
      return true;
    }
  } // namespace

  // The coarsest level, in double precision and true units like its solver.
  struct Multigrid::Coarse
  {
    Coarse(const Materials &materials, const MeshLevel &mesh, const LA::Vector &fixed,
           const std::vector<types::global_dof_index> &first_dofs,
           const BasisTransformation &basis, const NodalSupports &supports,
           const bool is_direct)
      : solver(materials, mesh, fixed, first_dofs, basis, supports, is_direct)
      , held(mesh, fixed, first_dofs)
      , b(fixed)
      , x(fixed)
      , transferred(mesh.zero_vector<float>())
    {
      held.supports = supports;
    }

    void set_supports(const NodalSupports &new_supports)
    {
      if (are_alike(held.supports, new_supports))
        return;
      held.supports = new_supports;
      solver.set_supports(new_supports);
    }

    // x for b
    void solve()
    {
      held.project(b);
      solver.vmult(x, b);
      held.project(x);
    }

    CoarseSolver solver;
    HeldDirections held;
    LA::Vector b, x;
    Level::Vector transferred;
  };

  Multigrid::Multigrid(const LinearElasticity &elasticity, const MeshHierarchy &hierarchy,
                       const DofSubsetHierarchy &supported_nodes,
                       std::vector<BasisTransformation> bases, const bool is_geometric)
    : Multigrid(elasticity, elasticity.materials(), hierarchy, supported_nodes,
                std::move(bases), is_geometric)
  {
  }

  Multigrid::Multigrid(const LinearElasticity &elasticity, const Materials &materials,
                       const MeshHierarchy &hierarchy,
                       const DofSubsetHierarchy &supported_nodes,
                       std::vector<BasisTransformation> bases, const bool is_geometric)
    : unit_(power_of_two(materials.largest_shear_modulus() *
                         elasticity.body().bounding_box().side_length(0)))
    , elasticity_(elasticity)
    , materials_(materials)
    , hierarchy_(hierarchy)
    , supported_nodes_(supported_nodes)
    , bases_(std::move(bases))
    , levels_(hierarchy.n_levels())
    , coarse_(hierarchy.n_levels())
    , is_factorized_(hierarchy.n_levels(), false)
  {
    bases_.resize(hierarchy.n_levels());
    if (&materials == &elasticity.materials() && MixedPreconditioner::serves(elasticity))
      {
        std::vector<LA::Vector> fixed;
        for (unsigned int l = 0; l < hierarchy.n_levels(); ++l)
          fixed.push_back(fixed_on(l));
        mixed_ = std::make_unique<MixedPreconditioner>(
          elasticity, hierarchy, supported_nodes, bases_, fixed, is_geometric);
        return;
      }
    const bool has_background =
      is_geometric && hierarchy.level(0).n_dofs() > max_coarsest;
    if (has_background)
      background_ = std::make_unique<BackgroundMultigrid>(
        materials, hierarchy.level(0), unit_, fixed_on(0), supported_nodes.first_dofs(0),
        bases_[0]);
    float eigenvalue = 0.f;
    for (unsigned int l = has_background ? 0 : 1; l < hierarchy.n_levels(); ++l)
      {
        levels_[l] =
          std::make_unique<Level>(materials, hierarchy.level(l), unit_, fixed_on(l),
                                  supported_nodes.first_dofs(l), bases_[l]);
        const bool is_estimated = eigenvalue == 0.f ||
                                  hierarchy.level(l).n_dofs() <= max_estimated ||
                                  !hierarchy.level(l).is_trilinear();
        if (is_estimated)
          eigenvalue = levels_[l]->estimate_largest_eigenvalue();
        if (is_estimated && !bases_[l].is_identity())
          {
            // held at each other bodies have other eigenvalues
            NodalConstraint held;
            held.projection.setZero();
            levels_[l]->set_supports(
              NodalSupports(supported_nodes.first_dofs(l).size(), held));
            eigenvalue = std::max(eigenvalue, levels_[l]->estimate_largest_eigenvalue());
          }
        levels_[l]->set_largest_eigenvalue(eigenvalue);
      }
  }

  Multigrid::~Multigrid() = default;

  void Multigrid::forget()
  {
    for (unsigned int l = 0; l < coarse_.size(); ++l)
      if (is_factorized_[l] || mixed_)
        {
          is_factorized_[l] = false;
          coarse_[l].reset();
        }
    coarse_[0].reset();
    if (mixed_)
      mixed_->forget();
    if (background_)
      set_coarsest(NodalSupports(supported_nodes_.first_dofs(0).size()));
  }

  void Multigrid::set_coarsest(const NodalSupports &supports)
  {
    if (background_)
      {
        levels_[0]->set_supports(supports);
        background_->set_supports(supports);
      }
    else if (coarse_[0])
      coarse_[0]->set_supports(supports);
    else
      coarse_[0] = make_coarse(0, supports, false);
  }

  std::unique_ptr<Multigrid::Coarse> Multigrid::make_coarse(const unsigned int level,
                                                            const NodalSupports &supports,
                                                            const bool is_direct) const
  {
    return std::make_unique<Coarse>(materials_, hierarchy_.level(level), fixed_on(level),
                                    supported_nodes_.first_dofs(level), bases_[level],
                                    supports, is_direct);
  }

  LA::Vector Multigrid::fixed_on(const unsigned int level) const
  {
    LA::Vector fixed = elasticity_.zero_vector();
    for (const auto dof : fixed.locally_owned_elements())
      if (elasticity_.constraints().is_constrained(dof))
        fixed(dof) = 1.;
    for (unsigned int l = hierarchy_.n_levels() - 1; l > level; --l)
      {
        LA::Vector coarse = hierarchy_.level(l - 1).zero_vector<double>();
        hierarchy_.transfer(l).inject(coarse, fixed);
        fixed = coarse;
      }
    return fixed;
  }

  bool Multigrid::is_direct(const unsigned int level) const
  {
    return coarse_[level] && coarse_[level]->solver.is_direct();
  }

  bool Multigrid::is_linear(const unsigned int level) const
  {
    return mixed_ == nullptr || coarse_[level] != nullptr;
  }

  bool Multigrid::factorize(const unsigned int level)
  {
    if (is_direct(level) || hierarchy_.level(level).n_dofs() > max_factorized)
      return false;
    is_factorized_[level] = true;
    return true;
  }

  void Multigrid::set_supports(const unsigned int level, const NodalSupports &supports)
  {
    auto &coarse_solver = coarse_[level];
    const bool is_small = mixed_ && hierarchy_.level(level).n_dofs() <= max_coarsest;
    if ((is_factorized_[level] || is_small) && !is_direct(level))
      coarse_solver = make_coarse(level, supports, true);
    else if (coarse_solver)
      coarse_solver->set_supports(supports);
    if (coarse_solver)
      return;
    if (mixed_)
      return mixed_->set_supports(level, supports);
    if (level == 0)
      return set_coarsest(supports);
    levels_[level]->set_supports(supports);

    const auto &on_finer = supported_nodes_.on_finer_level(level - 1);
    NodalSupports coarse(on_finer.size());
    for (std::size_t j = 0; j < coarse.size(); ++j)
      coarse[j].projection = supports[on_finer[j]].projection;
    const auto &prolongation = supported_nodes_.prolongation(level);
    for (Eigen::Index j = 0; j < prolongation.outerSize(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(prolongation, j); entry;
           ++entry)
        coarse[j].spring += entry.value() * supports[entry.row()].spring;
    for (NodalConstraint &support : coarse)
      support.spring = (support.projection * support.spring * support.projection).eval();
    set_supports(level - 1, coarse);
  }

  double Multigrid::vmult(const unsigned int level, LA::VectorOf<float> &dst,
                          const LA::Vector &src)
  {
    if (mixed_ && !coarse_[level])
      {
        LA::Vector x      = hierarchy_.level(level).zero_vector<double>();
        is_precise_       = mixed_->vmult(level, x, src);
        const double size = power_of_two(x.linfty_norm());
        copy(dst, x, 1. / size);
        return size;
      }
    // not earlier: without supports bodies may be free to move
    if (!coarse_[level] && !background_ && !coarse_[0])
      set_coarsest(NodalSupports(supported_nodes_.first_dofs(0).size()));
    const double scale = power_of_two(src.linfty_norm());
    if (coarse_[level])
      {
        Coarse &coarse = *coarse_[level];
        copy(coarse.b, src, 1. / scale);
        coarse.solve();
        copy(dst, coarse.x, unit_);
      }
    else
      {
        Level &finest = *levels_[level];
        copy(finest.b, src, 1. / scale);
        bases_[level].forces_to_absolute(finest.b);
        finest.basis().forces_to_relative(finest.b);
        finest.project(finest.b);
        cycle(level);
        finest.basis().to_absolute(finest.x);
        bases_[level].to_relative(finest.x);
        dst.swap(finest.x); // which is made anew by every cycle
      }
    return scale / unit_;
  }

  void Multigrid::solve(const unsigned int level, LA::Vector &dst, const LA::Vector &src)
  {
    Coarse &coarse = *coarse_[level];
    copy(coarse.b, src);
    coarse.solve();
    copy(dst, coarse.x);
  }

  void Multigrid::cycle(const unsigned int level)
  {
    Level &fine = *levels_[level];
    fine.smooth_from_zero(fine.x, fine.b);
    fine.solve_masters(fine.x, fine.b);
    fine.residual(fine.scratch(), fine.x, fine.b);
    correct(level, fine.x, fine.scratch());
    fine.project(fine.x);
    fine.solve_masters(fine.x, fine.b);
    fine.smooth(fine.x, fine.b);
  }

  void Multigrid::correct(const unsigned int level, LA::VectorOf<float> &x,
                          LA::VectorOf<float> &r)
  {
    const BasisTransformation &basis = levels_[level]->basis();
    basis.forces_to_absolute(r);
    basis.to_absolute(x);
    if (level == 0)
      background_->correct(x, r);
    else if (coarse_[level - 1])
      {
        Coarse &coarse = *coarse_[level - 1];
        restrict_to(level - 1, coarse.transferred, r);
        copy(coarse.b, coarse.transferred);
        coarse.solve();
        copy(coarse.transferred, coarse.x, unit_);
        prolongate_add(level - 1, x, coarse.transferred);
      }
    else
      {
        Level &coarse = *levels_[level - 1];
        restrict_to(level - 1, coarse.b, r);
        coarse.project(coarse.b);
        cycle(level - 1);
        prolongate_add(level - 1, x, coarse.x);
      }
    basis.to_relative(x);
  }

  const BasisTransformation &Multigrid::basis_of_cycle(const unsigned int level) const
  {
    return coarse_[level] ? bases_[level] : levels_[level]->basis();
  }

  void Multigrid::restrict_to(const unsigned int level, LA::VectorOf<float> &b,
                              const LA::VectorOf<float> &r) const
  {
    hierarchy_.transfer(level + 1).restrict_to(b, r);
    basis_of_cycle(level).forces_to_relative(b);
  }

  void Multigrid::prolongate_add(const unsigned int level, LA::VectorOf<float> &fine,
                                 LA::VectorOf<float> &x) const
  {
    basis_of_cycle(level).to_absolute(x);
    hierarchy_.transfer(level + 1).prolongate_add(fine, x);
  }
} // namespace stiction
