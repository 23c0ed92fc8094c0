#include <stiction/base/errors.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/body_parameters.h>
#include <stiction/elasticity/model/boundary_parameters.h>
#include <stiction/elasticity/model/prescribed_displacement.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/numerics/vector_tools_boundary.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Before and after anything that happens, s.
    constexpr double other_time = 1e9;

    // Where an unknown of a cell near this rank is, and along which axis.
    std::string place_of(const Body &body, const types::global_dof_index dof)
    {
      const FiniteElement<3> &fe = body.dof_handler().get_fe();
      std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        if (!cell->is_artificial())
          {
            cell->get_dof_indices(indices);
            const auto i =
              std::find(indices.begin(), indices.end(), dof) - indices.begin();
            if (i == static_cast<std::ptrdiff_t>(indices.size()))
              continue;
            return text_of(
              "along ", "xyz"[fe.system_to_component_index(i).first], " at (",
              body.mapping().transform_unit_to_real_cell(cell, fe.unit_support_point(i)),
              ")");
          }
      return "";
    }
  } // namespace

  PrescribedDisplacement::PrescribedDisplacement(const Body &body,
                                                 const BodyParameters &parameters,
                                                 const double time)
    : body_(body)
    , location_(parameters.source.locate("Boundary conditions/Prescribed displacement"))
    , functions_(parse_boundary_functions(parameters.boundary.prescribed_displacement,
                                          location_, body.boundary_names(), 3, true,
                                          time))
    , points_location_(parameters.source.locate("Boundary conditions/Prescribed points"))
  {
    const std::string &text = parameters.boundary.prescribed_points;
    if (Utilities::trim(text).empty())
      return;
    for (const std::string &part : split_at_bars(text))
      {
        const auto [place, displacement] = split_at_colon(part);
        if (!displacement)
          throw InputError(points_location_ + " = " + text +
                           ", must read 'x; y; z : ux; uy; uz', several "
                           "separated by '|'.");
        const ParsedFunction position(place, 3, points_location_, time),
          early(place, 3, points_location_, -other_time),
          late(place, 3, points_location_, other_time);
        PrescribedPoint point;
        for (unsigned int c = 0; c < 3; ++c)
          {
            point.position[c] = position.value(Point<3>(), c);
            if (position.value(Point<3>(0.37, 0.61, 0.83), c) != point.position[c] ||
                early.value(Point<3>(), c) != point.position[c] ||
                late.value(Point<3>(), c) != point.position[c])
              throw InputError(points_location_ + " = " + place +
                               ", the place of a node must not depend on x, y, z or t.");
          }
        point.displacement = parse_components(*displacement, points_location_,
                                              "the point (" + place + ")", time);
        points_.push_back(std::move(point));
      }
  }

  std::vector<std::pair<std::string, std::string>> PrescribedDisplacement::description()
    const
  {
    const auto describe = [](const BoundaryFunction &displacement) {
      const auto formulas =
        Utilities::split_string_list(displacement.function->expression(), ';');
      std::string held, moved;
      bool is_held = true;
      for (unsigned int c = 0; c < 3; ++c)
        if (displacement.components[c])
          {
            const std::string axis(1, "xyz"[c]);
            is_held = is_held && formulas[c] == "0";
            held += (held.empty() ? "" : " ") + axis;
            moved += (moved.empty() ? "" : ", ") + axis + " = " + formulas[c];
          }
      return is_held ? held : moved;
    };
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto &boundary : functions_)
      all.emplace_back(body_.boundary_names().name(boundary.first),
                       describe(boundary.second));
    for (const PrescribedPoint &point : points_)
      all.emplace_back(text_of("node (", point.position[0], ", ", point.position[1], ", ",
                               point.position[2], ')'),
                       describe(point.displacement));
    return all;
  }

  std::string PrescribedDisplacement::components(const types::boundary_id boundary) const
  {
    std::string text;
    const auto condition = functions_.find(boundary);
    for (unsigned int c = 0; c < 3 && condition != functions_.end(); ++c)
      if (condition->second.components[c])
        text += "xyz"[c];
    return text;
  }

  bool PrescribedDisplacement::holds_completely(const types::boundary_id boundary) const
  {
    const auto condition = functions_.find(boundary);
    return condition != functions_.end() &&
           condition->second.components.n_selected_components() == 3;
  }

  void PrescribedDisplacement::add_to(AffineConstraints<double> &constraints) const
  {
    // Cells of other ranks around the own ones are looked at, too, so that a
    // rank sees all boundaries around its nodes.
    std::map<types::boundary_id, std::map<types::global_dof_index, double>> values;
    double largest = 0.;
    throw_on_all_ranks(body_.communicator(), [&]() {
      for (const auto &condition : functions_)
        {
          auto &here = values[condition.first];
          VectorTools::interpolate_boundary_values(
            body_.mapping(), body_.dof_handler(), condition.first,
            *condition.second.function, here, condition.second.components);
          for (const auto &value : here)
            largest = std::max(largest, std::abs(value.second));
        }
    });
    largest = Utilities::MPI::max(largest, body_.communicator());

    // rounding of formulas that mean the same
    const double tolerance = 1e-10 * largest;
    std::map<types::global_dof_index, types::boundary_id> first;
    throw_on_all_ranks(body_.communicator(), [&]() {
      for (const auto &boundary : values)
        for (const auto &value : boundary.second)
          {
            const types::boundary_id other =
              first.emplace(value.first, boundary.first).first->second;
            const double of_other = values.at(other).at(value.first);
            if (std::abs(value.second - of_other) <= tolerance)
              continue;
            throw InputError(
              text_of(location_, ": boundary ", body_.boundary_names().describe(other),
                      " prescribes ", of_other, " and boundary ",
                      body_.boundary_names().describe(boundary.first), " ", value.second,
                      " ", place_of(body_, value.first),
                      ", must be the same where they meet or 'free' on one of them."));
          }
    });

    for (const auto &dof : first)
      if (constraints.can_store_line(dof.first) && !constraints.is_constrained(dof.first))
        {
          constraints.add_line(dof.first);
          constraints.set_inhomogeneity(dof.first, values.at(dof.second).at(dof.first));
        }
    add_points_to(constraints);
  }

  std::set<types::boundary_id> PrescribedDisplacement::boundaries() const
  {
    std::set<types::boundary_id> ids;
    for (const auto &condition : functions_)
      ids.insert(condition.first);
    return ids;
  }

  std::map<types::global_dof_index, types::boundary_id> PrescribedDisplacement::
    supporting_boundaries() const
  {
    std::map<types::global_dof_index, types::boundary_id> boundary_of;
    for (const auto &condition : functions_) // in the order of their ids
      for (const auto dof : DoFTools::extract_boundary_dofs(
             body_.dof_handler(), condition.second.components, {condition.first}))
        boundary_of.emplace(dof, condition.first);
    return boundary_of;
  }

  std::vector<PrescribedDisplacement::SupportedNode> PrescribedDisplacement::
    supported_nodes() const
  {
    std::vector<SupportedNode> nodes;
    for (const PrescribedPoint &point : points_)
      nodes.push_back(node_of(point));
    return nodes;
  }

  PrescribedDisplacement::SupportedNode PrescribedDisplacement::node_of(
    const PrescribedPoint &point) const
  {
    const double near = 1e-6 * body_.diameter();

    SupportedNode nearest{0, Point<3>(), point.displacement.components};
    double distance = std::numeric_limits<double>::max();
    std::vector<unsigned int> n_of_body(body_.pieces().size()); // nodes here
    for (const Body::Node &node : body_.locally_owned_nodes())
      {
        if (node.position.distance(point.position) <= near)
          ++n_of_body[node.piece];
        if (node.position.distance(point.position) >= distance)
          continue;
        distance          = node.position.distance(point.position);
        nearest.first_dof = node.dofs[0];
        nearest.position  = node.position;
        for (unsigned int c = 0; c < 3; ++c)
          if (std::abs(nearest.position[c]) < 1e-9 * near)
            nearest.position[c] = 0.; // rounding
      }
    Utilities::MPI::sum(n_of_body, body_.communicator(), n_of_body);
    std::vector<std::string> bodies;
    for (std::size_t p = 0; p < n_of_body.size(); ++p)
      if (n_of_body[p] > 0)
        bodies.push_back('\'' + body_.pieces()[p].name + '\'');
    if (bodies.size() > 1)
      throw InputError(text_of(points_location_, ": bodies ", listed(bodies),
                               " each have a node at (", point.position,
                               "), must be a node of one body alone, or a boundary in "
                               "'Boundary conditions/Prescribed displacement'."));
    const double least = Utilities::MPI::min(distance, body_.communicator());
    const bool is_here = distance == least;
    throw_on_all_ranks(body_.communicator(), [&]() {
      if (is_here && least > near)
        throw InputError(text_of(points_location_, ": there is no node at (",
                                 point.position, "), the nearest one is at (",
                                 nearest.position, "), which must be given."));
    });
    // what is nearest is one node, known to its owner
    nearest.first_dof =
      Utilities::MPI::max(is_here ? nearest.first_dof : 0, body_.communicator());
    for (unsigned int c = 0; c < 3; ++c)
      nearest.position[c] =
        Utilities::MPI::sum(is_here ? nearest.position[c] : 0., body_.communicator());
    return nearest;
  }

  void PrescribedDisplacement::add_points_to(AffineConstraints<double> &constraints) const
  {
    for (const PrescribedPoint &point : points_)
      {
        const SupportedNode node = node_of(point);
        throw_on_all_ranks(body_.communicator(), [&]() {
          if (body_.is_hanging(node.first_dof))
            throw InputError(
              text_of(points_location_, ": the node at (", point.position,
                      ") hangs between others, must be one of a coarser cell."));
          for (unsigned int c = 0; c < 3; ++c)
            {
              const types::global_dof_index dof = node.first_dof + c;
              if (!node.components[c] || !constraints.can_store_line(dof))
                continue;
              // at the node, where those of the boundaries are taken
              const double value = point.displacement.function->value(node.position, c);
              if (!constraints.is_constrained(dof))
                {
                  constraints.add_line(dof);
                  constraints.set_inhomogeneity(dof, value);
                }
              else if (std::abs(constraints.get_inhomogeneity(dof) - value) >
                       1e-10 * std::abs(value))
                throw InputError(text_of(
                  points_location_, ": prescribes ", value, " along ", "xyz"[c], " at (",
                  point.position, "), where ", constraints.get_inhomogeneity(dof),
                  " is prescribed already, must be the same or 'free'."));
            }
        });
      }
  }
} // namespace stiction
