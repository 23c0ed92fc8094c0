#pragma once

#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/simulation/solvers/contact_solver.h>

#include <memory>

namespace stiction
{
  /// All that is rebuilt with the mesh, in the order of who knows whom: a body
  /// with its stiffness, the contact nodes, and what solves the contact problem.
  /// Loads, supports, gaps and friction in it are those of one time.
  struct Discretization
  {
    std::unique_ptr<LinearElasticity> elasticity;
    std::unique_ptr<ContactSurface> surface;
    std::unique_ptr<ContactSolver> solver; ///< once something is solved

    /// Makes loads, supports, gaps, obstacles and friction those of another time.
    /// Nothing is assembled or factorised, unless an obstacle that moved makes others
    /// contact nodes: then the solver goes and has to be made anew.
    /// Collective. Throws InputError as the constructors do.
    ///
    /// @param history from which slip is counted.
    /// @param there see ContactSurface.
    void set_time(const ContactParameters &contact, double time,
                  const SlipHistory &history, const State *there = nullptr);

    /// Has gaps of obstacles along which bodies slide far linearised elsewhere, as
    /// set_time() does. @return the surface that was.
    ContactSurface place_obstacles(const ContactParameters &contact,
                                   const SlipHistory &history, const State *there);
  };
} // namespace stiction
