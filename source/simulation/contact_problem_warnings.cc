// What a user should know of an answer that the certificate does not tell.

#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/certificate/friction_limit.h>
#include <stiction/contact/certificate/obstacle_departure.h>
#include <stiction/contact/certificate/pair_figures.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/deformation.h>
#include <stiction/qp/advice.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/warning.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    // Of Green's strain ε + ½ (∇u)ᵀ∇u linear elasticity leaves out the second part,
    // from here on 5 % of the first, which is as much as materials are known to, or
    // half a percent of strain in a body that turns.
    constexpr double large_deformation = 0.1;

    // Of the forces on a body: more is worth a word.
    constexpr double badly_balanced = 0.01;

    // Of the force of a pair: less is what the edge of a punch bears on coarse meshes.
    constexpr double much_beyond_edge = 1. / 3.;

    // Of the pressure where something lies opposite: edges of punches make two or three
    // times that, by the mesh.
    constexpr double high_beyond_edge = 5.;

    // Of the moments of all forces of a pair.
    constexpr double much_across_gap = 0.02;

    // Of the normal force of a pair: three degrees.
    constexpr double much_tilt = 0.05;

    // Of the strain energy of the bodies of a pair.
    constexpr double much_from_facets = 0.02;

    // A warning is given if more than this part of a force acts without friction.
    constexpr double much_without_friction = 0.01;

    // A depth in an obstacle below this part of the displacement is rounding.
    constexpr double rounding_of_depth = 1e-6;

    // ... and what means of the other side, or a node beside, may well have of it.
    constexpr double deep = 0.01;

    // Of what friction can bear: where it falls by more in a step, methods may differ.
    constexpr double much_of_friction = 0.05;

    // Of the way that elastic bodies give, twice their energy over the normal force.
    constexpr double much_of_way = 0.03;

    // Of what bodies are thick.
    constexpr double much_overlap = 0.15;

    // Radians by which normals may turn.
    constexpr double much_turned = 0.05;

    // Of a coefficient of friction: a body that friction holds from turning.
    constexpr double much_of_coefficient = 0.1;

    using Warnings = std::vector<Warning>;

    void add_edge(const ContactBoundary &pair, const PairFigures &figures,
                  Warnings &warnings)
    {
      const char *const name  = pair.name().c_str();
      const char *const other = pair.partner_name().c_str();
      const std::string remedy =
        (pair.partners().size() == 1
           ? "let the other side bear the forces ('Slave side'), or make"
           : "make") +
        std::string(" cells finer there.");
      if (figures.share_beyond_edge > much_beyond_edge)
        warnings.push_back(
          {"edge of " + pair.name(), figures.share_beyond_edge,
           format("%.0f %% of the force between '%s' and '%s' acts at nodes of '%s' "
                  "beyond the edge of what lies opposite, by up to a cell: a body tips "
                  "late, and pressures at such an edge are too large; ",
                  100. * figures.share_beyond_edge, name, other, name) +
             remedy});
      else if (figures.peak_beyond_edge > high_beyond_edge)
        warnings.push_back(
          {"edge of " + pair.name(), figures.share_beyond_edge,
           format(
             "the largest pressure of '%s' on '%s', %.0f times that elsewhere, is at "
             "nodes of '%s' beyond the edge of what lies opposite, and is not to be "
             "trusted; %.0f %% of the force acts there; ",
             name, other, figures.peak_beyond_edge, name,
             100. * figures.share_beyond_edge) +
             remedy});
    }

    void add_supports(const ContactBoundary &boundary, const double frictionless,
                      Warnings &warnings)
    {
      if (frictionless > much_without_friction)
        warnings.push_back(
          {"supports of " + boundary.name(), frictionless,
           format(
             "'Prescribed displacement' makes nodes of '%s' slip that bear %.0f %% of "
             "its force, without friction in the directions that it holds; prescribe "
             "it where the boundary does not touch",
             boundary.name().c_str(), 100. * frictionless) +
             (boundary.partners().size() == 1
                ? ", or let the other side bear the forces ('Slave side')."
              : boundary.is_pair() || boundary.friction().is_orthotropic()
                ? "."
                : ", or both directions along the surface.")});
    }

    void add_idle(const ContactBoundary &boundary, const double depth, const Units &units,
                  Warnings &warnings)
    {
      warnings.push_back(
        {"idle nodes of " + boundary.name(), depth,
         "nodes of '" + boundary.name() +
           "' on which none of its forces act, since their displacement is prescribed or "
           "they belong to a contact boundary before it, came " +
           with_unit(format("%.2g", depth), units.length) + " into " +
           (boundary.is_pair() ? '\'' + boundary.partner_name() + '\'' : "its obstacle") +
           "; the certificate does not speak of them."});
    }

    void add_fall(const ContactBoundary &boundary, const double fall,
                  const bool has_steps, Warnings &warnings)
    {
      if (fall > much_of_friction)
        warnings.push_back(
          {"friction of " + boundary.name(), fall,
           format("friction of '%s' falls by %.0f %% of itself within %s as nodes slip: "
                  "there may be other solutions, which smaller steps ('Time/Steps') tell "
                  "apart.",
                  boundary.name().c_str(), 100. * fall,
                  has_steps ? "the last step" : "the one step")});
    }

    void add_slide(const ContactBoundary &pair, const PairFigures &figures,
                   const Units &units, Warnings &warnings)
    {
      if (figures.way > figures.spacing)
        warnings.push_back({"slide of " + pair.name(), figures.way,
                            "nodes of '" + pair.name() + "' are " +
                              with_unit(format("%.2g", figures.way), units.length) +
                              " from where they were on '" + pair.partner_name() + "', " +
                              format("%.1f", figures.way / figures.spacing) +
                              " times the distance of nodes: gaps, normals and what lies "
                              "opposite remain those "
                              "of the undeformed bodies."});
    }

    void add_gap(const ContactBoundary &pair, const PairFigures &figures,
                 const Units &units, Warnings &warnings)
    {
      if (figures.moment_across_gap > much_across_gap)
        warnings.push_back(
          {"gap of " + pair.name(), figures.moment_across_gap,
           "friction between '" + pair.name() + "' and '" + pair.partner_name() +
             "' acts across the " + with_unit(format("%.2g", figures.gap), units.length) +
             format(" between their meshes: that has a moment, %.2g %% of that of all "
                    "contact forces about its axis, which bodies that touch do not have; "
                    "make them where they touch.",
                    100. * figures.moment_across_gap)});
    }

    void add_tilt(const ContactBoundary &pair, const PairFigures &figures,
                  Warnings &warnings)
    {
      if (!pair.is_tied() && figures.tilt > much_tilt)
        warnings.push_back(
          {"normals of " + pair.name(), figures.tilt,
           format("pressures between '%s' and '%s' act along the normals of the first, "
                  "%.0f %% of their force across those of the second, which is too much "
                  "or too little along it: one of them stands on an edge; ",
                  pair.name().c_str(), pair.partner_name().c_str(), 100. * figures.tilt) +
             (pair.partners().size() == 1
                ? "let the side that is flat there bear the forces ('Slave side')."
                : "round it off, or make the flat one the one boundary.")});
    }

    void add_facets(const ContactBoundary &pair, const PairFigures &figures,
                    const Body &body, const Certificate &certificate, Warnings &warnings)
    {
      std::set<unsigned int> pieces = body.pieces_at(pair.id());
      for (const auto partner : pair.partners())
        pieces.merge(body.pieces_at(partner));
      double energy = 0.;
      for (const unsigned int piece : pieces)
        energy += certificate.strain_energy(piece);
      const double share = figures.climbed / energy;
      if (share > much_from_facets)
        warnings.push_back(
          {"facets of " + pair.name(), share,
           "'" + pair.name() + "' slid on '" + pair.partner_name() +
             format(
               "' until facets wedged, which have %.2g %% of the strain energy: were "
               "the surface as round as it is but for them, friction might not hold the "
               "loads; see whether less is held on a finer mesh, or on one that follows "
               "the surface (second order, 'Geometry/Element degree = 2').",
               100. * share)});
    }

    // What lies inside of the other body before anything gives way, 'Initial gap' apart.
    void add_overlap(const ContactBoundary &pair, const ContactSurface &surface,
                     const Body &body, const Units &units, Warnings &warnings)
    {
      double depth = 0., thickness = std::numeric_limits<double>::max();
      for (const ContactNode &node : surface.nodes())
        if (surface.boundaries()[node.boundary].id() == pair.id() &&
            pair.keeps_mesh_gap())
          depth = std::max(depth, -node.mesh_gap);
      std::set<unsigned int> pieces = body.pieces_at(pair.id());
      for (const auto partner : pair.partners())
        pieces.merge(body.pieces_at(partner));
      for (const unsigned int piece : pieces)
        for (unsigned int c = 0; c < 3; ++c)
          thickness = std::min(thickness, body.pieces()[piece].box.side_length(c));
      if (depth > much_overlap * thickness)
        warnings.push_back(
          {"overlap of " + pair.name(), depth,
           "nodes of '" + pair.name() + "' begin up to " +
             with_unit(format("%.2g", depth), units.length) + " inside '" +
             pair.partner_name() +
             format("', %.0f %% of what a body is thick, and are pushed out; place them "
                    "side by side if that is not meant.",
                    100. * depth / thickness)});
    }

    // What linear kinematics leaves out where nodes moved along an obstacle.
    void add_departure(const ContactBoundary &boundary,
                       const ObstacleDeparture &departure, const double way,
                       const Units &units, Warnings &warnings)
    {
      if (departure.slip > departure.spacing &&
          (departure.distance > much_of_way * way || departure.turn > much_turned))
        warnings.push_back(
          {"obstacle of " + boundary.name(), departure.distance,
           "nodes of '" + boundary.name() +
             "' moved along an obstacle that is another one there: the gap is off by " +
             with_unit(format("%.2g", departure.distance), units.length) +
             format(", the normal by %.2g degrees, while bodies give ",
                    departure.turn * 180. / dealii::numbers::PI) +
             with_unit(format("%.2g", way), units.length) +
             "; gaps and normals remain those of the undeformed body, so that forces may "
             "be "
             "wrong; move them less."});
    }

    void add_deformation(const Deformation &deformation, Warnings &warnings)
    {
      const auto &[strain, rotation] = deformation;
      if (strain > large_deformation)
        warnings.push_back(
          {"strain", strain,
           format("strains of up to %.2g: linear elasticity is for small "
                  "ones and leaves out what is quadratic in them, some %.0f "
                  "%% of the strain there.",
                  strain, 50. * strain)});
      if (rotation > large_deformation)
        warnings.push_back(
          {"rotation", rotation,
           format("the body turns by up to %.2g degrees: linear elasticity is for small "
                  "rotations, and makes a strain of %.2g of this one.",
                  rotation * 180. / dealii::numbers::PI, 0.5 * rotation * rotation)});
    }

    // Forces have the moments that they have on a body that has not turned, and what is
    // round rolls up beside where it lay.
    //
    // @param turn of a body that contact alone holds, radians.
    void add_turn(const double turn, const double coefficient, Warnings &warnings)
    {
      if (coefficient > 0. && turn > much_of_coefficient * coefficient)
        warnings.push_back(
          {"turn", turn,
           format("a body that contact alone holds turns by %.2g degrees, which is "
                  "%.2g of the friction angle: contact forces stay where they act on "
                  "bodies that have not turned, so that a round body may seem held "
                  "beyond what friction bears.",
                  turn * 180. / dealii::numbers::PI, turn / coefficient)});
    }
  } // namespace

  std::vector<Warning> ContactProblem::warnings_of_step() const
  {
    const ContactSurface &surface = contact_surface();
    const double largest          = state_.u.linfty_norm();
    const auto &boundaries        = surface.boundaries();
    const double force            = certificate_->force_scale();
    Warnings warnings;
    if (const double depth = surface.penetration_of_facing_away(state_);
        depth > rounding_of_depth * largest)
      warnings.push_back({"facing away", depth,
                          "a node that faces away from its obstacle came " +
                            with_unit(format("%.2g", depth), units_.length) +
                            " into it; such nodes are no contact nodes, and the "
                            "certificate does not speak of them."});
    if (const auto [body, lacking] = certificate_->worst_balanced();
        lacking > badly_balanced)
      warnings.push_back(
        {"balance", lacking,
         format(
           "forces on body '%s' are out of balance by %.2g %% of themselves, being "
           "small "
           "beside those of the others; lower 'Contact solver/Tolerance', or compute "
           "it by itself.",
           body_->pieces()[body].name.c_str(), 100. * lacking)});
    const std::vector<double> frictionless = surface.frictionless_parts(state_),
                              depths       = surface.penetration_of_idle(state_),
                              falls        = surface.falls_of_friction(state_);
    const double pressing = state_.lambda.head(surface.n_nodes()).cwiseMax(0.).sum();
    const double way      = pressing > 0. ? certificate_->energy_scale() / pressing : 0.;
    for (std::size_t b = 0; b < boundaries.size(); ++b)
      {
        add_supports(boundaries[b], frictionless[b], warnings);
        if (depths[b] > deep * largest)
          add_idle(boundaries[b], depths[b], units_, warnings);
        add_fall(boundaries[b], falls[b], steps_ != nullptr, warnings);
        add_departure(boundaries[b], obstacle_departure(surface, boundaries[b], state_),
                      way, units_, warnings);
      }
    for (const ContactBoundary &pair : boundaries)
      if (pair.is_pair() && !pair.is_tied())
        {
          const PairFigures figures =
            pair_figures(surface, pair, state_, std::max(force, state_.scales.force));
          add_overlap(pair, surface, *body_, units_, warnings);
          add_edge(pair, figures, warnings);
          add_slide(pair, figures, units_, warnings);
          add_gap(pair, figures, units_, warnings);
          add_tilt(pair, figures, warnings);
          add_facets(pair, figures, *body_, *certificate_, warnings);
        }
    add_deformation(largest_deformation(*body_, state_.u), warnings);
    for (const unsigned int piece :
         bodies_at_friction_limit(elasticity(), surface, state_, node_statuses()))
      warnings.push_back(
        {"limit of " + body_->pieces()[piece].name, largest,
         "friction bears all that it can at body '" + body_->pieces()[piece].name +
           "', which slides as a whole: forces balance, but how far it slides, and what "
           "friction dissipates by that, is not determined."});
    double turn                    = 0.;
    const Eigen::VectorXd way_free = elasticity().free_motion_of(state_.u);
    for (const RigidMotion &motion : elasticity().free_motions().motions(way_free))
      turn = std::max(turn, motion.rotation.norm());
    add_turn(turn, surface.largest_coefficient(), warnings);
    return warnings;
  }

  void ContactProblem::remember_warnings()
  {
    for (Warning &warning : warnings_of_step())
      if (const auto before = warned_.find(warning.about);
          before == warned_.end() || before->second.size < warning.size)
        {
          warning.text = format("at t = %.6g: ", elasticity().time()) + warning.text;
          warned_[warning.about] = std::move(warning);
        }
  }

  std::vector<std::string> ContactProblem::warnings() const
  {
    std::vector<std::string> sentences;
    if (parameters_.has_locking())
      sentences.push_back(
        format("with a Poisson ratio of %g trilinear elements lock, bodies and "
               "forces become too stiff, which the certificate does not see: "
               "'Material/Volume strain = cell mean' does not lock.",
               parameters_.material.largest_poisson_ratio()));
    Warnings now;
    const ContactSurface &surface = contact_surface();
    if (status_.converged)
      {
        if (const std::string friction =
              warning_on_friction(surface.largest_coefficient());
            !friction.empty())
          sentences.push_back(friction);
        now = warnings_of_step();
      }
    else if (state_.lambda.size() > 0)
      {
        const std::vector<double> frictionless = surface.frictionless_parts(state_);
        for (std::size_t b = 0; b < frictionless.size(); ++b)
          add_supports(surface.boundaries()[b], frictionless[b], now);
      }
    auto earlier = warned_;
    for (const Warning &warning : now)
      {
        sentences.push_back(warning.text);
        earlier.erase(warning.about);
      }
    for (const auto &[about, warning] : earlier)
      sentences.push_back(warning.text);
    return sentences;
  }
} // namespace stiction
