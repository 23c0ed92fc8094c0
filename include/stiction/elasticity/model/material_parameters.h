#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stiction
{
  class ParameterFile;
  struct PlacedBody;

  /// The section 'Material'.
  struct MaterialParameters : dealii::ParameterAcceptor
  {
    MaterialParameters();

    /// Adds the materials that the sections of bodies say.
    void add_bodies(const std::vector<std::unique_ptr<PlacedBody>> &bodies);

    /// Throws InputError about what a pattern cannot see.
    void check(const ParameterFile &source) const;

    /// Of all isotropic materials.
    double largest_poisson_ratio() const;

    /// Whether volume strains are means over cells, by 'Volume strain' with
    /// automatic replaced by what it stands for.
    bool has_mean_dilatation() const;

    /// Above it trilinear elements with pointwise volume strains are much too
    /// stiff.
    static constexpr double locking_poisson_ratio = 0.45;

    std::optional<double> youngs_modulus, poisson_ratio, density;
    std::string materials;
    std::string densities;
    std::string material_ids;
    std::string volume_strain = "automatic";
  };
} // namespace stiction
