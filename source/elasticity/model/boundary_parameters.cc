#include <stiction/base/text/boundary_functions.h>
#include <stiction/elasticity/model/boundary_parameters.h>

#include <algorithm>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  BoundaryParameters::BoundaryParameters()
    : ParameterAcceptor("Boundary conditions")
  {
    add_parameter("Prescribed displacement", prescribed_displacement,
                  "Boundary and displacement, 'boundary : ux; uy; uz', several "
                  "separated by '|'. A boundary is given by its number or its "
                  "name. Each component is a formula in x, y, z, t, or 'free': "
                  "'left : 0; free; free' is a roller or a plane of symmetry. "
                  "Unit: of length. Zeros clamp the face. Nodes of a contact boundary "
                  "that are held along an obstacle in both directions slip as they are "
                  "moved, with friction that the supports bear; one that is held in one "
                  "direction, or lies opposite to another body, slips in what is held "
                  "without friction, which a warning tells. Empty: none.");
    add_parameter("Prescribed points", prescribed_points,
                  "Place of a node and its displacement, 'x; y; z : ux; uy; uz', several "
                  "separated by '|', components as above: holds a body at single nodes, "
                  "to take away what rigid-body motions are left. A node of the mesh "
                  "must be there. A single node that carries a force moves the more the "
                  "finer the mesh is. Empty: none. Unit: of length.");
    add_parameter("Traction", traction,
                  "Boundary and traction on the body, 'boundary : tx; ty; tz', "
                  "several separated by '|'. Each component is a formula in x, "
                  "y, z, t. Empty: none. Unit: of stress.");
    add_parameter("Pressure", pressure,
                  "Boundary and pressure, 'boundary : p', several separated by '|': acts "
                  "against the outward normal of the undeformed face, in addition to a "
                  "traction. A formula in x, y, z, t. Empty: none. Unit: of stress.");
    add_parameter("Body force", body_force,
                  "Force on the volume, 'fx; fy; fz', each a formula in x, y, "
                  "z, t. Empty: none. Unit: of force per volume.");
    add_parameter("Gravity", gravity,
                  "Acceleration 'gx; gy; gz', each a formula in x, y, z, t, "
                  "whose product with the density is a force on the volume, in "
                  "addition to 'Body force'. '0; 0; -9.81' is weight along -z. "
                  "Empty: none. Unit: of length per time^2.");
  }

  bool BoundaryParameters::has_load() const
  {
    const auto moves = [](const std::string &text) {
      const auto places = split_at_bars(text);
      return std::any_of(places.begin(), places.end(), [](const std::string &place) {
        return !are_zero(place.substr(place.find(':') + 1));
      });
    };
    return !traction.empty() || !pressure.empty() || !body_force.empty() ||
           !gravity.empty() || moves(prescribed_displacement) || moves(prescribed_points);
  }
} // namespace stiction
