#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/certificate/pair_figures.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/simulation/warnings/pair_warnings.h>

#include <algorithm>
#include <limits>
#include <string>

namespace stiction
{
  namespace
  {
    // Of the force of a pair: less is what the edge of a punch bears on coarse meshes.
    constexpr double much_beyond_edge = 1. / 3.;

    // Of the pressure where something lies opposite: edges of punches make two or three
    // times that, by the mesh.
    constexpr double high_beyond_edge = 5.;

    // Cells: of what is less wide estimates saw a half to a third of the error.
    constexpr double narrow = 2.;

    // Of the moments of all forces of a pair.
    constexpr double much_across_gap = 0.02;

    // Of the normal force of a pair: three degrees.
    constexpr double much_tilt = 0.05;

    // Cosine of a tenth of a degree, from one normal of a surface to all others.
    constexpr double flat = 1. - 1.5e-6;

    // Of the strain energy of the bodies of a pair.
    constexpr double much_from_facets = 0.02;

    // Of the interference of a fit.
    constexpr double much_of_interference = 0.5;

    // Of what facets can do: surfaces that differ by more do not fit.
    constexpr double much_misfit = 3.;

    // Of what bodies are thick.
    constexpr double much_overlap = 0.15;

    // Of the distance of nodes: facets that are less deep are of a flat surface.
    constexpr double no_facets = 1e-6;

    // Of the largest pressure of a pair: a ball on half a cell has 0.4.
    constexpr double much_facet_pressure = 0.5;

    // Of the tractions of a pair: as much as the other side feels.
    constexpr double much_wavering = 0.5;

    // Of the way that elastic bodies give, twice their energy over the normal force:
    // plates of steel and aluminium under one foot differ by 0.15.
    constexpr double much_at_joint = 0.5;

