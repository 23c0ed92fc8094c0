#pragma once

#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <vector>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;

  /// The end of a step, or an answer, on its way to a refined mesh, as fields over the
  /// body: displacement, contact traction and slip path. Meshes are nested, so that the
  /// displacement that was certified, and with it where slip is counted from, stay
  /// the same functions; traction and path are interpolated between nodes.
  class CarriedState
  {
  public:
    /// @param surface on the mesh of the state.
    CarriedState(const State &state, const LinearElasticity &elasticity,
                 const ContactSurface &surface);

    /// What Body::refine() has to carry. The object must not move meanwhile.
    std::vector<LA::Vector *> fields();

    /// The state on the refined mesh. Collective.
    ///
    /// @param elasticity, surface on that mesh, at the time of the state.
    State on(const LinearElasticity &elasticity, const ContactSurface &surface) const;

  private:
    LA::Vector u_, traction_, path_; ///< the path in all three components
    Eigen::VectorXd distances_;
  };
} // namespace stiction
