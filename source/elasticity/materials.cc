#include <stiction/elasticity/body.h>
#include <stiction/elasticity/boundary_functions.h>
#include <stiction/elasticity/cell_stiffness.h>
#include <stiction/elasticity/materials.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    using dealii::types::material_id;
    using dealii::Utilities::split_string_list;
    using dealii::Utilities::trim;

    bool
    is_sane(const double value)
    {
      return value >= 1e-30 && value <= 1e30;
    }

    // One entry of the form 'material : words | material : words ...'.
    class MaterialList
    {
    public:
      MaterialList(const Parameters &parameters,
                   const std::string &entry,
                   const std::string &value,
                   std::string form)
        : location_(parameters.source.describe(entry))
        , form_(std::move(form))
        , parts_(trim(value).empty() ? std::vector<std::string>()
                                     : split_string_list(value, '|'))
      {
      }

      // Calls back with the id and the words of each.
      template<typename Callback>
      void
      for_each(const Body &body, const Callback &callback) const
      {
        std::vector<material_id> seen;
        for (const std::string &part : parts_)
          {
            const std::size_t colon = part.find(':');
            const std::string name  = trim(part.substr(0, colon));
            if (colon == std::string::npos || name.empty())
              refuse("must read " + form_ + ", several separated by '|'");
            const material_id id = body.material_names().id(name, location_);
            if (std::find(seen.begin(), seen.end(), id) != seen.end())
              refuse("material " + name + " stands twice, must stand once");
            seen.push_back(id);
            std::vector<std::string> words =
              split_string_list(part.substr(colon + 1), ';');
            for (std::string &word : words)
              word = trim(word);
            callback(id, name, words);
          }
      }

      double
      number(const std::string &word) const
      {
        char *end          = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (word.empty() || *end != '\0' ||
            word.find_first_of("xX") != std::string::npos)
          refuse("'" + word + "' is not a number, must read " + form_ +
                 ", several separated by '|'");
        return value;
      }

      [[noreturn]] void
      refuse(const std::string &reason) const
      {
        throw InputError(location_ + ", " + reason + ".");
      }

      const std::string &
      form() const
      {
        return form_;
      }

    private:
      const std::string location_, form_;
      const std::vector<std::string> parts_;
    };

    Material
    read_material(const MaterialList &list,
                  const std::string &name,
                  const std::vector<std::string> &words,
                  const double density)
    {
      if (words.size() != 3 || words[0] != "isotropic")
        list.refuse("material " + name + " must read " + list.form());
      const double E  = list.number(words[1]);
      const double nu = list.number(words[2]);
      if (!is_sane(E))
        list.refuse("Young's modulus of material " + name + " is " + words[1] +
                    ", must be a number > 0 Pa, from 1e-30 to 1e30");
      if (!(nu > -1. && nu < 0.5))
        list.refuse("Poisson's ratio of material " + name + " is " + words[2] +
                    ", must be above -1 and below 0.5");
      return Material(E, nu, density);
    }
  } // namespace



  Material::Material(const double youngs_modulus,
                     const double poisson_ratio,
                     const double density)
    : youngs_modulus(youngs_modulus)
    , lame_lambda(youngs_modulus * poisson_ratio /
                  ((1. + poisson_ratio) * (1. - 2. * poisson_ratio)))
    , shear_modulus(youngs_modulus / (2. * (1. + poisson_ratio)))
    , density(density)
  {
  }



  dealii::SymmetricTensor<2, 3>
  Material::stress(const dealii::SymmetricTensor<2, 3> &strain) const
  {
    return lame_lambda * trace(strain) *
             dealii::unit_symmetric_tensor<3, double>() +
           2. * shear_modulus * strain;
  }



  Materials::Materials(const Body &body, const Parameters &parameters)
  {
    const Material common(parameters.material.youngs_modulus,
                          parameters.material.poisson_ratio,
                          parameters.material.density);
    for (const material_id id : body.material_names().ids())
      by_id_.emplace(id, common);

    const MaterialList materials(parameters,
                                 "Material/Materials",
                                 parameters.material.materials,
                                 "'material : isotropic; E; nu'");
    materials.for_each(
      body,
      [&](const material_id id, const std::string &name, const auto &words) {
        by_id_.at(id) = read_material(materials, name, words, common.density);
      });

    const MaterialList densities(parameters,
                                 "Material/Densities",
                                 parameters.material.densities,
                                 "'material : density'");
    densities.for_each(
      body,
      [&](const material_id id, const std::string &name, const auto &words) {
        if (words.size() != 1)
          densities.refuse("material " + name + " must read " +
                           densities.form());
        const double density = densities.number(words[0]);
        if (density != 0. && !is_sane(density))
          densities.refuse("the density of material " + name + " is " +
                           words[0] +
                           ", must be 0 or a number > 0 kg/m^3, from 1e-30 to "
                           "1e30");
        by_id_.at(id).density = density;
      });
  }



  void
  Materials::assign(HexahedralCell &cell, const double unit) const
  {
    const Material &material = of(cell.material_id);
    cell.lame_lambda         = material.lame_lambda / unit;
    cell.shear_modulus       = material.shear_modulus / unit;
  }



  double
  Materials::largest_youngs_modulus() const
  {
    double largest = 0.;
    for (const auto &material : by_id_)
      largest = std::max(largest, material.second.youngs_modulus);
    return largest;
  }



  double
  Materials::largest_shear_modulus() const
  {
    double largest = 0.;
    for (const auto &material : by_id_)
      largest = std::max(largest, material.second.shear_modulus);
    return largest;
  }



  void
  assign_material_ids(Body &body, const Parameters &parameters)
  {
    if (trim(parameters.material.material_ids).empty())
      return;
    const std::string entry = "Material/Material ids";
    const ParsedFunction formula(parameters.material.material_ids,
                                 1,
                                 parameters.source.locate(entry),
                                 parameters.boundary.time);
    // every rank knows the coarse mesh
    body.set_material_ids([&](const dealii::Point<3> &centre) {
      const double id = formula.value(centre);
      if (!(id >= 0. && id <= 1000. && id == std::floor(id)))
        {
          std::ostringstream message;
          message << parameters.source.describe(entry) << ", gives " << id
                  << " at (" << centre
                  << "), must be an integer from 0 to 1000.";
          throw InputError(message.str());
        }
      return static_cast<material_id>(id);
    });
  }
} // namespace stiction
