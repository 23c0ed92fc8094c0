#pragma once

#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>

#include <deal.II/base/types.h>

#include <memory>
#include <vector>

namespace stiction
{
  class BackgroundMultigrid;
  class LinearElasticity;
  class Materials;
  class MixedPreconditioner;
  class MeshHierarchy;
  class DofSubsetHierarchy;

  /// An approximate inverse of the stiffness matrix whose nodes on a list are held by
  /// supports that change: of P K P + S on the range of P, with P the projections
  /// (prescribed displacements included) and S the springs. On each level of the mesh;
  /// the last level is the mesh itself. It is a geometric V-cycle without matrices, in
  /// single precision; for nearly incompressible bodies see MixedPreconditioner.
  ///
  /// Smoother: Chebyshev polynomials of the fourth kind (J. Lottes, Optimal
  /// polynomial smoothers for multigrid V-cycles, 2022), which need the largest
  /// eigenvalue only, on the nodal diagonal. Supports are projections and
  /// springs at single nodes, so that a changed contact set costs no set-up on
  /// any level but the coarsest.
  ///
  /// How supports get to a coarser level: a coarse node is projected like the
  /// fine node at its place, and its spring is the sum of the fine springs
  /// weighted with its own trilinear function, the lumped Galerkin matrix,
  /// within what is left free.
  ///
  /// With displacements û relative to what lies opposite (BasisTransformation) all this
  /// holds for K̂ = TᵀKT: corrections go T⁻¹ I T from a level to the finer one.
  ///
  /// A coarsest level too large to be factorised, such as a mesh from a file, has
  /// grids behind it: see BackgroundMultigrid. Without them the end of the
  /// cycle is algebraic multigrid.
  class Multigrid
  {
  public:
    /// Up to this many unknowns a factorisation takes seconds, and a gigabyte or two.
    static constexpr dealii::types::global_dof_index max_factorized = 100000;

    /// @param supported_nodes the nodes that supports may hold.
    /// @param bases of all levels, for bodies that touch each other; or nothing.
    /// @param is_geometric whether the coarsest level may have grids behind it.
    ///   The other arguments must outlive the object. Collective.
    Multigrid(const LinearElasticity &elasticity, const MeshHierarchy &hierarchy,
              const DofSubsetHierarchy &supported_nodes,
              std::vector<BasisTransformation> bases = {}, bool is_geometric = true);

    /// With other materials than those of the body, which must outlive the object.
    Multigrid(const LinearElasticity &elasticity, const Materials &materials,
              const MeshHierarchy &hierarchy, const DofSubsetHierarchy &supported_nodes,
              std::vector<BasisTransformation> bases, bool is_geometric);
    ~Multigrid();

    /// That of a level.
    const BasisTransformation &basis(const unsigned int level) const
    {
      return bases_[level];
    }

    /// Takes new supports on a level and carries them to the coarser ones.
    /// Collective.
    ///
    /// @param supports for the nodes of the list on this level, in its order;
    ///   the same on all ranks.
    void set_supports(unsigned int level, const NodalSupports &supports);

    /// Whether vmult() on this level solves exactly.
    bool is_direct(unsigned int level) const;

    /// Makes it do so from the next supports on, by a factorisation for each
    /// set of them. Collective.
    ///
    /// @return whether that is something new, and the level small enough.
    bool factorize(unsigned int level);

    /// Whether vmult() on this level is a linear map, and symmetric. Not so for nearly
    /// incompressible bodies, for which it iterates.
    bool is_linear(unsigned int level) const;

    /// dst times the returned number is the approximate inverse times src.
    /// What src has in held directions is ignored, dst is
    /// zero there. The number keeps dst in the range of single precision whatever
    /// the units are. Collective.
    double vmult(unsigned int level, LA::VectorOf<float> &dst, const LA::Vector &src);

    /// Whether the last vmult() was as near as it is meant to be, where it iterates.
    bool is_precise() const { return is_precise_; }

    /// dst is the inverse times src in double precision, on a level where is_direct().
    /// Collective.
    void solve(unsigned int level, LA::Vector &dst, const LA::Vector &src);

    /// Forgets which levels were factorised, and other supports, as if made anew.
    void forget();

  private:
    class Level;
    struct Coarse;

    /// The solver at the end of the cycles of a level.
    std::unique_ptr<Coarse> make_coarse(unsigned int level, const NodalSupports &supports,
                                        bool is_direct) const;

    /// The supports of the coarsest level.
    void set_coarsest(const NodalSupports &supports);

    /// One at the unknowns of a level whose displacement is prescribed.
    LA::Vector fixed_on(unsigned int level) const;

    /// x of the level becomes one V-cycle for b of the level.
    void cycle(unsigned int level);

    /// Adds to x of the level what the coarser one makes of the residual r, which is
    /// not kept.
    void correct(unsigned int level, LA::VectorOf<float> &x, LA::VectorOf<float> &r);

    /// That of the vectors in a cycle of the level.
    const BasisTransformation &basis_of_cycle(unsigned int level) const;

    /// From forces r on absolute displacements of the next finer level to those b of
    /// this one, and from x of this level, which is not kept, to absolute ones there.
    void restrict_to(unsigned int level, LA::VectorOf<float> &b,
                     const LA::VectorOf<float> &r) const;
    void prolongate_add(unsigned int level, LA::VectorOf<float> &fine,
                        LA::VectorOf<float> &x) const;

    /// A power of two near the size of the entries of K, N/m.
    const double unit_;
    const LinearElasticity &elasticity_;
    const Materials &materials_;
    const MeshHierarchy &hierarchy_;
    const DofSubsetHierarchy &supported_nodes_;
    std::vector<BasisTransformation> bases_;
    /// Of all levels but those where a solver ends the cycle.
    std::vector<std::unique_ptr<Level>> levels_;
    std::unique_ptr<BackgroundMultigrid> background_; ///< of the coarsest level
    /// That of the coarsest level, and of those that are factorised.
    std::vector<std::unique_ptr<Coarse>> coarse_;
    std::unique_ptr<MixedPreconditioner>
      mixed_; ///< in place of all levels but small ones
    bool is_precise_ = true;
    std::vector<bool> is_factorized_; ///< from the next supports on
  };
} // namespace stiction
