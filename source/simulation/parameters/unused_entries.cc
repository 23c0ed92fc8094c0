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
    const auto apply = [&](const ParameterFile &source, const std::vector<Rule> &all) {
      const auto given = source.given();
      for (const Rule &rule : all)
        if (const auto entry = given.find(rule.entry);
            !rule.is_used && entry != given.end() &&
            !dealii::Utilities::trim(entry->second).empty())
          unused.push_back(source.locate(rule.entry) + ": " + rule.reason);
    };
    apply(parameters.source, rules);

    // what the law of another pair uses is not used by all
    if (parameters.source.section_of_pair("Friction/Law", 0) != "Friction")
      for (std::size_t pair = 0; pair < laws.size(); ++pair)
        apply(
          parameters.source.of_pair(pair),
          {{"Friction/Coefficient", !has_coulomb || laws[pair] == FrictionLaw::coulomb,
            "its 'Law' is not 'coulomb'"},
           {"Friction/Slip stress", !has_given || laws[pair] == FrictionLaw::given,
            "its 'Law' is not 'given'"}});
    return unused;
  }
} // namespace stiction
