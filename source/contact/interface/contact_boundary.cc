#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/contact_pairs.h>
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

namespace stiction
{
  using namespace dealii;

  namespace
  {
    const std::string boundary_entry     = "Boundary conditions/Contact boundary";
    const std::string obstacle_entry     = "Boundary conditions/Obstacle";
    const std::string displacement_entry = "Boundary conditions/Obstacle displacement";
    const std::string rotation_entry     = "Boundary conditions/Obstacle rotation";
    const std::string slave_entry        = "Boundary conditions/Slave side";
    const std::string gap_entry          = "Boundary conditions/Initial gap";
    const std::string mesh_gap_entry     = "Boundary conditions/Mesh gap";
    const std::string sliding_entry      = "Boundary conditions/Sliding";
    const std::string force_entry        = "Boundary conditions/Obstacle force";

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
      const auto [kind, name] = split_at_colon(obstacle);
      return kind == "file" && name ? "file : " + source.find_file(obstacle_entry, *name)
                                    : obstacle;
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
  } // namespace

  // Of one boundary, as the parameter file has them.
  struct ContactBoundary::Entries
  {
    FrictionLaw law;
    std::string name, obstacle, slave_side, mesh_gap, sliding, gap, displacement,
      rotation, force, coefficient, slip_stress, first_direction;
  };

  ContactBoundary::ContactBoundary(ContactBoundary &&) noexcept = default;
  ContactBoundary::~ContactBoundary()                           = default;

  std::vector<ContactBoundary::Entries> ContactBoundary::entries_of(
    const ContactParameters &parameters)
  {
    const ContactPairParameters &pairs  = parameters.pairs;
    const FrictionParameters &friction  = parameters.friction;
    const auto names                    = split_at_bars(pairs.contact_boundary);
    const std::vector<FrictionLaw> laws = friction.laws();
    std::vector<Entries> all(names.size());
    const auto values = [&](const std::string &entry, const std::string &text) {
      return values_for_each(text, all.size(), parameters.source.describe(entry));
    };
    values("Friction/Law", friction.law_name); // counted only
    for (std::size_t b = 0; b < all.size(); ++b)
      {
        all[b].name = names[b];
        all[b].law  = laws.size() == 1 ? laws.front() : laws[b];
      }
    const auto take = [&](std::string Entries::*member, const std::string &entry,
                          const std::string &text) {
      const auto texts = values(entry, text);
      for (std::size_t b = 0; b < all.size(); ++b)
        all[b].*member = texts[b];
    };
    take(&Entries::obstacle, obstacle_entry, pairs.obstacle);
    take(&Entries::slave_side, slave_entry, pairs.slave_side);
    take(&Entries::mesh_gap, mesh_gap_entry, pairs.mesh_gap);
    take(&Entries::sliding, sliding_entry, pairs.sliding);
    take(&Entries::gap, gap_entry, pairs.initial_gap);
    take(&Entries::displacement, displacement_entry, pairs.obstacle_displacement);
    take(&Entries::rotation, rotation_entry, pairs.obstacle_rotation);
    take(&Entries::force, force_entry, pairs.obstacle_force);
    take(&Entries::coefficient, "Friction/Coefficient", friction.coefficient);
    take(&Entries::slip_stress, "Friction/Slip stress", friction.slip_stress);
    take(&Entries::first_direction, "Friction/First direction", friction.first_direction);
    return all;
  }

  std::vector<ContactBoundary> ContactBoundary::read(const ContactParameters &parameters,
                                                     const Body &body, const double time)
  {
    std::vector<ContactBoundary> boundaries;
    std::set<types::boundary_id> ids;
    std::set<std::pair<types::boundary_id, types::boundary_id>> pairs;
    for (const Entries &entries : entries_of(parameters))
      {
        ContactBoundary boundary(entries, parameters.source.of_pair(boundaries.size()),
                                 body, time);
        boundary.section_name_ = ContactPairs::name_of(
          parameters.source.section_of_pair(boundary_entry, boundaries.size()));
        const ParameterFile &source = *boundary.source_;
        source.require(boundary.is_pair() || ids.insert(boundary.id_).second,
                       boundary_entry,
                       "boundary " + entries.name + " stands twice, must stand once");
        for (const auto partner : boundary.partners_)
          source.require(pairs.insert(std::minmax(boundary.id_, partner)).second,
                         obstacle_entry,
                         "the boundaries '" + boundary.name_ + "' and '" +
                           body.boundary_names().name(partner) +
                           "' are a pair already, must be one once");
        boundaries.push_back(std::move(boundary));
      }
    return boundaries;
  }

