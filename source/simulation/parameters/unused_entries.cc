#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/interface/contact_pair_parameters.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/parameters/unused_entries.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace stiction
{
  std::vector<std::string> unused_entries(const Parameters &parameters)
  {
    const auto laws    = parameters.friction.laws();
    const auto has_law = [&](const FrictionLaw law) {
      return std::count(laws.begin(), laws.end(), law) > 0;
    };
    const bool has_coulomb = has_law(FrictionLaw::coulomb),
               has_given   = has_law(FrictionLaw::given),
               has_pairs   = parameters.contact.has_elastic_pairs(),
               has_gravity = !parameters.boundary.gravity.empty();

    struct Rule
    {
      std::string entry;
      bool is_used;
      std::string reason;
    };
    const std::string rigid       = "all obstacles are rigid",
                      light       = "there is no 'Boundary conditions/Gravity'";
    const std::vector<Rule> rules = {
      {"Friction/Coefficient", has_coulomb, "no 'Law' is 'coulomb'"},
      {"Friction/Slip stress", has_given, "no 'Law' is 'given'"},
      {"Friction/First direction", has_coulomb || has_given, "there is no friction"},
      {"Boundary conditions/Slave side", has_pairs, rigid},
      {"Boundary conditions/Mesh gap", has_pairs, rigid},
      {"Material/Density", has_gravity, light},
      {"Material/Densities", has_gravity, light},
      {"Geometry/Mesh file", parameters.geometry.type == "file",
       "'Geometry/Type' is not 'file'"}};

    std::vector<std::string> unused;
    const auto apply = [&](const ParameterFile &source, const Rule &rule) {
      const auto given = source.given();
      if (const auto entry = given.find(rule.entry);
          !rule.is_used && entry != given.end() &&
          !dealii::Utilities::trim(entry->second).empty())
        unused.push_back(source.locate(rule.entry) + ": " + rule.reason);
    };
    for (const Rule &rule : rules)
      apply(parameters.source, rule);

    // what the law of another pair uses is not used by all
    const auto has_sections = [&](const std::size_t pair) {
      return parameters.source.section_of_pair("Friction/Law", pair) != "Friction";
    };
    for (std::size_t pair = 0; pair < laws.size() && has_sections(pair); ++pair)
      {
        const ParameterFile source = parameters.source.of_pair(pair);
        apply(source,
              {"Friction/Coefficient", !has_coulomb || laws[pair] == FrictionLaw::coulomb,
               "its 'Law' is not 'coulomb'"});
        apply(source,
              {"Friction/Slip stress", !has_given || laws[pair] == FrictionLaw::given,
               "its 'Law' is not 'given'"});
      }
    return unused;
  }
} // namespace stiction
