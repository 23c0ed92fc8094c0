#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace stiction
{
  struct FrictionParameters;
  class ParameterFile;

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

    /// Whether an obstacle is another boundary of the mesh.
    bool has_elastic_pairs() const;

    /// The contact boundaries and, of pairs, the other ones, separated by '|'.
    std::string all_boundaries() const;

    std::string contact_boundary;
    std::string obstacle              = "foundation";
    std::string slave_side            = "automatic";
    std::string mesh_gap              = "kept";
    std::string sliding               = "little";
    std::string initial_gap           = "0";
    std::string obstacle_displacement = "0; 0; 0";
    std::string obstacle_rotation     = "0; 0; 0; 0; 0; 1; 0";
    std::string obstacle_force        = "0; 0; 0";
  };

  /// Names of an obstacle 'boundary : NAME, NAME', none of others.
  std::vector<std::string> paired_boundaries(const std::string &obstacle);

  /// What the parameter file says of contact.
  struct ContactParameters
  {
    const ContactPairParameters &pairs;
    const FrictionParameters &friction;
    const ParameterFile &source; ///< for messages
  };
} // namespace stiction
