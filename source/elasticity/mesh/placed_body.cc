#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/numbers.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/placed_body.h>

#include <cmath>

namespace stiction
{
  using namespace dealii;

  const std::string PlacedBody::section_name = "Body";

  PlacedBody::PlacedBody(const std::string &section)
    : ShapeParameters(section)
    , name(Utilities::trim(section.substr(section_name.size())))
  {
    add_parameter("Refinement", refinement,
                  "How many times every cell of this body is cut into eight, before "
                  "'Geometry/Global refinement' cuts those of all.",
                  prm, Patterns::Integer(0, 12));
    add_parameter("Translation", translation,
                  "By how much the body is moved from where its shape is, after it is "
                  "turned, 'x; y; z'. Unit: of length.");
    add_parameter("Rotation", rotation,
                  "How the body is turned, 'px; py; pz; ax; ay; az; angle': a point of "
                  "the axis, its direction a, and the angle in degrees, counterclockwise "
                  "as seen from where a points to. The axes of an orthotropic material "
                  "do not turn along: 'Material/Materials' says where they point.");
    add_number(*this, "Young's modulus", youngs_modulus,
               "E of the whole body, with its Poisson ratio; not said: the section "
               "'Material' has it. Unit: of stress.");
    add_number(*this, "Poisson ratio", poisson_ratio, "nu of the whole body.");
    add_number(*this, "Density", density,
               "Mass density of the whole body, >= 0. Unit: of mass per volume.");
  }

  void PlacedBody::complete(const ParameterFile &source)
  {
    locate(source);
    check(source);
    require_material(source, entry(""), youngs_modulus, poisson_ratio, density);
    source.require(youngs_modulus.has_value() == poisson_ratio.has_value(),
                   entry(youngs_modulus ? "Poisson ratio" : "Young's modulus"),
                   "must be said together with '" +
                     std::string(youngs_modulus ? "Young's modulus" : "Poisson ratio") +
                     "'");

    const auto shift =
      read_numbers(translation, 3, source.locate(entry("Translation")), 0.);
    const auto turn = read_numbers(rotation, 7, source.locate(entry("Rotation")), 0.);
    const Tensor<1, 3> axis({turn[3], turn[4], turn[5]});
    const double angle = turn[6] * numbers::PI / 180.;
    source.require(angle == 0. || axis.norm() > 1e-30, entry("Rotation"),
                   "its axis must not be zero");
    for (unsigned int c = 0; c < 3; ++c)
      {
        centre_[c]  = turn[c];
        shift_[c]   = shift[c];
        turn_[c][c] = 1.;
      }
    if (angle == 0.)
      return;
    const Tensor<1, 3> a = axis / axis.norm();
    for (unsigned int c = 0; c < 3; ++c)
      {
        Tensor<1, 3> e;
        e[c]                      = 1.;
        const Tensor<1, 3> column = std::cos(angle) * e +
                                    (1. - std::cos(angle)) * (a * e) * a +
                                    std::sin(angle) * cross_product_3d(a, e);
        for (unsigned int r = 0; r < 3; ++r)
          turn_[r][c] = column[r];
      }
  }

  void require_material(const ParameterFile &source, const std::string &prefix,
                        const std::optional<double> &youngs_modulus,
                        const std::optional<double> &poisson_ratio,
                        const std::optional<double> &density)
  {
    source.require(is_sane(youngs_modulus.value_or(1.)), prefix + "Young's modulus",
                   "must be " + sane_number);
    const double nu = poisson_ratio.value_or(0.);
    source.require(nu > -1. && nu < 0.5, prefix + "Poisson ratio",
                   "must be above -1 and below 0.5");
    const double rho = density.value_or(0.);
    source.require(rho == 0. || is_sane(rho), prefix + "Density",
                   "must be 0 or " + sane_number);
  }
} // namespace stiction
