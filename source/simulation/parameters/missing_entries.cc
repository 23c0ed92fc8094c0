#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/mesh_names.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/simulation/parameters/missing_entries.h>
#include <stiction/simulation/parameters/parameters.h>

#include <algorithm>

namespace stiction
{
  namespace
  {
    const std::string conditions = "Boundary conditions";

    // What is missing, section by section: what it is and the line to write.
    class MissingEntries
    {
    public:
      void add(const std::string &section, const std::string &what,
               const std::string &line)
      {
        if (section != section_)
          text_ += (text_.empty() ? "" : "; ") + ("in '" + section + "' ");
        else
          text_ += ", ";
        section_ = section;
        text_ += what + ", 'set " + line + "'";
      }

      void refuse_if_any(const Parameters &parameters, const MeshNames &boundaries) const
      {
        if (text_.empty())
          return;
        std::string names;
        for (const auto id : boundaries.ids())
          names += (names.empty() ? "; the boundaries of the body are " : ", ") +
                   boundaries.describe(id);
        if (text_.find(conditions) == std::string::npos)
          names.clear();
        throw InputError(parameters.source.file() +
                         ": the problem is not complete, these lines or their "
                         "like are missing: " +
                         text_ + names + ".");
      }

    private:
      std::string section_, text_;
    };

    // Numbers that stand for steel and for what it bears, in the file's units.
    struct Examples
    {
      std::string traction, slip_stress, youngs_modulus, density;
    };

    Examples examples_in(const std::string &units)
    {
      if (units == "mm, N, MPa")
        return {"-1", "10", "2.1e5", "7.85e-9"};
      return {"-1e6", "1e7", "2.1e11", "7850"};
    }

    void add_load(MissingEntries &missing, const MeshNames &boundaries,
                  const Examples &examples)
    {
      missing.add(conditions, "a load",
                  "Traction = " + boundaries.name(*boundaries.ids().rbegin()) +
                    " : 0; 0; " + examples.traction);
    }

    // Whether there may be interference, which only the gaps can tell.
    bool may_interfere(const ContactPairParameters &contact)
    {
      return contact.initial_gap != "0" || contact.obstacle != "foundation";
    }

    // The section of the first contact boundary of a law that has no value for it, empty
    // if there is none; lists must have all of theirs.
    std::string section_without(const Parameters &parameters, const FrictionLaw law,
                                const std::string &values)
    {
      const auto laws = parameters.friction.laws();
      const auto all  = split_at_bars(values);
      for (std::size_t k = 0; k < laws.size(); ++k)
        {
          const std::string section =
            parameters.source.section_of_pair("Friction/Law", k);
          const bool has_own = section != "Friction" && all.size() == laws.size();
          if (laws[k] == law && (has_own ? all[k] : values).empty())
            return section;
        }
      return "";
    }
  } // namespace

  void require_complete(const Parameters &parameters, const MeshNames &boundaries)
  {
    const BoundaryParameters &boundary = parameters.boundary;
    const FrictionParameters &friction = parameters.friction;
    const MaterialParameters &material = parameters.material;
    const Examples examples            = examples_in(parameters.output.units);
    MissingEntries missing;

    if (!boundary.has_load() && !parameters.contact.has_load() &&
        !may_interfere(parameters.contact))
      add_load(missing, boundaries, examples);
    if (parameters.contact.contact_boundary.empty())
      missing.add(conditions, "where there may be contact",
                  "Contact boundary = " +
                    boundaries.name(*std::next(
                      boundaries.ids().begin(),
                      static_cast<std::ptrdiff_t>(boundaries.ids().size() / 2))));

    const std::string pair =
      parameters.source.section_of_pair(conditions + "/Contact boundary", 0);
    if (friction.law_name.empty())
      missing.add(pair == conditions ? "Friction" : pair, "a law",
                  std::string("Law = frictionless', 'set Law = given'") +
                    (pair == conditions ? " or 'set Law = coulomb"
                                        : ", 'set Law = coulomb' or 'set Law = tied"));
    const std::string of_coulomb =
      section_without(parameters, FrictionLaw::coulomb, friction.coefficient);
    if (!of_coulomb.empty())
      missing.add(of_coulomb, "the coefficient of Coulomb's law", "Coefficient = 0.3");
    const std::string of_given =
      section_without(parameters, FrictionLaw::given, friction.slip_stress);
    if (!of_given.empty())
      missing.add(of_given, "the slip stress of given friction",
                  "Slip stress = " + examples.slip_stress);

    if (!material.youngs_modulus && material.materials.empty())
      missing.add("Material", "stiffness",
                  "Young's modulus = " + examples.youngs_modulus);
    if (!material.poisson_ratio && material.materials.empty())
      missing.add("Material", "contraction", "Poisson ratio = 0.3");
    if (!material.density && material.densities.empty() && !boundary.gravity.empty())
      missing.add("Material", "the density of which gravity makes weight",
                  "Density = " + examples.density);
    missing.refuse_if_any(parameters, boundaries);
  }

  void require_load(const Parameters &parameters, const MeshNames &boundaries,
                    const ContactSurface &surface)
  {
    if (parameters.boundary.has_load() || parameters.contact.has_load() ||
        (surface.motion().offset_at_start().head(surface.n_nodes()).array() < 0.).any())
      return;
    for (const ContactNode &node : surface.nodes())
      if (const ContactBoundary &pair = surface.boundary_of(node);
          pair.is_pair() && pair.keeps_mesh_gap() && node.own_part == 1. &&
          node.gap < node.mesh_gap)
        pair.source().refuse(
          "Boundary conditions/Initial gap",
          "closes no gap between '" + pair.name() + "' and '" + pair.partner_name() +
            format("', which their meshes have, up to %.3g, must be larger; 'Mesh gap = "
                   "removed' takes away what facets keep round surfaces apart",
                   node.mesh_gap));
    MissingEntries missing;
    add_load(missing, boundaries, examples_in(parameters.output.units));
    missing.refuse_if_any(parameters, boundaries);
  }
} // namespace stiction
