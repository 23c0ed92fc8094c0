#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/contact/obstacles/obstacle_shapes.h>

#include <cmath>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;

    class Plane : public Obstacle
    {
    public:
      Plane(const Point<3> &point, const Tensor<1, 3> &normal)
        : point_(point)
        , normal_(normal)
      {
      }

      Value at(const Point<3> &p) const override
      {
        return {(p - point_) * normal_, normal_};
      }

    private:
      const Point<3> point_;
      const Tensor<1, 3> normal_;
    };

    // The distance R from a point or, with an axis, from a line.
    class Round : public Obstacle
    {
    public:
      Round(const Point<3> &centre, const Tensor<1, 3> &axis, const double R)
        : centre_(centre)
        , axis_(axis)
        , R_(R)
      {
      }

      Value at(const Point<3> &p) const override
      {
        Tensor<1, 3> v = p - centre_;
        v -= (v * axis_) * axis_;
        const double r = v.norm();
        const double s = R_ > 0. ? 1. : -1.;
        return {s * r - R_, r > 0. ? s / r * v : Tensor<1, 3>()};
      }

    private:
      const Point<3> centre_;
      const Tensor<1, 3> axis_;
      const double R_;
    };

    class Paraboloid : public Obstacle
    {
    public:
      Paraboloid(const Point<3> &apex, const Tensor<1, 3> &axis, const double R)
        : apex_(apex)
        , axis_(axis)
        , R_(R)
      {
      }

      Value at(const Point<3> &p) const override
      {
        const Tensor<1, 3> v = p - apex_;
        const double s       = v * axis_;
        const Tensor<1, 3> r = v - s * axis_;
        return {s + r.norm_square() / (2. * R_), axis_ + r / R_};
      }

    private:
      const Point<3> apex_;
      const Tensor<1, 3> axis_;
      const double R_;
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
    if (name == "plane")
      return std::make_unique<Plane>(point, direction);

    const double R = v.back();
    if (!(std::abs(R) > 1e-30))
      throw InputError(entry + ", its radius must not be zero.");
    if (name == "paraboloid")
      return std::make_unique<Paraboloid>(point, direction, R);
    return std::make_unique<Round>(point, direction, R);
  }
} // namespace stiction
