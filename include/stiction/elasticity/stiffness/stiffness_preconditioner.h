#ifndef stiction_elasticity_stiffness_stiffness_preconditioner_h
#define stiction_elasticity_stiffness_stiffness_preconditioner_h

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/stiffness/nodal_constraint.h>

namespace stiction
{
  /// An approximate inverse of the stiffness matrix whose nodes on a list are
  /// held by supports that change: of P K P + S on the range of P, with P the
  /// projections (prescribed displacements included) and S the springs. On each
  /// level of the mesh; the last level is the mesh itself.
  class StiffnessPreconditioner
  {
  public:
    virtual ~StiffnessPreconditioner() = default;

    /// Takes new supports on a level and carries them to the coarser ones.
    /// Collective.
    ///
    /// @param supports for the nodes of the list on this level, in its order;
    ///   the same on all ranks.
    virtual void set_supports(unsigned int level, const NodalSupports &supports) = 0;

    /// Whether vmult() on this level solves exactly.
    virtual bool is_direct(unsigned int level) const = 0;

    /// Makes it do so from the next supports on, by a factorisation for each
    /// set of them. Collective.
    ///
    /// @return whether that is something new, and the level small enough.
    virtual bool factorize(unsigned int level) = 0;

    /// dst times the returned number is the approximate inverse times src, a
    /// symmetric linear map. What src has in held directions is ignored, dst is
    /// zero there. Single precision is enough for a preconditioner, the number
    /// keeps it in its range whatever the units are. Collective.
    virtual double vmult(unsigned int level, LA::VectorOf<float> &dst,
                         const LA::Vector &src) = 0;
  };
} // namespace stiction

#endif