  ContactBoundary::ContactBoundary(const Entries &entries, ParameterFile source,
                                   const Body &body, const double time)
    : slave_side_(entries.slave_side)
    , mesh_gap_(entries.mesh_gap)
    , sliding_(entries.sliding)
    , gap_text_(entries.gap)
    , id_(body.boundary_names().id(entries.name, source.locate(boundary_entry)))
    , size_(body.diameter())
    , source_(std::make_shared<const ParameterFile>(std::move(source)))
  {
    name_ = body.boundary_names().name(id_);
    gap_ =
      std::make_unique<ParsedFunction>(entries.gap, 1, source_->locate(gap_entry), time);
    friction_         = std::make_unique<FrictionData>(entries.law, entries.coefficient,
                                               entries.slip_stress,
                                               entries.first_direction, *source_, time);
    const auto vector = [&](const std::string &entry, const std::string &text) {
      const auto numbers = read_numbers(text, 3, source_->locate(entry), time);
      return Tensor<1, 3>({numbers[0], numbers[1], numbers[2]});
    };
    displacement_ = vector(displacement_entry, entries.displacement);
    force_        = vector(force_entry, entries.force);
    set_rotation(
      read_numbers(entries.rotation, 7, source_->locate(rotation_entry), time));
    describe(entries);
    require_one_of(sliding_entry, sliding_, {"little", "far"});
    const auto partners = paired_boundaries(entries.obstacle);
    if (is_tied())
      require_tied_pair(!partners.empty(), entries.gap);
    if (!partners.empty())
      {
        pair_with(partners, body);
        return;
      }
    std::string obstacle;
    throw_on_all_ranks(body.communicator(), [&]() { // their files may differ
      obstacle = with_path(entries.obstacle, *source_);
    });
    obstacle_ = Obstacle::read(obstacle, source_->locate(obstacle_entry), size_, time,
                               body.communicator());
    source_->require(!slides_far() || obstacle_, sliding_entry,
                     "must be little for the foundation of boundary '" + name_ +
                       "', which has no shape but that of the boundary; say what it is, "
                       "such as 'Obstacle = plane : ...'");
  }

  void ContactBoundary::require_one_of(const std::string &entry, const std::string &value,
                                       const std::vector<std::string> &allowed) const
  {
    source_->require(std::count(allowed.begin(), allowed.end(), value) > 0, entry,
                     "'" + value + "' must be one of " + listed(allowed) +
                       did_you_mean(value, allowed));
  }

  void ContactBoundary::describe(const Entries &entries)
  {
    const std::string angle = entries.rotation.substr(entries.rotation.rfind(';') + 1);
    details_ =
      (entries.gap == "0" ? "" : ", gap " + entries.gap) +
      (are_zero(entries.displacement) ? "" : ", displaced " + entries.displacement) +
      (are_zero(angle) ? "" : ", turned " + entries.rotation) +
      (are_zero(entries.force) ? "" : ", pressed on by " + entries.force) +
      describe_friction(entries.law, entries.coefficient, entries.slip_stress,
                        entries.first_direction);
    description_ = entries.obstacle + details_;
  }

  void ContactBoundary::require_tied_pair(const bool has_partners,
                                          const std::string &gap) const
  {
    source_->require(has_partners, "Friction/Law",
                     "boundary '" + name_ +
                       "' can only be tied to another boundary of the mesh, say "
                       "'Obstacle = boundary : NAME', or hold it with 'Boundary "
                       "conditions/Prescribed displacement'");
    source_->require(are_zero(gap), gap_entry,
                     "must be 0 for boundary '" + name_ +
                       "', which is tied to what it is paired with as both are meshed");
  }

  void ContactBoundary::pair_with(const std::vector<std::string> &others,
                                  const Body &body)
  {
    for (const std::string &other : others)
      {
        source_->require(!other.empty(), obstacle_entry,
                         "has a comma too many: names of boundaries stand between them");
        const auto id = body.boundary_names().id(other, source_->locate(obstacle_entry));
        source_->require(id != id_, obstacle_entry,
                         "boundary '" + name_ +
                           "' cannot touch itself, must be another one");
        partner_name_ += (partners_.empty() ? "" : ", ") + body.boundary_names().name(id);
        partners_.push_back(id);
      }
    source_->require(others.size() == 1 || slave_side_ != "obstacle", slave_entry,
                     "of boundary '" + name_ +
                       "', which has several opposite to it, must be automatic or "
                       "boundary; make a pair of each of them");
    require_one_of(slave_entry, slave_side_, {"automatic", "boundary", "obstacle"});
    require_one_of(mesh_gap_entry, mesh_gap_, {"kept", "removed"});
    source_->require(!slides_far(), sliding_entry,
                     "must be little for the pair of boundary '" + name_ +
                       "': what lies opposite is found where bodies are made");
    const std::string allowed =
      "must be zero for the pair of boundary '" + name_ +
      "', whose sides move with their bodies, as loads and supports have it";
    source_->require(displacement_.norm() == 0., displacement_entry, allowed);
    source_->require(angle_ == 0., rotation_entry, allowed);
    source_->require(force_.norm() == 0., force_entry, allowed);
  }

