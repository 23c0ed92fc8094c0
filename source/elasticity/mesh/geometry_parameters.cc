#include <stiction/base/errors.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/geometry_parameters.h>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  GeometryParameters::GeometryParameters()
    : ShapeParameters("Geometry")
  {
    add_parameter("Global refinement", global_refinement,
                  "How many times every cell is cut into eight.", prm,
                  Patterns::Integer(0, 12));
    add_parameter("Contact refinement", contact_refinement,
                  "How many more times the cells at the contact boundary and those "
                  "behind them are cut into eight, and cells around them so that "
                  "neighbours differ by one level. The nodes that hang between small and "
                  "large cells follow their neighbours; contact is imposed at the "
                  "others.",
                  prm, Patterns::Integer(0, 6));
    add_parameter("Contact refinement where", contact_refinement_where,
                  "A formula in x, y, z: 'Contact refinement' cuts the cells whose face "
                  "on the contact boundary has its centre where this is above 0, 'x < 1' "
                  "being 1 where it holds and 0 where it does not.");
    add_parameter("Element degree", element_degree,
                  "1: trilinear displacements, 8 nodes a cell; 2: triquadratic ones, 27 "
                  "nodes. Either way contact and friction are imposed node by node, with "
                  "one contact force a node of the contact boundary, and its pressure is "
                  "the force over the nodal area, the integral of the node's shape "
                  "function (all positive: of a face of degree 2, 1/36 for a corner, 1/9 "
                  "for an edge, 4/9 for the centre).",
                  prm, Patterns::Integer(1, 2));
    add_parameter("Table 1 level", table_1_level,
                  "Row k = 1...6 (or beyond) of Table 1 of the paper: sets Lengths, "
                  "Subdivisions and Global refinement to a mesh with the table's numbers "
                  "n/m, for the brick alone. 0: these entries count themselves.",
                  prm, Patterns::Integer(0, 100));
    add_parameter("Table 1 reading", table_1_reading,
                  "What n/m in Table 1 counts, which the paper leaves open. nodes: nodes "
                  "and contact nodes; the 4 x 3 x 1 m brick in (6k+2) x 6k x 2k cells, "
                  "clamped at y = 0. unknowns: primal and dual unknowns; the 3 x 1 x 1 m "
                  "brick in 6k x 2k x 2k cells, clamped at x = 0. Both readings give "
                  "every row of the table exactly.",
                  prm, Patterns::Selection("nodes|unknowns"));
  }

  double GeometryParameters::n_uniform_cells() const
  {
    double cells = bodies.empty() ? n_coarse_cells() : 0.;
    for (const auto &body : bodies)
      cells += body->n_coarse_cells() * std::pow(8., body->refinement);
    return cells * std::pow(8., global_refinement);
  }

  double GeometryParameters::n_cells() const
  {
    // each local refinement makes seven more of every cell of two layers, the
    // largest there are
    const auto with_layers = [&](const ShapeParameters &shape, const double refinement) {
      const double uniform = shape.n_coarse_cells() * std::pow(8., refinement);
      const double layer   = uniform / std::pow(2., refinement) / shape.n_thinnest();
      return uniform + 7. / 3. * std::min(2. * layer, uniform) *
                         (std::pow(4., contact_refinement) - 1.);
    };
    if (bodies.empty())
      return with_layers(*this, global_refinement);
    double cells = 0.;
    for (const auto &body : bodies)
      cells += with_layers(*body, global_refinement + body->refinement);
    return cells;
  }

  std::string GeometryParameters::entry_of_size() const
  {
    if (!bodies.empty() && contact_refinement > 0)
      return "Geometry/Contact refinement";
    if (!bodies.empty() && global_refinement == 0)
      {
        const auto n_cells = [](const PlacedBody &body) {
          return body.n_coarse_cells() * std::pow(8., body.refinement);
        };
        const PlacedBody &largest = **std::max_element(
          bodies.begin(), bodies.end(),
          [&](const auto &a, const auto &b) { return n_cells(*a) < n_cells(*b); });
        return largest.refinement > 0 ? largest.entry("Refinement")
                                      : largest.entry_of_shape();
      }
    if (!is_brick())
      return global_refinement > 0 ? "Geometry/Global refinement" : entry_of_shape();
    return table_1_level > 0                    ? "Geometry/Table 1 level"
           : n_cells() > 2. * n_uniform_cells() ? "Geometry/Contact refinement"
           : global_refinement == 0 ||
               n_uniform_cells() / std::pow(8., global_refinement) > max_cells
             ? "Geometry/Subdivisions"
             : "Geometry/Global refinement";
  }

  void GeometryParameters::complete(const ParameterFile &source)
  {
    for (const auto &body : bodies)
      {
        source.require(type.empty() && lengths.empty() && table_1_level == 0,
                       !type.empty()      ? "Geometry/Type"
                       : !lengths.empty() ? "Geometry/Lengths"
                                          : "Geometry/Table 1 level",
                       "says what the one body is, must be left out where there are "
                       "sections 'Body'");
        body->complete(source);
      }
    if (!bodies.empty())
      {
        location = bodies.front()->location;
        return check_size(source);
      }
    if (type.empty() && table_1_level > 0 && mesh_file.empty())
      type = "brick";
    locate(source);
    apply_table_1_level(source);
    check(source);
    check_size(source);
  }

  void GeometryParameters::declare_bodies(const std::string &file,
                                          const std::vector<std::string> &sections)
  {
    for (const std::string &section : sections)
      if (const std::string name = section.substr(PlacedBody::section_name.size() + 1);
          name.find_first_of(".:;|/=") != std::string::npos ||
          name.find_first_not_of("0123456789") == std::string::npos)
        throw InputError(file + ": section '" + section +
                         "', the name of a body must have none of . : ; | / = and must "
                         "not be a number.");
    for (const std::string &section : sections)
      bodies.push_back(std::make_unique<PlacedBody>(section));
  }

  void GeometryParameters::set_boundaries_in_use(const std::set<std::string> &names)
  {
    boundaries_in_use = names;
    for (const auto &body : bodies)
      for (const std::string &name : names)
        if (name.rfind(body->name + '.', 0) == 0)
          body->boundaries_in_use.insert(name.substr(body->name.size() + 1));
  }

  void GeometryParameters::apply_table_1_level(const ParameterFile &source)
  {
    const unsigned int k = table_1_level;
    if (k == 0)
      return;
    source.require(is_brick(), "Geometry/Table 1 level",
                   "is a brick, must be 0 for another 'Geometry/Type'");
    source.require(lengths.empty() && subdivisions.empty(), "Geometry/Table 1 level",
                   "says what 'Lengths' and 'Subdivisions' are, must be 0 where they "
                   "are given");
    source.require(global_refinement <= 1, "Geometry/Table 1 level",
                   "is a brick refined once, must be 0 for another 'Global refinement'");
    // refined once, so that a multigrid method finds two levels
    global_refinement = 1;
    if (table_1_reading == "nodes")
      {
        lengths      = {4., 3., 1.};
        subdivisions = {3 * k + 1, 3 * k, k};
      }
    else
      {
        lengths      = {3., 1., 1.};
        subdivisions = {3 * k, k, k};
      }
  }

  void GeometryParameters::check_size(const ParameterFile &source) const
  {
    source.require(
      n_cells() <= max_cells, entry_of_size(),
      text_of("makes ", n_cells(), " cells, allowed are at most ", max_cells));
  }
} // namespace stiction
