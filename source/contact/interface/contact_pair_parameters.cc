#include <stiction/base/text/boundary_functions.h>
#include <stiction/contact/interface/contact_pair_parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  namespace
  {
    bool are_all_zero(const std::string &text)
    {
      const auto parts = split_at_bars(text);
      return std::all_of(parts.begin(), parts.end(), are_zero);
    }

    // The same of the angles in 'px; py; pz; ax; ay; az; angle | ...'.
    bool are_angles_zero(const std::string &text)
    {
      const auto parts = split_at_bars(text);
      return std::all_of(parts.begin(), parts.end(), [](const std::string &part) {
        return are_zero(part.substr(part.rfind(';') + 1));
      });
    }
  } // namespace

  ContactPairParameters::ContactPairParameters()
    : ParameterAcceptor("Boundary conditions")
  {
    add_parameter(
      "Contact boundary", contact_boundary,
      "Name or number of the boundary that may touch an obstacle, several separated by "
      "'|'; must be said. A node that belongs to several of them bears the forces of the "
      "first, nodes beside it those of the others. The entries Obstacle and Initial gap "
      "here and all those of the section Friction have one value for all contact "
      "boundaries, or one for each, separated by '|' in the same order. In place of "
      "these lists there may be a section a contact boundary, 'subsection Contact pair "
      "NAME' with the entries Boundary, Obstacle, Slave side, Mesh gap, Sliding, Initial "
      "gap, Displacement, Rotation, Force, Law, Coefficient, Slip stress, First "
      "direction.");
    add_parameter(
      "Obstacle", obstacle,
      "What the contact boundary may touch. boundary : NAME, another boundary of the "
      "mesh, of another body or of the same one: a contact pair of elastic bodies, whose "
      "meshes need not match; boundary : NAME, NAME, several of them side by side, as "
      "the plates under a pad, whose forces act at the nodes of the pad (of a name with "
      "a comma say the number). All others are rigid. foundation: it lies opposite to "
      "the boundary along its outward normal, at the distance 'Initial gap'. plane : px; "
      "py; pz; nx; ny; nz, through a point, with its normal towards the body. sphere : "
      "cx; cy; cz; R, centre and radius. cylinder : px; py; pz; ax; ay; az; R, infinite, "
      "by a point of its axis, the axis' direction and the radius. R < 0: a cavity of "
      "radius -R with the body inside. paraboloid : px; py; pz; ax; ay; az; R, all "
      "points with s + r^2/(2R) < 0, s being the coordinate along the axis a (towards "
      "the body) from the apex p and r the distance from the axis; R is the radius at "
      "the apex, R < 0 a cup. formula : psi, a function of x, y, z, t that is positive "
      "outside the obstacle. file : NAME.stl, a surface of triangles, open or closed, "
      "whose vertices go round counterclockwise as seen from outside (looked for as "
      "'Geometry/Mesh file'). Unit: of length; numbers may be formulas in t. With psi "
      "the distance from the obstacle (or the formula), a node has the normal -grad "
      "psi/|grad psi| and the gap psi/|grad psi| where it is before deformation, which "
      "are kept unless 'Sliding = far': contact is linearised. Nodes whose outward "
      "normal is more than 84 degrees away from that normal face away from the obstacle "
      "and cannot touch it; they must not be inside. An obstacle that is moved by "
      "formulas in t drags nothing along; for that there are 'Obstacle displacement' and "
      "'Obstacle rotation'.");
    add_parameter("Slave side", slave_side,
                  "Of a contact pair the side whose nodes carry the contact forces: "
                  "boundary, the one of 'Contact boundary', or obstacle, the one of "
                  "'Obstacle'. automatic: the side that ends within the other, if both "
                  "are flat, or round and fit, unless it is 30 times stiffer, has no "
                  "cells that are larger by a quarter, and the bodies have more than "
                  "200,000 unknowns before adaptive refinement; of two that go on "
                  "the softer one if E/h of its cells, h being their size before "
                  "refinement, is less by a factor of two or more, otherwise that with "
                  "smaller cells; the other one if supports hold nodes of this one "
                  "alone, which lack friction, or, unless this one is 30 times softer, "
                  "if it stands on an edge, or if over several pairs each body would "
                  "bear forces of the next all the way round; the boundary itself if "
                  "several are opposite or "
                  "'Initial gap' is a formula of its places. Either gives the same "
                  "answer but for the error of the mesh, unless this side stands on an "
                  "edge: pressures act along its normals.");
    add_parameter("Mesh gap", mesh_gap,
                  "Of a contact pair, kept: the distance between both sides as they are "
                  "meshed, negative where they overlap, to which 'Initial gap' is added. "
                  "removed: 'Initial gap' alone, whatever the distance, though not with "
                  "sides that overlap by more than a body is thick; for round "
                  "surfaces, which facets keep apart or let overlap by more than the "
                  "bodies give way, and for overlaps that the drawing has and the bodies "
                  "have not. A fit with interference is then a negative 'Initial gap'.");
    add_parameter(
      "Sliding", sliding,
      "Where gaps and normals of an obstacle with a shape are taken. little: where body "
      "and obstacle are before anything moves; a warning says if they came to where a "
      "curved one is another. far: where both come to, found by placing the obstacle at "
      "the answer until the certificate holds there: for obstacles that are dragged or "
      "roll along a body or begin away from it, by any distance, and bodies that slide "
      "along curved obstacles. The body itself remains linear: its strains and turns "
      "must be small.");
    add_parameter("Initial gap", initial_gap,
                  "Distance from the undeformed contact boundary to the foundation along "
                  "the outward normal, a formula in x, y, z, t; for other obstacles it "
                  "is added to their distance, so that a large one makes a ball smaller: "
                  "to begin farther away move the obstacle. Negative: initial "
                  "interference. Unit: of length.");
    add_parameter(
      "Obstacle displacement", obstacle_displacement,
      "How far the obstacle is moved from where 'Obstacle' and 'Initial gap' place it, "
      "'Ux; Uy; Uz', formulas in t: gaps grow by n.U with the normals n of that place, "
      "so that a curved one must begin where it touches, or nearly so, and move by "
      "little, unless 'Sliding = far'; slip is that of the body relative to the moved "
      "surface, which drags the body along by friction, though not what an obstacle does "
      "to come to touch by the shortest way. Unit: of length.");
    add_parameter(
      "Obstacle rotation", obstacle_rotation,
      "By how much the surface of the obstacle has turned, 'px; py; pz; ax; ay; az; "
      "angle', formulas in t: a point p of the axis, which moves along with the "
      "obstacle, its direction a, and the angle in radians, counterclockwise as seen "
      "from where a points to. The obstacle must be a body of revolution about this axis "
      "(a roller, a sphere about any axis through its centre, a plane or a flat "
      "foundation about its normal): the shape stays, and in a step in which the angle "
      "grows by d its surface moves along itself at the place x by d a x (x - p), and "
      "drags the body along by friction. All contact nodes count, those too that are far "
      "away: where n.U is more than a tenth of U the axis is refused. Unit: of length, "
      "and radians.");
    add_parameter("Obstacle force", obstacle_force,
                  "The force that presses the obstacle on, 'Px; Py; Pz', formulas in t. "
                  "The obstacle is then free to move along this vector, from where the "
                  "other entries place it (a curved one where it touches, or nearly so, "
                  "unless 'Sliding = far'), and moves until it acts on the body with "
                  "this force along it; it does not tilt, and is held in the directions "
                  "across. Of a body cut by planes of symmetry it is the part of the "
                  "force that acts on what is modelled. '0; 0; 0': the obstacle is held; "
                  "in a history a force may begin, not end. Unit: of force.");
  }

  bool ContactPairParameters::has_load() const
  {
    return !are_all_zero(obstacle_displacement) || !are_angles_zero(obstacle_rotation) ||
           has_pressed_obstacles();
  }

  bool ContactPairParameters::has_elastic_pairs() const
  {
    const auto obstacles = split_at_bars(obstacle);
    return std::any_of(obstacles.begin(), obstacles.end(), [](const std::string &text) {
      return !paired_boundaries(text).empty();
    });
  }

  std::string ContactPairParameters::all_boundaries() const
  {
    std::string all = contact_boundary;
    for (const std::string &text : split_at_bars(obstacle))
      for (const std::string &name : paired_boundaries(text))
        all += " | " + name;
    return all;
  }

  std::vector<std::string> paired_boundaries(const std::string &obstacle)
  {
    const auto [kind, names] = split_at_colon(obstacle);
    if (kind != "boundary" || !names)
      return {};
    return dealii::Utilities::split_string_list(*names, ',');
  }

  bool ContactPairParameters::has_pressed_obstacles() const
  {
    return !are_all_zero(obstacle_force);
  }
} // namespace stiction
