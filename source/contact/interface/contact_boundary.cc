#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/did_you_mean.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_pair_parameters.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/contact/obstacles/obstacle.h>
#include <stiction/elasticity/mesh/body.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    const std::string obstacle_entry     = "Boundary conditions/Obstacle";
    const std::string displacement_entry = "Boundary conditions/Obstacle displacement";
    const std::string rotation_entry     = "Boundary conditions/Obstacle rotation";
    const std::string slave_entry        = "Boundary conditions/Slave side";
    const std::string gap_entry          = "Boundary conditions/Initial gap";
    const std::string mesh_gap_entry     = "Boundary conditions/Mesh gap";
    const std::string force_entry        = "Boundary conditions/Obstacle force";

    // Below this cosine between the outward normal and the direction towards
    // the obstacle a node faces away from it.
    constexpr double facing_cosine = 0.1;

    // Above this sine between its motion and its tangent plane a surface that turns
    // does not move along itself. The facets of round ones that are made of 32 to a
    // turn, as files and coarse meshes are, are off by up to 0.098; an axis that is
    // off by a tenth of the radius is seen.
    constexpr double sine_of_round = 0.1;

    // A depth that is rounding, as part of the body's size.
    constexpr double rounding = 1e-9;

    // One value for each of n boundaries, of which all may have the same.
    std::vector<std::string> values_for_each(const std::string &text, const std::size_t n,
                                             const std::string &description)
    {
      std::vector<std::string> values = split_at_bars(text);
      if (values.size() == 1)
        values.resize(n, values.front());
      if (values.size() != n)
        throw InputError(description + ", has " + std::to_string(values.size()) +
                         " values separated by '|', must have one" +
                         (n > 1 ? " for all contact boundaries or " + std::to_string(n) +
                                    ", one for each"
                                : " for the one contact boundary") +
                         ".");
      return values;
    }

    // 'file : NAME' with the name of the file where it is.
    std::string with_path(const std::string &obstacle, const ParameterFile &source)
    {
      const std::size_t colon = obstacle.find(':');
      if (colon == std::string::npos ||
          Utilities::trim(obstacle.substr(0, colon)) != "file")
        return obstacle;
      return "file : " + source.find_file(obstacle_entry,
                                          Utilities::trim(obstacle.substr(colon + 1)));
    }

    std::string describe_friction(const FrictionLaw law, const std::string &coefficient,
                                  const std::string &slip_stress,
                                  const std::string &direction)
    {
      if (law == FrictionLaw::frictionless)
        return ", no friction";
      if (law == FrictionLaw::tied)
        return ", tied";
      return (law == FrictionLaw::coulomb
                ? ", Coulomb friction, F = " + coefficient
                : ", given friction, slip stress " + slip_stress) +
             (direction.empty() ? "" : ", first direction " + direction);
    }

    std::string text_of(const Point<3> &p)
    {
      std::ostringstream out;
      out << '(' << p << ')';
      return out.str();
    }
  } // namespace

  ContactBoundary::ContactBoundary()                            = default;
  ContactBoundary::ContactBoundary(ContactBoundary &&) noexcept = default;
  ContactBoundary::~ContactBoundary()                           = default;

  std::vector<ContactBoundary> ContactBoundary::read(const ContactParameters &parameters,
                                                     const Body &body, const double time)
  {
    const ParameterFile &file = parameters.source;
    const std::string entry   = "Boundary conditions/Contact boundary";
    const auto names          = split_at_bars(parameters.pairs.contact_boundary);
    const std::vector<FrictionLaw> laws = parameters.friction.laws();

    const auto values = [&](const std::string &of, const std::string &text) {
      return values_for_each(text, names.size(), file.describe(of));
    };
    values("Friction/Law", parameters.friction.law_name); // counted only
    const auto obstacles = values(obstacle_entry, parameters.pairs.obstacle);
    const auto sides     = values(slave_entry, parameters.pairs.slave_side);
    const auto mesh_gaps = values(mesh_gap_entry, parameters.pairs.mesh_gap);
    const auto gaps      = values(gap_entry, parameters.pairs.initial_gap);
    const auto displacements =
      values(displacement_entry, parameters.pairs.obstacle_displacement);
    const auto rotations = values(rotation_entry, parameters.pairs.obstacle_rotation);
    const auto forces    = values(force_entry, parameters.pairs.obstacle_force);
    const auto coefficients =
      values("Friction/Coefficient", parameters.friction.coefficient);
    const auto slip_stresses =
      values("Friction/Slip stress", parameters.friction.slip_stress);
    const auto directions =
      values("Friction/First direction", parameters.friction.first_direction);
    const double size = body.diameter();

    std::vector<ContactBoundary> boundaries;
    std::set<types::boundary_id> ids;
    std::set<std::pair<types::boundary_id, types::boundary_id>> pairs;
    for (std::size_t b = 0; b < names.size(); ++b)
      {
        ContactBoundary boundary;
        boundary.source_ = std::make_shared<const ParameterFile>(file.of_pair(b));
        const ParameterFile &source = *boundary.source_;
        const auto vector = [&](const std::string &of, const std::string &text) {
          const auto numbers = read_numbers(text, 3, source.locate(of), time);
          return Tensor<1, 3>({numbers[0], numbers[1], numbers[2]});
        };
        boundary.id_   = body.boundary_names().id(names[b], source.locate(entry));
        boundary.name_ = body.boundary_names().name(boundary.id_);
        boundary.size_ = size;
        if (paired_boundary(obstacles[b]).empty() && !ids.insert(boundary.id_).second)
          throw InputError(source.describe(entry) + ", boundary " + names[b] +
                           " stands twice, must stand once.");

        const std::string partner = paired_boundary(obstacles[b]);
        boundary.slave_side_      = sides[b];
        boundary.mesh_gap_        = mesh_gaps[b];
        if (partner.empty())
          {
            std::string obstacle;
            throw_on_all_ranks(body.communicator(), [&]() { // their files may differ
              obstacle = with_path(obstacles[b], source);
            });
            boundary.obstacle_ = Obstacle::read(obstacle, source.locate(obstacle_entry),
                                                size, time, body.communicator());
          }
        boundary.gap_ =
          std::make_unique<ParsedFunction>(gaps[b], 1, source.locate(gap_entry), time);
        const FrictionLaw law = laws.size() == 1 ? laws.front() : laws[b];
        boundary.friction_    = std::make_unique<FrictionData>(
          law, coefficients[b], slip_stresses[b], directions[b], source, time);
        boundary.displacement_ = vector(displacement_entry, displacements[b]);
        boundary.force_        = vector(force_entry, forces[b]);
        boundary.set_rotation(
          read_numbers(rotations[b], 7, source.locate(rotation_entry), time));
        const std::string angle = rotations[b].substr(rotations[b].rfind(';') + 1);
        boundary.description_ =
          obstacles[b] + (gaps[b] == "0" ? "" : ", gap " + gaps[b]) +
          (are_zero(displacements[b]) ? "" : ", displaced " + displacements[b]) +
          (are_zero(angle) ? "" : ", turned " + rotations[b]) +
          (are_zero(forces[b]) ? "" : ", pressed on by " + forces[b]) +
          describe_friction(law, coefficients[b], slip_stresses[b], directions[b]);
        if (boundary.is_tied() && partner.empty())
          throw InputError(source.describe("Friction/Law") + ", boundary '" +
                           boundary.name_ +
                           "' can only be tied to another boundary of the mesh, say "
                           "'Obstacle = boundary : NAME', or hold it with 'Boundary "
                           "conditions/Prescribed displacement'.");
        if (boundary.is_tied() && !are_zero(gaps[b]))
          throw InputError(source.describe(gap_entry) + ", must be 0 for boundary '" +
                           boundary.name_ +
                           "', which is tied to what it is paired with as both are "
                           "meshed.");
        if (!partner.empty())
          {
            boundary.pair_with(partner, body);
            if (!pairs.insert(std::minmax(boundary.id_, boundary.partner_)).second)
              throw InputError(source.describe(obstacle_entry) + ", the boundaries '" +
                               boundary.name_ + "' and '" + boundary.partner_name_ +
                               "' are a pair already, must be one once.");
          }
        boundaries.push_back(std::move(boundary));
      }
    return boundaries;
  }

  void ContactBoundary::pair_with(const std::string &other, const Body &body)
  {
    partner_      = body.boundary_names().id(other, source_->locate(obstacle_entry));
    partner_name_ = body.boundary_names().name(partner_);
    if (partner_ == id_)
      throw InputError(source_->describe(obstacle_entry) + ", boundary '" + name_ +
                       "' cannot touch itself, must be another one.");
    const auto require_one_of = [&](const std::string &entry, const std::string &value,
                                    const std::vector<std::string> &allowed) {
      if (std::count(allowed.begin(), allowed.end(), value) == 0)
        throw InputError(source_->describe(entry) + ", '" + value + "' must be one of " +
                         listed(allowed) + did_you_mean(value, allowed) + ".");
    };
    require_one_of(slave_entry, slave_side_, {"automatic", "boundary", "obstacle"});
    require_one_of(mesh_gap_entry, mesh_gap_, {"kept", "removed"});
    const std::string reason =
      ", must be zero for the pair of boundary '" + name_ +
      "', whose sides move with their bodies, as loads and supports have it.";
    if (displacement_.norm() > 0.)
      throw InputError(source_->describe(displacement_entry) + reason);
    if (angle_ != 0.)
      throw InputError(source_->describe(rotation_entry) + reason);
    if (force_.norm() > 0.)
      throw InputError(source_->describe(force_entry) + reason);
  }

  bool ContactBoundary::is_tied() const
  {
    return friction_->law() == FrictionLaw::tied;
  }

  void ContactBoundary::take_side(const bool is_slave, const std::string &reason)
  {
    if (!is_slave)
      {
        std::swap(id_, partner_);
        std::swap(name_, partner_name_);
      }
    const std::string said = description_.substr(0, description_.find("; forces on "));
    description_ =
      "boundary " + partner_name_ + said.substr(std::min(said.find(','), said.size())) +
      (keeps_mesh_gap() || is_tied() ? "" : ", distance of the meshes removed") +
      "; forces on " + name_ + ", " + reason;
  }

  void ContactBoundary::set_rotation(const std::vector<double> &numbers)
  {
    const Tensor<1, 3> axis({numbers[3], numbers[4], numbers[5]});
    angle_ = numbers[6];
    if (axis.norm() > 1e-30)
      axis_ = axis / axis.norm();
    else if (angle_ != 0.)
      throw InputError(source_->describe(rotation_entry) +
                       ", its axis must not be zero.");
    axis_point_ = Point<3>(numbers[0], numbers[1], numbers[2]);
  }

  Tensor<1, 3> ContactBoundary::arm(const Point<3> &x, const Tensor<1, 3> &n) const
  {
    const Tensor<1, 3> arm = cross_product_3d(axis_, x - axis_point_);
    if (angle_ != 0. &&
        !(std::abs(n * arm) <= sine_of_round * arm.norm() + rounding * size_))
      throw InputError(source_->describe(rotation_entry) +
                       ", turns the obstacle of boundary '" + name_ +
                       "' about an axis about which it is not round at " + text_of(x) +
                       ", must turn it about an axis of revolution.");
    return arm;
  }

  bool ContactBoundary::place(ContactNode &node) const
  {
    node.gap = gap_->value(node.position);
    if (!obstacle_)
      return true;

    const auto refuse = [&](const std::string &reason) {
      throw InputError(source_->describe(obstacle_entry) + ", " + reason + ".");
    };
    const Obstacle::Value value = obstacle_->at(node.position);
    const double slope          = value.gradient.norm();
    // a formula's differences leave rounding where there is no slope
    if (!(slope > 0.) || slope * size_ < 1e-8 * std::abs(value.psi))
      refuse("has no normal for the contact node at " + text_of(node.position) +
             ", the gradient of the distance must not vanish there");

    node.gap += value.psi / slope;
    if (node.gap < -size_)
      refuse("is deeper in the body at " + text_of(node.position) +
             " than the body is large, must be outside but for a small "
             "interference");
    const Tensor<1, 3> towards_obstacle = value.gradient / -slope;
    const bool is_facing                = towards_obstacle * node.normal >= facing_cosine;
    node.normal                         = towards_obstacle;
    return is_facing;
  }

  void ContactBoundary::require_outside(const ContactNode &node) const
  {
    if (node.gap < -rounding * size_)
      throw InputError(source_->describe(obstacle_entry) +
                       ", contains the contact node at " + text_of(node.position) +
                       ", which faces away from its surface there, must face the "
                       "boundary '" +
                       name_ + "' wherever it is inside the body.");
  }

  double ContactBoundary::initial_gap(const Point<3> &p) const
  {
    return gap_->value(p);
  }

  double ContactBoundary::penetration(const Point<3> &p) const
  {
    if (!obstacle_)
      return 0.;
    const Obstacle::Value value = obstacle_->at(p);
    const double slope          = value.gradient.norm();
    return value.psi < 0. && slope > 0. ? -value.psi / slope : 0.;
  }
} // namespace stiction
