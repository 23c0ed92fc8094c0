#ifndef stiction_contact_interface_contact_pair_parameters_h
#define stiction_contact_interface_contact_pair_parameters_h

#include <deal.II/base/parameter_acceptor.h>

#include <string>

namespace stiction
{
  /// Of the section 'Boundary conditions' what the contact boundaries are and what
  /// they may touch, of several separated by '|'.
  struct ContactPairParameters : dealii::ParameterAcceptor
  {
    ContactPairParameters();

    /// Whether an obstacle is displaced, turned or pressed on. Interference loads
    /// the body too, which only the gaps show.
    bool has_load() const;

    /// Whether forces press obstacles on.
    bool has_pressed_obstacles() const;

    std::string contact_boundary      = "";
    std::string obstacle              = "foundation";
    std::string slave_side            = "automatic";
    std::string initial_gap           = "0";
    std::string obstacle_displacement = "0; 0; 0";
    std::string obstacle_rotation     = "0; 0; 0; 0; 0; 1; 0";
    std::string obstacle_force        = "0; 0; 0";
  };
} // namespace stiction

#endif
