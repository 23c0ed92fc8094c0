#pragma once

#include <stiction/elasticity/mesh/shape_parameters.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>
#include <string>

namespace stiction
{
  /// A section 'Body NAME': one of several elastic bodies, and where it is.
  struct PlacedBody : ShapeParameters
  {
    explicit PlacedBody(const std::string &section);

    /// "Body".
    static const std::string section_name;

    /// Fills in what other entries say. Throws InputError as
    /// GeometryParameters::complete().
    void complete(const ParameterFile &source);

    /// Where a point of the shape is, m.
    dealii::Point<3> place(const dealii::Point<3> &p) const
    {
      return centre_ + turn_ * (p - centre_) + shift_;
    }

    /// The point of the shape that is there, m.
    dealii::Point<3> in_shape(const dealii::Point<3> &p) const
    {
      return centre_ + transpose(turn_) * (p - shift_ - centre_);
    }

    std::string name;
    unsigned int refinement = 0;
    /// Of all of it; not said: the section 'Material' does.
    std::optional<double> youngs_modulus, poisson_ratio, density;

  private:
    std::string translation = "0; 0; 0", rotation = "0; 0; 0; 0; 0; 1; 0";

    dealii::Point<3> centre_;
    dealii::Tensor<1, 3> shift_;
    dealii::Tensor<2, 3> turn_;
  };

  /// Throws InputError about entries of a section, "Body x/", that cannot be those of a
  /// material; what is not said can.
  void require_material(const ParameterFile &source, const std::string &prefix,
                        const std::optional<double> &youngs_modulus,
                        const std::optional<double> &poisson_ratio,
                        const std::optional<double> &density);
} // namespace stiction