  bool ContactBoundary::has_partner(const types::boundary_id id) const
  {
    return std::count(partners_.begin(), partners_.end(), id) > 0;
  }

  std::set<unsigned int> ContactBoundary::pieces(const Body &body) const
  {
    std::set<unsigned int> all = body.pieces_at(id_);
    for (const auto partner : partners_)
      all.merge(body.pieces_at(partner));
    return all;
  }

  std::string ContactBoundary::title() const
  {
    return (section_name_.empty() ? "" : section_name_ + ": ") + name_ +
           (is_pair() ? " against " + partner_name_ : "");
  }

  bool ContactBoundary::is_tied() const { return friction_->law() == FrictionLaw::tied; }

  void ContactBoundary::take_side(const SlaveSide &side)
  {
    if (side.is_first != side_.is_first)
      {
        std::swap(id_, partners_.front());
        std::swap(name_, partner_name_);
      }
    side_ = side;
    description_ =
      "boundary " + partner_name_ + details_ +
      (keeps_mesh_gap() || is_tied() ? "" : ", distance of the meshes removed") +
      "; forces on " + name_ + ", " + side.reason;
  }

  void ContactBoundary::set_rotation(const std::vector<double> &numbers)
  {
    const Tensor<1, 3> axis({numbers[3], numbers[4], numbers[5]});
    angle_ = numbers[6];
    if (axis.norm() > 1e-30)
      axis_ = axis / axis.norm();
    source_->require(axis_.norm() > 0. || angle_ == 0., rotation_entry,
                     "its axis must not be zero");
    axis_point_ = Point<3>(numbers[0], numbers[1], numbers[2]);
  }

  Tensor<1, 3> ContactBoundary::arm(const Point<3> &x, const Tensor<1, 3> &n) const
  {
    const Tensor<1, 3> arm = cross_product_3d(axis_, x - axis_point_);
    if (angle_ != 0. &&
        !(std::abs(n * arm) <= sine_of_round * arm.norm() + rounding * size_))
      source_->refuse(rotation_entry,
                      "turns the obstacle of boundary '" + name_ +
                        "' about an axis about which it is not round at (" + text_of(x) +
                        "), must turn it about an axis of revolution");
    return arm;
  }

  bool ContactBoundary::place(ContactNode &node) const
  {
    node.gap = gap_->value(node.position);
    if (!obstacle_)
      return true;

    const Obstacle::Value value =
      obstacle_->facing(node.position + node.moved, node.normal);
    const double slope = value.gradient.norm();
    // a formula's differences leave rounding where there is no slope
    if (!(slope > 0.) || slope * size_ < 1e-8 * std::abs(value.psi))
      source_->refuse(obstacle_entry,
                      "has no normal for the contact node at (" + text_of(node.position) +
                        "), the gradient of the distance must not vanish there");

    const double distance = node.gap + value.psi / slope;
    if (distance < -size_)
      source_->refuse(obstacle_entry,
                      "is deeper in the body at (" + text_of(node.position) +
                        ") than the body is large, must be outside but for a small "
                        "interference");
    const Tensor<1, 3> towards_obstacle = value.gradient / -slope;
    const bool is_facing                = towards_obstacle * node.normal >= facing_cosine;
    node.normal                         = towards_obstacle;
    node.gap                            = distance + node.normal * node.moved;
    return is_facing;
  }

  void ContactBoundary::place_if_possible(ContactNode &node) const
  {
    try
      {
        place(node);
      }
    catch (const InputError &)
      {
        node.gap = -size_; // that far inside, or farther
      }
  }

  void ContactBoundary::require_outside(const ContactNode &node) const
  {
    if (node.gap - node.normal * node.moved < -rounding * size_)
      source_->refuse(
        obstacle_entry,
        "contains the contact node at (" + text_of(node.position) +
          "), which faces away from its surface there, must face the boundary '" + name_ +
          "' wherever it is inside the body" +
          (obstacle_->triangles() != nullptr
             ? ", with triangles that go round counterclockwise as seen from outside"
             : ""));
  }

  double ContactBoundary::initial_gap(const Point<3> &p) const { return gap_->value(p); }

  double ContactBoundary::penetration(const Point<3> &p) const
  {
    if (!obstacle_)
      return 0.;
    const Obstacle::Value value = obstacle_->at(p);
    const double slope          = value.gradient.norm();
    return slope > 0. ? std::max(0., -value.psi / slope - std::max(0., gap_->value(p)))
                      : 0.;
  }
} // namespace stiction
