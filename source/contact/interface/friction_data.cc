#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/qp/sets/feasible_set.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    const char *const direction_entry = "Friction/First direction";

    // The conditions of the scaled problem grow with the square of the ratio
    // of the axes.
    constexpr double largest_ratio = 100.;

    // A smaller value is zero: 0.3 - 0.2 * 1.5 is not in binary numbers.
    constexpr double rounded = 1e-15;

    // Ratios of axes that differ by less are the same but for rounding.
    constexpr double same_ratio = 1e-9;
  } // namespace

  FrictionData::Values::Values(const ParameterFile &source, const std::string &entry,
                               const std::string &expression, const double time)
    : source(source)
    , entry(entry)
  {
    const auto n_formulas = 1 + std::count(expression.begin(), expression.end(), ';');
    source.require(n_formulas <= 2, entry,
                   "must be one formula, or two separated by ';' for the two principal "
                   "directions");
    function = std::make_unique<ParsedFunction>(
      expression, static_cast<unsigned int>(n_formulas), source.locate(entry), time,
      std::vector<std::string>{"pressure", "slip"});
  }

  FrictionData::Values::~Values() = default;

  std::array<double, 2> FrictionData::Values::at(const Point<3> &p,
                                                 const Rubbing &rubbing) const
  {
    const std::vector<double> quantities{rubbing.pressure, rubbing.slip};
    const bool is_one = function->n_components == 1;
    const auto value  = [&](const unsigned int component) {
      const double of_formula = function->value_with(p, quantities, component);
      return std::abs(of_formula) < rounded ? 0. : of_formula;
    };
    const double first = value(0), second = is_one ? first : value(1);

    const auto refuse = [&](const std::string &allowed) {
      source.refuse(
        entry,
        text_of("gives ", first, is_one ? "" : text_of(" and ", second), " at (", p, ')',
                function->time_in_words(),
                function->has_quantities()
                  ? text_of(", pressure = ", rubbing.pressure, ", slip = ", rubbing.slip)
                  : "",
                ", must be ", allowed));
    };
    if (first < 0. || second < 0.)
      refuse(function->has_quantities() ? ">= 0 whatever the pressure and the slip"
                                        : ">= 0 everywhere");
    if ((first == 0.) != (second == 0.))
      refuse("> 0 along both principal directions or 0 along both");
    if (std::max(first, second) > largest_ratio * std::min(first, second))
      refuse("at most 100 times as large along one principal direction as "
             "along the other");
    return {{first, second}};
  }

  FrictionData::FrictionData(const FrictionLaw law, const std::string &coefficient,
                             const std::string &slip_stress,
                             const std::string &first_direction,
                             const ParameterFile &source, const double time)
    : source_(source)
    , law_(law)
  {
    if (law == FrictionLaw::coulomb)
      bound_ =
        std::make_unique<Values>(source, "Friction/Coefficient", coefficient, time);
    if (law == FrictionLaw::given)
      bound_ =
        std::make_unique<Values>(source, "Friction/Slip stress", slip_stress, time);
    if (!Utilities::trim(first_direction).empty())
      first_direction_ = std::make_unique<ParsedFunction>(
        first_direction, 3, source.locate(direction_entry), time);
  }

  FrictionData::~FrictionData() = default;

  bool FrictionData::is_orthotropic() const
  {
    return bound_ && bound_->function->n_components == 2;
  }

  bool FrictionData::depends_on_rubbing() const
  {
    return bound_ && bound_->function->has_quantities();
  }

  double FrictionData::value(const ContactNode &node, const Rubbing &rubbing) const
  {
    ContactNode other = node;
    set(other, rubbing);
    const double value =
      law_ == FrictionLaw::coulomb ? other.coefficient : other.slip_stress;
    for (unsigned int c = 0; c < 2 && value > 0.; ++c) // a disc of radius 0 has no shape
      if (std::abs(other.scale[c] - node.scale[c]) > same_ratio * node.scale[c])
        refuse_ratio();
    return value;
  }

  void FrictionData::refuse_ratio() const
  {
    source_.refuse(bound_->entry, "the two formulas must have the same ratio whatever "
                                  "the pressure and the slip");
  }

  void FrictionData::set(ContactNode &node) const
  {
    set(node, {});
    if (!depends_on_rubbing() || bound_->function->n_components == 1)
      return;
    // the ratio at some pressure and slip, so that most are refused before a run
    const std::vector<double> some{1e-4 * node.youngs_modulus, 1e-4};
    const auto at_rest  = bound_->at(node.position, {});
    const double first  = bound_->function->value_with(node.position, some, 0),
                 second = bound_->function->value_with(node.position, some, 1);
    if (std::abs(first * at_rest[1] - second * at_rest[0]) >
        same_ratio * std::abs(first) * at_rest[1])
      refuse_ratio();
  }

  void FrictionData::set(ContactNode &node, const Rubbing &rubbing) const
  {
    if (law_ == FrictionLaw::tied)
      node.slip_stress = qp::tied;
    if (!bound_)
      return;
    const bool is_coulomb = law_ == FrictionLaw::coulomb;
    const auto values     = bound_->at(node.position, rubbing);

    std::optional<Tensor<1, 3>> direction;
    if (first_direction_)
      {
        direction.emplace();
        for (unsigned int c = 0; c < 3; ++c)
          (*direction)[c] = first_direction_->value(node.position, c);
      }
    const std::optional<double> radius =
      set_friction_ellipse(node, values[0], values[1], direction);
    if (!radius)
      source_.refuse(direction_entry,
                     text_of("gives (", *direction, ") at (", node.position,
                             "), must have a part tangential to the contact boundary "
                             "everywhere"));
    (is_coulomb ? node.coefficient : node.slip_stress) = *radius;
  }
} // namespace stiction
