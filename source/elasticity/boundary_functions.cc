#include <stiction/elasticity/boundary_functions.h>
#include <stiction/errors.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace stiction
{
  namespace
  {
    using dealii::Utilities::trim;

    // The last line deal.II's message on a formula has to say is muParser's.
    std::string
    reason(const dealii::ExceptionBase &exception)
    {
      std::ostringstream out;
      exception.print_info(out);
      std::string text;
      for (const std::string &line :
           dealii::Utilities::split_string_list(out.str(), '\n'))
        if (!trim(line).empty())
          text += (text.empty() ? "" : " ") + trim(line);
      return text;
    }

    // At single bars only: '||' is the logical or.
    std::vector<std::string>
    split_at_bars(const std::string &text)
    {
      std::vector<std::string> parts(1);
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] != '|')
          parts.back() += text[i];
        else if (i + 1 < text.size() && text[i + 1] == '|')
          {
            parts.back() += "||";
            ++i;
          }
        else
          parts.emplace_back();
      return parts;
    }
  } // namespace



  ParsedFunction::ParsedFunction(const std::string &expression,
                                 const unsigned int n_components,
                                 std::string location)
    : dealii::Function<3>(n_components)
    , expression_(trim(expression))
    , location_(std::move(location))
    , parser_(std::make_unique<dealii::FunctionParser<3>>(n_components))
  {
    const auto parts = dealii::Utilities::split_string_list(expression_, ';');
    bool complete    = parts.size() == n_components;
    for (const std::string &part : parts)
      complete = complete && !trim(part).empty();
    if (!complete)
      throw InputError(location_ + " = " + expression_ + ", must be " +
                       (n_components == 1 ? std::string("one formula")
                                          : std::to_string(n_components) +
                                              " formulas separated by ';'") +
                       ".");

    try
      {
        parser_->initialize(
          "x,y,z", expression_, {{"pi", dealii::numbers::PI}}, false);
        // muParser reads a formula when it is first evaluated
        for (unsigned int c = 0; c < n_components; ++c)
          parser_->value(dealii::Point<3>(), c);
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw InputError(location_ + " = " + expression_ +
                         ", is not a formula in x, y, z: " + reason(exception));
      }
  }



  ParsedFunction::~ParsedFunction() = default;



  double
  ParsedFunction::value(const dealii::Point<3> &p,
                        const unsigned int component) const
  {
    const double value = parser_->value(p, component);
    if (!std::isfinite(value))
      {
        std::ostringstream message;
        message << location_ << " = " << expression_ << ", gives " << value
                << " at (" << p << "), must be a finite number everywhere.";
        throw InputError(message.str());
      }
    return value;
  }



  BoundaryFunctions
  parse_boundary_functions(const std::string &text, const std::string &location)
  {
    BoundaryFunctions functions;
    if (trim(text).empty())
      return functions;

    for (const std::string &part : split_at_bars(text))
      {
        const std::size_t colon = part.find(':');
        const std::string name  = trim(part.substr(0, colon));
        if (colon == std::string::npos || name.empty() || name.size() > 5 ||
            name.find_first_not_of("0123456789") != std::string::npos)
          throw InputError(location + " = " + trim(text) +
                           ", must read 'id : fx; fy; fz', several separated "
                           "by '|', with a boundary id >= 0.");
        const auto id =
          static_cast<dealii::types::boundary_id>(std::stoul(name));
        if (functions.count(id) != 0)
          throw InputError(location + " = " + trim(text) + ", boundary " +
                           name + " stands twice, must stand once.");
        functions[id] =
          std::make_unique<ParsedFunction>(part.substr(colon + 1), 3, location);
      }
    return functions;
  }
} // namespace stiction
