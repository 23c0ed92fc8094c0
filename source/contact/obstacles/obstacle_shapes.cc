#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/contact/obstacles/obstacle_shapes.h>

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    class Shape : public Obstacle
    {
    public:
      using Function = std::function<Value(const Tensor<1, 3> &v)>;

      // @param at ψ and ∇ψ at a place as seen from the point.
      Shape(const Point<3> &point, Function at)
        : point_(point)
        , at_(std::move(at))
      {
      }

      Value at(const Point<3> &p) const override { return at_(p - point_); }

    private:
      const Point<3> point_;
      const Function at_;
    };
  } // namespace

  std::unique_ptr<Obstacle> make_obstacle_shape(const std::string &name,
                                                const std::string &numbers,
                                                const std::string &location,
                                                const double time)
  {
    static const std::map<std::string, std::pair<unsigned int, std::string>> forms = {
      {"plane", {6, "px; py; pz; nx; ny; nz"}},
      {"sphere", {4, "cx; cy; cz; R"}},
      {"cylinder", {7, "px; py; pz; ax; ay; az; R"}},
      {"paraboloid", {7, "px; py; pz; ax; ay; az; R"}}};
    const auto form = forms.find(name);
    if (form == forms.end())
      return nullptr;

    const std::string entry = location + " = " + name + " : " + numbers;
    const unsigned int n    = form->second.first;
    unsigned int n_given    = 1;
    for (const char c : numbers)
      n_given += c == ';' ? 1 : 0;
    if (n_given != n)
      throw InputError(entry + ", must read '" + name + " : " + form->second.second +
                       "'.");
    const std::vector<double> v = read_numbers(numbers, n, location, time);

    const Point<3> point(v[0], v[1], v[2]);
    Tensor<1, 3> direction;
    if (name != "sphere")
      {
        for (unsigned int c = 0; c < 3; ++c)
          direction[c] = v[3 + c];
        if (!(direction.norm() > 1e-30))
          throw InputError(entry + ", its " + (name == "plane" ? "normal" : "axis") +
                           " must not be zero.");
        direction /= direction.norm();
      }
    using Value = Obstacle::Value;
    if (name == "plane")
      return std::make_unique<Shape>(point, [direction](const Tensor<1, 3> &v) {
        return Value{v * direction, direction};
      });

    const double R = v.back();
    if (!(std::abs(R) > 1e-30))
      throw InputError(entry + ", its radius must not be zero.");
    if (name == "paraboloid")
      return std::make_unique<Shape>(point, [direction, R](const Tensor<1, 3> &v) {
        const double s       = v * direction;
        const Tensor<1, 3> r = v - s * direction;
        return Value{s + r.norm_square() / (2. * R), direction + r / R};
      });
    // the distance R from a point or, with an axis, from a line
    return std::make_unique<Shape>(point, [direction, R](const Tensor<1, 3> &v) {
      const Tensor<1, 3> way = v - (v * direction) * direction;
      const double r         = way.norm();
      const double s         = R > 0. ? 1. : -1.;
      return Value{s * r - R, r > 0. ? s / r * way : Tensor<1, 3>()};
    });
  }
} // namespace stiction
