#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/did_you_mean.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/numbers.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/kernels/cell_stiffness.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/body_parameters.h>
#include <stiction/elasticity/model/boundary_parameters.h>
#include <stiction/elasticity/model/material_parameters.h>
#include <stiction/elasticity/model/materials.h>

#include <deal.II/base/utilities.h>
#include <deal.II/physics/transformations.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <stdexcept>
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

    double largest(const std::map<material_id, Material> &materials,
                   double Material::*const modulus)
    {
      double value = 0.;
      for (const auto &material : materials)
        value = std::max(value, material.second.*modulus);
      return value;
    }

    // One entry of the form 'material : words | material : words ...'.
    class MaterialList
    {
    public:
      MaterialList(const BodyParameters &parameters, const std::string &entry,
                   const std::string &value, std::string form)
        : location_(parameters.source.describe(entry))
        , form_(std::move(form))
        , parts_(trim(value).empty() ? std::vector<std::string>()
                                     : split_string_list(value, '|'))
      {
      }

      // Calls back with the id and the words of each.
      template<typename Callback>
      void for_each(const Body &body, const Callback &callback) const
      {
        std::set<material_id> seen;
        for (const std::string &part : parts_)
          {
            const auto [name, rest] = split_at_colon(part);
            if (!rest || name.empty())
              refuse("must read " + form_ + ", several separated by '|'");
            const material_id id = body.material_names().id(name, location_);
            if (!seen.insert(id).second)
              refuse("material " + name + " stands twice, must stand once");
            std::vector<std::string> words = split_string_list(*rest, ';');
            for (std::string &word : words)
              word = trim(word); // tabs
            callback(id, name, words);
          }
      }

      double number(const std::string &word) const
      {
        char *end          = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (word.empty() || *end != '\0' || word.find_first_of("xX") != std::string::npos)
          refuse("'" + word + "' is not a number, must read " + form_ +
                 ", several separated by '|'");
        return value;
      }

      [[noreturn]] void refuse(const std::string &reason) const
      {
        throw InputError(location_ + ", " + reason + ".");
      }

      const std::string &form() const { return form_; }

    private:
      const std::string location_, form_;
      const std::vector<std::string> parts_;
    };

    Material read_isotropic(const MaterialList &list, const std::string &name,
                            const std::vector<std::string> &words)
    {
      const double E  = list.number(words[1]);
      const double nu = list.number(words[2]);
      if (!is_sane(E))
        list.refuse("Young's modulus of material " + name + " is " + words[1] +
                    ", must be " + sane_number);
      if (!(nu > -1. && nu < 0.5))
        list.refuse("Poisson's ratio of material " + name + " is " + words[2] +
                    ", must be above -1 and below 0.5");
      return Material::isotropic(E, nu);
    }

    // Of the directions of axis 1 and, in a plane with it, axis 2.
    dealii::Tensor<2, 3> axes_along(const MaterialList &list, const std::string &name,
                                    const std::vector<std::string> &words)
    {
      dealii::Tensor<2, 3> axes; // by rows
      for (unsigned int i = 0; i < 6; ++i)
        axes[i / 3][i % 3] = list.number(words[i + 10]);
      const double least = 1e-6; // of a sine: directions of a file have some digits
      axes[0] /= axes[0].norm();
      axes[2] = cross_product_3d(axes[0], axes[1] / axes[1].norm());
      if (!(axes[2].norm() > least))
        list.refuse("the axes of material " + name +
                    " must have two directions, neither zero nor along each other");
      axes[2] /= axes[2].norm();
      axes[1] = cross_product_3d(axes[2], axes[0]);
      return transpose(axes);
    }

    Material read_orthotropic(const MaterialList &list, const std::string &name,
                              const std::vector<std::string> &words)
    {
      std::array<double, 9> numbers{};
      for (unsigned int i = 0; i < 9; ++i)
        {
          numbers[i] = list.number(words[i + 1]);
          if ((i < 3 || i >= 6) && !is_sane(numbers[i]))
            list.refuse("a modulus of material " + name + " is " + words[i + 1] +
                        ", must be " + sane_number);
        }
      try
        {
          return words.size() == 10
                   ? Material::orthotropic(numbers)
                   : Material::orthotropic(numbers, axes_along(list, name, words));
        }
      catch (const std::domain_error &)
        {
          list.refuse("material " + name +
                      " would give energy when strained, nu12^2 E2/E1, nu13^2 "
                      "E3/E1, nu23^2 E3/E2 and their sum with 2 nu12 nu13 nu23 "
                      "E3/E1 must be below 1");
        }
    }

    Material read_material(const MaterialList &list, const std::string &name,
                           const std::vector<std::string> &words)
    {
      if (words.size() == 3 && words[0] == "isotropic")
        return read_isotropic(list, name, words);
      if ((words.size() == 10 || words.size() == 16) && words[0] == "orthotropic")
        return read_orthotropic(list, name, words);
      list.refuse("material " + name + " must read " + list.form() +
                  did_you_mean(words[0], {"isotropic", "orthotropic"}));
    }

    // With means of the volume strain, and Poisson's ratio above 0.4.
    bool is_nearly_incompressible(const Material &material)
    {
      return material.is_isotropic && material.mean_dilatation &&
             material.lame_lambda > 4. * material.shear_modulus;
    }
  } // namespace

  Material Material::isotropic(const double E, const double nu)
  {
    Material material;
    material.is_isotropic   = true;
    material.lame_lambda    = E * nu / ((1. + nu) * (1. - 2. * nu));
    material.shear_modulus  = E / (2. * (1. + nu));
    material.youngs_modulus = E;

    const auto unit    = dealii::unit_symmetric_tensor<3>();
    material.stiffness = material.lame_lambda * outer_product(unit, unit) +
                         2. * material.shear_modulus * dealii::identity_tensor<3>();
    return material;
  }

  Material Material::orthotropic(const std::array<double, 9> &E1_to_G23,
                                 const dealii::Tensor<2, 3> &axes)
  {
    const double *const E  = E1_to_G23.data();
    const double *const nu = &E1_to_G23[3];
    const double *const G  = &E1_to_G23[6];

    // the compliance of the normal strains, without units: times √(E_a E_b)
    Eigen::Matrix3d compliance = Eigen::Matrix3d::Identity();
    Eigen::Vector3d root;
    unsigned int pair = 0; // 12, 13, 23
    for (unsigned int a = 0; a < 3; ++a)
      {
        root(a) = std::sqrt(E[a]);
        for (unsigned int b = a + 1; b < 3; ++b, ++pair)
          compliance(a, b) = compliance(b, a) = -nu[pair] * std::sqrt(E[b] / E[a]);
      }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(compliance);
    if (!(eigen.eigenvalues()(0) > 1e-10))
      throw std::domain_error("the stiffness is not positive definite");
    const Eigen::Matrix3d normal =
      root.asDiagonal() * compliance.inverse() * root.asDiagonal();

    Material material;
    material.is_isotropic   = false;
    material.lame_lambda    = 0.;
    material.shear_modulus  = std::max({G[0], G[1], G[2]});
    material.youngs_modulus = std::max({E[0], E[1], E[2]});
    pair                    = 0;
    for (unsigned int a = 0; a < 3; ++a)
      {
        material.stiffness[a][a][a][a] = normal(a, a);
        for (unsigned int b = a + 1; b < 3; ++b, ++pair)
          {
            material.stiffness[a][a][b][b] = normal(a, b);
            material.stiffness[b][b][a][a] = normal(a, b);
            material.stiffness[a][b][a][b] = G[pair];
          }
      }
    material.stiffness =
      dealii::Physics::Transformations::basis_transformation(material.stiffness, axes);
    return material;
  }

  dealii::SymmetricTensor<2, 3> Material::stress(
    const dealii::SymmetricTensor<2, 3> &strain) const
  {
    if (is_isotropic)
      return lame_lambda * trace(strain) * dealii::unit_symmetric_tensor<3, double>() +
             2. * shear_modulus * strain;
    return stiffness * strain;
  }

  Materials::Materials(const Body &body, const BodyParameters &parameters)
    : have_mean_dilatation_(parameters.material.has_mean_dilatation())
  {
    const MaterialParameters &common = parameters.material;
    const std::set<material_id> ids(body.material_names().ids().begin(),
                                    body.material_names().ids().end());
    std::set<material_id> without_stiffness = ids, without_density = ids;
    if (common.youngs_modulus && common.poisson_ratio)
      {
        for (const material_id id : ids)
          by_id_[id] = Material::isotropic(*common.youngs_modulus, *common.poisson_ratio);
        without_stiffness.clear();
      }

    const MaterialList materials(parameters, "Material/Materials",
                                 parameters.material.materials,
                                 "'material : isotropic; E; nu' or 'material : "
                                 "orthotropic; E1; E2; E3; nu12; nu13; nu23; "
                                 "G12; G13; G23' with, if not x and y, the directions "
                                 "of the axes 1 and 2, three numbers each");
    materials.for_each(
      body, [&](const material_id id, const std::string &name, const auto &words) {
        by_id_[id] = read_material(materials, name, words);
        without_stiffness.erase(id);
      });
    const auto require_all = [&](const std::set<material_id> &without,
                                 const std::string &entry, const std::string &list,
                                 const std::string &line) {
      if (!without.empty())
        throw InputError(parameters.source.describe_missing(entry) + ", and '" + list +
                         "' says nothing of material " +
                         body.material_names().describe(*without.begin()) +
                         ", write into the section 'Material' " + line +
                         ", or the material into '" + list + "'.");
    };
    require_all(without_stiffness,
                common.youngs_modulus ? "Material/Poisson ratio"
                                      : "Material/Young's modulus",
                "Materials",
                "such as 'set Young's modulus = 2.1e11' and 'set Poisson ratio = 0.3'");
    if (common.density)
      {
        for (auto &material : by_id_)
          material.second.density = *common.density;
        without_density.clear();
      }

    for (auto &material : by_id_)
      material.second.mean_dilatation = have_mean_dilatation_;

    const MaterialList densities(parameters, "Material/Densities",
                                 parameters.material.densities, "'material : density'");
    densities.for_each(
      body, [&](const material_id id, const std::string &name, const auto &words) {
        if (words.size() != 1)
          densities.refuse("material " + name + " must read " + densities.form());
        const double density = densities.number(words[0]);
        if (density != 0. && !is_sane(density))
          densities.refuse("the density of material " + name + " is " + words[0] +
                           ", must be 0 or " + sane_number);
        by_id_.at(id).density = density;
        without_density.erase(id);
      });
    if (!parameters.boundary.gravity.empty())
      require_all(without_density, "Material/Density", "Densities",
                  "such as 'set Density = 7850', of which 'Boundary "
                  "conditions/Gravity' makes weight");
  }

  Materials Materials::softened() const
  {
    Materials soft = *this;
    for (auto &[id, material] : soft.by_id_)
      if (is_nearly_incompressible(material))
        {
          constexpr double nu  = 0.3;
          const double density = material.density;
          material = Material::isotropic(2. * (1. + nu) * material.shear_modulus, nu);
          material.mean_dilatation = true;
          material.density         = density;
        }
    return soft;
  }

  Materials Materials::without_mean_dilatation() const
  {
    Materials simple = *this;
    for (auto &[id, material] : simple.by_id_)
      material.mean_dilatation = false;
    simple.have_mean_dilatation_ = false;
    return simple;
  }

  bool Materials::are_nearly_incompressible() const
  {
    return std::any_of(by_id_.begin(), by_id_.end(), [](const auto &entry) {
      return is_nearly_incompressible(entry.second);
    });
  }

  bool Materials::are_simple() const
  {
    return std::all_of(by_id_.begin(), by_id_.end(),
                       [](const auto &entry) { return entry.second.is_simple(); });
  }

  void Materials::assign(HexahedralCell &cell, const double unit) const
  {
    cell.material      = &of(cell.material_id);
    cell.lame_lambda   = cell.material->lame_lambda / unit;
    cell.shear_modulus = cell.material->shear_modulus / unit;
    cell.unit          = unit;
  }

  double Materials::smallest_youngs_modulus() const
  {
    return std::min_element(by_id_.begin(), by_id_.end(),
                            [](const auto &a, const auto &b) {
                              return a.second.youngs_modulus < b.second.youngs_modulus;
                            })
      ->second.youngs_modulus;
  }

  double Materials::largest_youngs_modulus() const
  {
    return largest(by_id_, &Material::youngs_modulus);
  }

  double Materials::largest_shear_modulus() const
  {
    return largest(by_id_, &Material::shear_modulus);
  }

  void assign_material_ids(Body &body, const BodyParameters &parameters)
  {
    if (trim(parameters.material.material_ids).empty())
      return;
    const std::string entry = "Material/Material ids";
    const ParsedFunction formula(parameters.material.material_ids, 1,
                                 parameters.source.locate(entry), parameters.time);
    formula.require_no_time();
    // every rank knows the coarse mesh
    body.set_material_ids([&](const dealii::Point<3> &centre) {
      const double id = formula.value(centre);
      if (!(id >= 0. && id <= 1000. && id == std::floor(id)))
        parameters.source.refuse(entry, text_of("gives ", id, " at (", centre,
                                                "), must be an integer from 0 to 1000"));
      return static_cast<material_id>(id);
    });
  }
} // namespace stiction
