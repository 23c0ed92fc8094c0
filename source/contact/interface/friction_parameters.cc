#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/did_you_mean.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/interface/friction_parameters.h>

#include <algorithm>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  FrictionParameters::FrictionParameters()
    : ParameterAcceptor("Friction")
  {
    add_parameter("Law", law_name,
                  "frictionless; given: the tangential traction is at most the slip "
                  "stress, at every node of the contact boundary (Tresca friction); "
                  "coulomb: at most the coefficient times the contact pressure; tied, of "
                  "contact pairs alone: both sides are one body, and neither slip nor "
                  "open from where they are meshed. One for all contact boundaries, or "
                  "one for each, separated by '|'. Must be said.");
    add_parameter("Coefficient", coefficient,
                  "Coefficient F >= 0 of Coulomb's law, a formula in x, y, z, t, "
                  "pressure (contact pressure, unit: of stress) and slip (length of the "
                  "way the point has slipped, the step's included, unit: of length), of "
                  "which it may use all but one of x, y, z if both stand in it, and "
                  "which should not jump at slip = 0, since sticking points slip by "
                  "rounding; must be said with the law. Two formulas, '0.3; 0.1': "
                  "orthotropic friction, F1 along the first and F2 along the second "
                  "principal direction; the tangential force lies in the ellipse with "
                  "these semi-axes times the normal force, slip is along its outward "
                  "normal. Figures of the certificate are then those of the ellipse "
                  "scaled to a disc, of radius F1 (slip_bound in contact.pvtu). One axis "
                  "may be up to 100 times the other.");
    add_parameter("Slip stress", slip_stress,
                  "Slip stress >= 0 of given friction, which must be said with it, a "
                  "formula in x, y, z, t, pressure, slip, "
                  "or two for an ellipse, as for the coefficient. Unit: of stress.");
    add_parameter("First direction", first_direction,
                  "The first principal direction of orthotropic friction, a vector of "
                  "three formulas in x, y, z, t separated by ';': its part tangential to "
                  "the contact boundary counts, which must not vanish. The second one is "
                  "at right angles to it. Empty: the tangential part of the x-axis, of "
                  "the y-axis where the normal is within 26 degrees of the x-axis. At a "
                  "node that is held in one tangential direction ('free' in 'Prescribed "
                  "displacement'), friction acts along the other one, up to where the "
                  "ellipse ends there.");
  }

  std::vector<FrictionLaw> FrictionParameters::laws() const
  {
    std::vector<FrictionLaw> laws;
    for (const std::string &law : split_at_bars(law_name))
      laws.push_back(law == "given"     ? FrictionLaw::given
                     : law == "coulomb" ? FrictionLaw::coulomb
                     : law == "tied"    ? FrictionLaw::tied
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

  void FrictionParameters::check(const ParameterFile &source) const
  {
    const std::vector<std::string> allowed = {"frictionless", "given", "coulomb", "tied"};
    std::size_t number                     = 0;
    for (const std::string &law : split_at_bars(law_name))
      source.of_pair(number++).require(
        law_name.empty() || std::count(allowed.begin(), allowed.end(), law) > 0,
        "Friction/Law",
        "each law must be 'frictionless', 'given', 'coulomb' or 'tied'" +
          did_you_mean(law, allowed));
  }
} // namespace stiction
