#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace stiction
{
  /// Of the section 'Boundary conditions' what supports, moves and loads the body.
  struct BoundaryParameters : dealii::ParameterAcceptor
  {
    BoundaryParameters();

    /// Whether an entry loads the body or moves it: a force (also one of zero, if
    /// it is written) or a displacement that is not zero.
    bool has_load() const;

    std::string prescribed_displacement;
    std::string prescribed_points;
    std::string traction;
    std::string pressure;
    std::string body_force;
    std::string gravity;
  };
} // namespace stiction
