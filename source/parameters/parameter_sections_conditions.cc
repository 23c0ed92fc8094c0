#include <stiction/base/boundary_functions.h>
#include <stiction/parameters/parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdlib>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    // Whether all of the formulas 'ux; uy; uz' are 0 or free.
    bool are_zero(const std::string &formulas)
    {
      for (const std::string &text : dealii::Utilities::split_string_list(formulas, ';'))
        {
          char *end          = nullptr;
          const double value = std::strtod(text.c_str(), &end);
          if (text != "free" && (*end != '\0' || value != 0.))
            return false;
        }
      return true;
    }

    // The same of all formulas between bars.
    bool is_zero_for_each(const std::string &text)
    {
      const auto parts = split_at_bars(text);
      return std::all_of(parts.begin(), parts.end(), are_zero);
    }

    // The same of what stands after the colons in 'place : ux; uy; uz | ...'.
    bool are_zero_at_places(const std::string &text)
    {
      for (const std::string &part : split_at_bars(text))
        if (!are_zero(part.substr(part.find(':') + 1)))
          return false;
      return true;
    }
  } // namespace

  BoundaryParameters::BoundaryParameters()
    : ParameterAcceptor("Boundary conditions")
  {
    add_parameter("Prescribed displacement", prescribed_displacement,
                  "Boundary and displacement, 'boundary : ux; uy; uz', several "
                  "separated by '|'. A boundary is given by its number or its "
                  "name. Each component is a formula in x, y, z, t, or 'free': "
                  "'left : 0; free; free' is a roller or a plane of symmetry. "
                  "Unit: of length. Zeros clamp the face. Empty: none.",
                  prm, Patterns::Anything());
    add_parameter("Prescribed points", prescribed_points,
                  "Place of a node and its displacement, 'x; y; z : ux; uy; "
                  "uz', several separated by '|', components as above: holds a "
                  "body at single nodes, to take away what rigid-body motions "
                  "are left. A node of the mesh must be there. A single node "
                  "that carries a force moves the more the finer the mesh is. "
                  "Empty: none. Unit: of length.",
                  prm, Patterns::Anything());
    add_parameter("Traction", traction,
                  "Boundary and traction on the body, 'boundary : tx; ty; tz', "
                  "several separated by '|'. Each component is a formula in x, "
                  "y, z, t. Empty: none. Unit: of stress.",
                  prm, Patterns::Anything());
    add_parameter("Pressure", pressure,
                  "Boundary and pressure, 'boundary : p', several separated by "
                  "'|': acts against the outward normal of the undeformed "
                  "face, in addition to a traction. A formula in x, y, z, t. "
                  "Empty: none. Unit: of stress.",
                  prm, Patterns::Anything());
    add_parameter("Body force", body_force,
                  "Force on the volume, 'fx; fy; fz', each a formula in x, y, "
                  "z, t. Empty: none. Unit: of force per volume.",
                  prm, Patterns::Anything());
    add_parameter("Gravity", gravity,
                  "Acceleration 'gx; gy; gz', each a formula in x, y, z, t, "
                  "whose product with the density is a force on the volume, in "
                  "addition to 'Body force'. '0; 0; -9.81' is weight along -z. "
                  "Empty: none. Unit: of length per time^2.",
                  prm, Patterns::Anything());
    add_parameter("Time", time,
                  "The value of t in all formulas: how far the loads have "
                  "grown, or a time. The problem itself is static.",
                  prm, Patterns::Double());
    add_parameter(
      "Contact boundary", contact_boundary,
      "Name or number of the boundary that may touch an obstacle, several "
      "separated by '|'; must be said. A node that belongs to several of them "
      "is taken as "
      "one of the first of them alone. The entries Obstacle and Initial gap "
      "here and all those of the section Friction have one value for all "
      "contact boundaries, or one for each, separated by '|' in the same "
      "order.",
      prm, Patterns::Anything());
    add_parameter("Obstacle", obstacle,
                  "What the contact boundary may touch, rigid. foundation: it lies "
                  "opposite to the boundary along its outward normal, at the distance "
                  "'Initial gap'. plane : px; py; pz; nx; ny; nz, through a point, with "
                  "its normal towards the body. sphere : cx; cy; cz; R, centre and "
                  "radius. cylinder : px; py; pz; ax; ay; az; R, infinite, by a point of "
                  "its axis, the axis' direction and the radius. R < 0: a cavity of "
                  "radius -R with the body inside. paraboloid : px; py; pz; ax; ay; az; "
                  "R, all points with s + r^2/(2R) < 0, s being the coordinate along the "
                  "axis a (towards the body) from the apex p and r the distance from the "
                  "axis; R is the radius at the apex, R < 0 a cup. formula : psi, a "
                  "function of x, y, z, t that is positive outside the obstacle. file : "
                  "NAME.stl, a surface of triangles, open or closed, whose vertices go "
                  "round counterclockwise as seen from outside (looked for as "
                  "'Geometry/Mesh file'). Unit: of length; numbers may be formulas in t. "
                  "With psi "
                  "the distance "
                  "from the obstacle (or the formula), a node has the normal -grad "
                  "psi/|grad psi| and the gap psi/|grad psi| where it is before "
                  "deformation, which are kept: contact is linearised. Nodes whose "
                  "outward normal is more than 84 degrees away from that normal face "
                  "away from the obstacle and cannot touch it; they must not be inside. "
                  "An obstacle that is moved by formulas in t drags nothing along; for "
                  "that there is 'Obstacle displacement'.",
                  prm, Patterns::Anything());
    add_parameter("Initial gap", initial_gap,
                  "Distance from the undeformed contact boundary to the "
                  "foundation along the outward normal, a formula in x, y, z, t; "
                  "for other obstacles it is added to their distance. "
                  "Negative: initial interference. Unit: of length.",
                  prm, Patterns::Anything());
    add_parameter("Obstacle displacement", obstacle_displacement,
                  "How far the obstacle is moved from where 'Obstacle' and 'Initial gap' "
                  "place it, 'Ux; Uy; Uz', formulas in t: gaps grow by n.U, and slip is "
                  "that of the body relative to the moved surface, which drags the body "
                  "along by friction. Small, like the displacements of the body: normals "
                  "stay. Unit: of length.",
                  prm, Patterns::Anything());
    add_parameter("Obstacle force", obstacle_force,
                  "The force that presses the obstacle on, 'Px; Py; Pz', formulas in t. "
                  "The obstacle is then free to move along this vector, from where the "
                  "other entries place it, and moves until it acts on the body with this "
                  "force along it; it does not turn, and is held in the directions "
                  "across. Of a body cut by planes of symmetry it is the part of the "
                  "force that acts on what is modelled. '0; 0; 0': the obstacle is held. "
                  "Unit: of force.",
                  prm, Patterns::Anything());
  }

  bool BoundaryParameters::has_load() const
  {
    return !traction.empty() || !pressure.empty() || !body_force.empty() ||
           !gravity.empty() || !are_zero_at_places(prescribed_displacement) ||
           !are_zero_at_places(prescribed_points) ||
           !is_zero_for_each(obstacle_displacement) || has_pressed_obstacles();
  }

  bool BoundaryParameters::has_pressed_obstacles() const
  {
    return !is_zero_for_each(obstacle_force);
  }

  FrictionParameters::FrictionParameters()
    : ParameterAcceptor("Friction")
  {
    add_parameter("Law", law_name,
                  "frictionless; given: the tangential traction is at most the "
                  "slip stress, at every node of the contact boundary (Tresca "
                  "friction); coulomb: at most the coefficient times the "
                  "contact pressure. One for all contact boundaries, or one for "
                  "each, separated by '|'. Must be said.",
                  prm, Patterns::Anything());
    add_parameter("Coefficient", coefficient,
                  "Coefficient F >= 0 of Coulomb's law, a formula in x, y, z, t; "
                  "must be said with it. "
                  "Two formulas, '0.3; 0.1': orthotropic friction, F1 along "
                  "the first and F2 along the second principal direction; the "
                  "tangential force lies in the ellipse with these semi-axes "
                  "times the normal force, slip is along its outward normal. "
                  "Figures of the certificate are then those of the ellipse "
                  "scaled to a disc, of radius F1 (slip_bound in "
                  "contact.pvtu). One axis may be up to 100 times the "
                  "other; beyond 10 times, newton multigrid may not get "
                  "there.",
                  prm, Patterns::Anything());
    add_parameter("Slip stress", slip_stress,
                  "Slip stress >= 0 of given friction, which must be said with it, a "
                  "formula in x, y, z, t, "
                  "or two for an ellipse, as for the coefficient. Unit: of stress.",
                  prm, Patterns::Anything());
    add_parameter("First direction", first_direction,
                  "The first principal direction of orthotropic friction, a "
                  "vector of three formulas in x, y, z, t separated by ';': its "
                  "part tangential to the contact boundary counts, which must "
                  "not vanish. The second one is at right angles to it. Empty: "
                  "the tangential part of the x-axis, of the y-axis where the "
                  "normal is within 26 degrees of the x-axis. At a node that "
                  "is held in one tangential direction ('free' in 'Prescribed "
                  "displacement'), friction acts along the other one, up to "
                  "where the ellipse ends there.",
                  prm, Patterns::Anything());
  }

  std::vector<FrictionLaw> FrictionParameters::laws() const
  {
    std::vector<FrictionLaw> laws;
    for (const std::string &law : split_at_bars(law_name))
      laws.push_back(law == "given"     ? FrictionLaw::given
                     : law == "coulomb" ? FrictionLaw::coulomb
                                        : FrictionLaw::frictionless);
    return laws;
  }

  bool FrictionParameters::has_coulomb() const
  {
    const std::vector<FrictionLaw> all = laws();
    return std::count(all.begin(), all.end(), FrictionLaw::coulomb) > 0;
  }

  std::string FrictionParameters::name() const
  {
    const std::vector<std::string> names = split_at_bars(law_name);
    return std::count(names.begin(), names.end(), names.front()) ==
               static_cast<std::ptrdiff_t>(names.size())
             ? names.front()
             : "mixed";
  }
} // namespace stiction
