#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/did_you_mean.h>
#include <stiction/contact/obstacles/obstacle.h>
#include <stiction/contact/obstacles/obstacle_shapes.h>
#include <stiction/contact/obstacles/obstacle_surface.h>
#include <stiction/contact/obstacles/stl_file.h>

#include <deal.II/base/utilities.h>

#include <utility>

namespace stiction
{
  namespace
  {
    using dealii::Point;
    using dealii::Utilities::trim;

    // ψ as a formula of the user.
    class ObstacleFormula : public Obstacle
    {
    public:
      ObstacleFormula(const std::string &formula, const std::string &location,
                      const double size, const double time)
        : psi_(formula, 1, location, time)
        , step_(relative_step * size)
      {
      }

      Value at(const Point<3> &p) const override
      {
        Value value;
        value.psi = psi_.value(p);
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto difference = [&](const double h) {
              Point<3> left = p, right = p;
              left[c] -= h;
              right[c] += h;
              return psi_.value(right) - psi_.value(left);
            };
            // of fourth order
            value.gradient[c] =
              (8. * difference(step_) - difference(2. * step_)) / (12. * step_);
          }
        return value;
      }

    private:
      // of the body's size: the error of the differences, its fourth power, and
      // that of rounding are both far below 1e-10
      static constexpr double relative_step = 1e-4;

      const ParsedFunction psi_;
      const double step_;
    };
  } // namespace

  std::unique_ptr<Obstacle> Obstacle::read(const std::string &text,
                                           const std::string &location, const double size,
                                           const double time, MPI_Comm communicator)
  {
    const auto [name, behind] = split_at_colon(text);
    const bool has_data       = behind.has_value();
    const std::string data    = behind.value_or("");
    const std::string entry   = location + " = " + trim(text);
    if (name == "foundation" && !has_data)
      return nullptr;
    if (name == "formula" && has_data)
      return std::make_unique<ObstacleFormula>(data, location, size, time);
    if (name == "file" && has_data)
      {
        TriangulatedSurface surface;
        throw_on_all_ranks(communicator, [&]() { surface = read_stl(data, entry); });
        return std::make_unique<ObstacleSurface>(std::move(surface));
      }
    auto shape = has_data ? make_obstacle_shape(name, data, location, time) : nullptr;
    if (!shape)
      throw InputError(entry +
                       ", must be 'foundation' or begin with 'boundary :', 'plane :', "
                       "'sphere :', 'cylinder :', 'paraboloid :', 'formula :' "
                       "or 'file :'" +
                       did_you_mean(name, {"foundation", "boundary", "plane", "sphere",
                                           "cylinder", "paraboloid", "formula", "file"}) +
                       ".");
    return shape;
  }
} // namespace stiction
