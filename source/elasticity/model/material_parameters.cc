#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/numbers.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/placed_body.h>
#include <stiction/elasticity/model/material_parameters.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <sstream>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  MaterialParameters::MaterialParameters()
    : ParameterAcceptor("Material")
  {
    add_number(*this, "Young's modulus", youngs_modulus,
               "E of the isotropic linear elastic body, > 0; must be said "
               "unless 'Materials' says what all cells are made of. Unit: of stress. "
               "The steel of the reference brick has 2.119e11.");
    add_number(*this, "Poisson ratio", poisson_ratio,
               "nu, above -1 and below 0.5; must be said with Young's modulus. "
               "Above 0.45 see 'Volume strain'.");
    add_number(*this, "Density", density,
               "Mass density, >= 0, of which 'Boundary conditions/Gravity' makes weight; "
               "must be said with it, here or in 'Densities'. Unit: of mass per volume.");
    add_parameter("Materials", materials,
                  "Materials other than the one above, by the id or name they have in "
                  "the mesh: 'material : isotropic; E; nu' or 'material : orthotropic; "
                  "E1; E2; E3; nu12; nu13; nu23; G12; G13; G23', nu12 being the "
                  "contraction along axis 2 under a pull along axis 1, several separated "
                  "by '|'. The axes 1, 2, 3 are x, y, z, or six more numbers say the "
                  "directions of 1 and 2, '...; G23; 1; 1; 0; -1; 1; 0' has the grain at "
                  "45 degrees between x and y; of the second counts what is across the "
                  "first. Cells of any other material have the numbers above.");
    add_parameter(
      "Volume strain", volume_strain,
      "pointwise: as the displacements have it; elements then lock as nu approaches 0.5, "
      "trilinear bodies and forces become many times too stiff. cell mean: the change of "
      "volume is the same all over a cell (mean dilatation, B-bar), of elements of "
      "degree 2 linear across it, for nearly incompressible materials. automatic: cell "
      "mean if "
      "an isotropic material has nu above 0.45, otherwise pointwise.",
      prm, Patterns::Selection("automatic|pointwise|cell mean"));
    add_parameter("Densities", densities,
                  "Mass densities other than the one above: 'material : "
                  "density', several separated by '|'. Unit: of mass per volume.");
    add_parameter("Material ids", material_ids,
                  "Which material is where, as a formula in x, y, z: its value at the "
                  "centre of a coarse cell, an integer from 0 to 1000, is the material "
                  "id of that cell, 'if(z < 0.5, 0, 1)' makes two layers. Empty: the ids "
                  "that the mesh has; all cells of a brick have 0.");
  }

  void MaterialParameters::add_bodies(
    const std::vector<std::unique_ptr<PlacedBody>> &bodies)
  {
    const auto add = [](std::string &list, const std::string &name,
                        const std::vector<double> &values, const std::string &begin) {
      std::ostringstream text;
      text << std::setprecision(17) << (list.empty() ? "" : " | ") << name << " : "
           << begin;
      for (const double &value : values)
        text << (&value == values.data() ? "" : "; ") << value;
      list += text.str();
    };
    for (const auto &body : bodies)
      {
        if (body->youngs_modulus && body->poisson_ratio)
          add(materials, body->name, {*body->youngs_modulus, *body->poisson_ratio},
              "isotropic; ");
        if (body->density)
          add(densities, body->name, {*body->density}, "");
      }
  }

  double MaterialParameters::largest_poisson_ratio() const
  {
    double largest = poisson_ratio.value_or(-1.);
    // what is not to be read is refused where the materials are made
    for (const std::string &material : split_at_bars(materials))
      {
        const auto words = dealii::Utilities::split_string_list(
          material.substr(material.find(':') + 1), ";"); // none: all of it
        if (words.size() == 3 && words[0] == "isotropic")
          largest = std::max(largest, std::strtod(words[2].c_str(), nullptr));
      }
    return largest;
  }

  bool MaterialParameters::has_mean_dilatation() const
  {
    return volume_strain == "cell mean" ||
           (volume_strain == "automatic" &&
            largest_poisson_ratio() > locking_poisson_ratio);
  }

  void MaterialParameters::check(const ParameterFile &source) const
  {
    require_material(source, "Material/", youngs_modulus, poisson_ratio, density);
  }
} // namespace stiction