    // What lies inside of the other body before anything gives way, 'Initial gap' apart.
    void add_overlap(const ContactBoundary &pair, const ContactSurface &surface,
                     const Body &body, const Units &units, Warnings &warnings)
    {
      double depth = 0., thickness = std::numeric_limits<double>::max();
      for (const ContactNode &node : surface.nodes())
        if (surface.boundaries()[node.boundary].id() == pair.id() &&
            pair.keeps_mesh_gap())
          depth = std::max(depth, -node.mesh_gap);
      for (const unsigned int piece : pair.pieces(body))
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

    void add_edge(const ContactBoundary &pair, const PairFigures &figures,
                  Warnings &warnings)
    {
      const char *const name  = pair.name().c_str();
      const char *const other = pair.partner_name().c_str();
      const std::string change =
        pair.other_side_may_bear()
          ? format(", or let the other side bear the forces ('Slave side') if it ends "
                   "nowhere on '%s'.",
                   name)
          : ".";
      if (figures.share_beyond_edge > much_beyond_edge)
        warnings.push_back(
          {"edge of " + pair.name(), figures.share_beyond_edge,
           format("%.0f %% of the force between '%s' and '%s' acts at nodes of '%s' "
                  "beyond the edge of what lies opposite, by up to a cell: a body tips "
                  "late, and pressures at such an edge are too large; make cells of '%s' "
                  "finer there",
                  100. * figures.share_beyond_edge, name, other, name, name) +
             change});
      else if (figures.peak_beyond_edge > high_beyond_edge)
        warnings.push_back(
          {"edge of " + pair.name(), figures.share_beyond_edge,
           format(
             "the largest pressure of '%s' on '%s', %.0f times that elsewhere, is at "
             "nodes of '%s' beyond the edge of what lies opposite, and is not to be "
             "trusted, on no mesh; %.0f %% of the force acts there; look at pressures "
             "away from it",
             name, other, figures.peak_beyond_edge, name,
             100. * figures.share_beyond_edge) +
             change});
    }

    void add_width(const ContactBoundary &pair, const PairFigures &figures,
                   Warnings &warnings)
    {
      if (figures.cells_across < narrow)
        warnings.push_back(
          {"width of " + pair.name(), 1. / std::max(figures.cells_across, 0.1),
           format("where '%s' and '%s' touch is %s cells wide, of the side that has the "
                  "larger ones there: the estimated error sees a half to a third of the "
                  "error then; make cells smaller there, as 'Geometry/Contact "
                  "refinement' does.",
                  pair.name().c_str(), pair.partner_name().c_str(),
                  figures.cells_across < 0.1
                    ? "less than 0.1"
                    : format("%.1f", figures.cells_across).c_str())});
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

    // Lips of one body are no arm beside the body.
    void add_gap(const ContactBoundary &pair, const PairFigures &figures,
                 const Body &body, const Units &units, Warnings &warnings)
    {
      if (pair.pieces(body).size() > 1 && figures.moment_across_gap > much_across_gap)
        warnings.push_back(
          {"gap of " + pair.name(), figures.moment_across_gap,
           "friction between '" + pair.name() + "' and '" + pair.partner_name() +
             "' acts across the " + with_unit(format("%.2g", figures.gap), units.length) +
             format(" between their meshes: that has a moment, %.2g %% of that of all "
                    "contact forces about its axis, which bodies that touch do not have; "
                    "make them where they touch.",
                    100. * figures.moment_across_gap)});
    }

    bool is_flat(const ContactBoundary &pair, const ContactSurface &surface)
    {
      const ContactNode *first = nullptr;
      for (const ContactNode &node : surface.nodes())
        if (surface.boundary_of(node).id() == pair.id())
          {
            first = first != nullptr ? first : &node;
            if (node.normal * first->normal < flat)
              return false;
          }
      return true;
    }

    void add_tilt(const ContactBoundary &pair, const ContactSurface &surface,
                  const PairFigures &figures, Warnings &warnings)
    {
      if (figures.tilt > much_tilt)
        warnings.push_back(
          {"normals of " + pair.name(), figures.tilt,
           format("pressures between '%s' and '%s' act along the normals of the first, "
                  "%.0f %% of their force across those of the second, which is too much "
                  "or too little along it: one of them stands on an edge, or has rolled "
                  "there since it was drawn; ",
                  pair.name().c_str(), pair.partner_name().c_str(), 100. * figures.tilt) +
             (pair.partners().size() > 1
                ? "round it off, or make the flat one the one boundary."
              : is_flat(pair, surface)
                ? "round the edge off, or draw what rolls nearer to where it comes to."
                : "let the other side bear the forces ('Slave side') if it is flat "
                  "there, else round the edge off.")});
    }

    void add_joint(const ContactBoundary &pair, const PairFigures &figures,
                   const double way, const Units &units, Warnings &warnings)
    {
      if (figures.joint > much_at_joint * way)
        warnings.push_back(
          {"joint of " + pair.name(), figures.joint,
           "nodes of '" + pair.name() +
             "' follow the mean of bodies that move against each other, over whose "
             "joint they lie: one of these is " +
             with_unit(format("%.2g", figures.joint), units.length) + " inside of '" +
             pair.name() + "' there, which gives way too easily; " +
             (pair.partners().size() > 1
                ? "make a pair of each of '" + pair.partner_name() +
                    "' that bears the forces ('Slave side')."
              : pair.other_side_may_bear()
                ? "let the other side bear the forces ('Slave side')."
                : "make boundaries, and pairs, of each of these.")});
    }

    // What is to overlap, beside facets that are as deep.
    void add_fit(const ContactBoundary &pair, const ContactSurface &surface,
                 const Units &units, Warnings &warnings)
    {
      double interference = 0., facets = 0.;
      for (const ContactNode &node : surface.nodes())
        if (surface.boundaries()[node.boundary].id() == pair.id() && node.own_part == 1.)
          {
            interference = std::max(interference, node.mesh_gap - node.gap);
            facets       = node.facets;
          }
      if (pair.keeps_mesh_gap() && interference > 0. &&
          facets > much_of_interference * interference)
        warnings.push_back(
          {"fit of " + pair.name(), facets,
           "facets keep '" + pair.name() + "' and '" + pair.partner_name() +
             "' apart by up to " + with_unit(format("%.2g", facets), units.length) +
             format(" or let them overlap by it, which is %.2g times what 'Initial gap' "
                    "lets them overlap, and pressures follow them; 'Mesh gap = removed' "
                    "takes that away.",
                    facets / interference)});
    }

    // Who has the distance of meshes removed means that of facets, or of drawings.
    void add_misfit(const ContactBoundary &pair, const PairFigures &figures,
                    Warnings &warnings)
    {
      if (!pair.keeps_mesh_gap() && figures.misfit > much_misfit)
        warnings.push_back(
          {"misfit of " + pair.name(), figures.misfit,
           format(
             "'%s' and '%s' do not fit: what 'Mesh gap = removed' takes away between "
             "them differs by %.2g times what facets make of surfaces that do, so "
             "that they touch where they would not, with much too large an area; say "
             "'Mesh gap = kept'.",
             pair.name().c_str(), pair.partner_name().c_str(), figures.misfit)});
    }

    void add_corners(const ContactBoundary &pair, const PairFigures &figures,
                     Warnings &warnings)
    {
      if (pair.keeps_mesh_gap() && figures.facet_pressure > much_facet_pressure)
        warnings.push_back(
          {"corners of " + pair.name(), figures.facet_pressure,
           format("flat faces stand for a round surface where '%s' and '%s' touch: it "
                  "would take %.2g times the largest pressure to press them flat, so "
                  "that corners may bear alone, with too much, and nothing beside them; "
                  "say 'Geometry/Element degree = 2' on a mesh of second order, make "
                  "cells smaller, or, where they fit, say 'Mesh gap = removed' with "
                  "their overlap as 'Initial gap'.",
                  pair.name().c_str(), pair.partner_name().c_str(),
                  figures.facet_pressure)});
    }

    void add_facets(const ContactBoundary &pair, const PairFigures &figures,
                    const Body &body, const Certificate &certificate, Warnings &warnings)
    {
      const double share = share_of_facets(pair, figures, body, certificate);
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

    void add_wavering(const ContactBoundary &pair, const ContactSurface &surface,
                      const PairFigures &figures, Warnings &warnings)
    {
      const auto is_round = [&](const ContactNode &node) {
        return surface.boundary_of(node).id() == pair.id() &&
               node.facets > no_facets * figures.spacing;
      };
      const char *const name  = pair.name().c_str();
      const char *const other = pair.partner_name().c_str();
      const bool may_fit =
        pair.keeps_mesh_gap() && !pair.is_tied() &&
        std::any_of(surface.nodes().begin(), surface.nodes().end(), is_round);
      if (figures.stiffness_in_wavering * figures.wavering > much_wavering)
        warnings.push_back(
          {"wavering of " + pair.name(), figures.wavering,
           format(
             "tractions of '%s' waver from node to node, %.0f %% of "
             "them without '%s' feeling it: its forces as a whole are right, stresses "
             "at the surface are not; make cells of '%s' as small as those of '%s', and "
             "of second order where they are round",
             name, std::min(100., 100. * figures.wavering), other, other, name) +
             (may_fit
                ? ", or, where they fit, say 'Mesh gap = removed' with their overlap "
                  "as 'Initial gap'."
                : ".")});
    }
  } // namespace

  double share_of_facets(const ContactBoundary &pair, const PairFigures &figures,
                         const Body &body, const Certificate &certificate)
  {
    double energy = 0.;
    for (const unsigned int piece : pair.pieces(body))
      energy += certificate.strain_energy(piece);
    return figures.climbed / energy;
  }

  void add_warnings_of_pair(const ContactBoundary &pair, const ContactSurface &surface,
                            const PairFigures &figures, const Body &body,
                            const Certificate &certificate, const double way,
                            const Units &units, Warnings &warnings)
  {
    add_wavering(pair, surface, figures, warnings);
    if (pair.is_tied())
      return;
    add_overlap(pair, surface, body, units, warnings);
    add_fit(pair, surface, units, warnings);
    add_edge(pair, figures, warnings);
    add_width(pair, figures, warnings);
    add_slide(pair, figures, units, warnings);
    add_gap(pair, figures, body, units, warnings);
    add_tilt(pair, surface, figures, warnings);
    add_joint(pair, figures, way, units, warnings);
    add_misfit(pair, figures, warnings);
    add_corners(pair, figures, warnings);
    add_facets(pair, figures, body, certificate, warnings);
  }
} // namespace stiction
