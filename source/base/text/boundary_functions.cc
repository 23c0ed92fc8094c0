#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/in_words.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <regex>
#include <sstream>
#include <utility>

namespace stiction
{
  namespace
  {
    using dealii::Utilities::trim;

    // What muParser itself says, in deal.II's message of many lines.
    std::string complaint_of_parser(const dealii::ExceptionBase &exception)
    {
      std::ostringstream out;
      exception.print_info(out);
      std::string text       = out.str();
      const std::string mark = "said:";
      if (text.find(mark) != std::string::npos)
        text = text.substr(text.find(mark) + mark.size());
      std::replace(text.begin(), text.end(), '\n', ' ');
      text = trim(text);
      while (!text.empty() && (text.back() == '.' || text.back() == '>'))
        text.pop_back();
      text.erase(0, text.find_first_not_of("< "));
      return trim(text);
    }

    // deal.II writes muParser's complaints to the screen as well, on every
    // rank.
    class SilentErrors
    {
    public:
      SilentErrors()
        : screen_(std::cerr.rdbuf(nothing_.rdbuf()))
      {
      }
      ~SilentErrors() { std::cerr.rdbuf(screen_); }
      SilentErrors(const SilentErrors &)            = delete;
      SilentErrors &operator=(const SilentErrors &) = delete;

    private:
      std::ostringstream nothing_;
      std::streambuf *screen_;
    };

    // Whether a name stands in a formula as a word of its own.
    bool mentions(const std::string &formula, const std::string &name,
                  const std::regex::flag_type flags = std::regex::ECMAScript)
    {
      return std::regex_search(formula, std::regex("\\b" + name + "\\b", flags));
    }

    // What muParser accepts and no user means: 'a, b' is b, and 'x = 1' puts
    // 1 into x; and what other languages have. Empty if there is nothing of the kind.
    std::string trap(const std::string &formula)
    {
      int depth = 0;
      for (std::size_t i = 0; i < formula.size(); ++i)
        {
          const char c    = formula[i];
          const char next = i + 1 < formula.size() ? formula[i + 1] : ' ';
          depth += c == '(' ? 1 : c == ')' ? -1 : 0;
          if (c == ',' && depth == 0)
            return "',' stands between arguments of a function only, the "
                   "decimal sign is '.'";
          if (c == '=' && next == '=')
            ++i;
          else if (c == '=' && (i == 0 || std::string("<>!").find(formula[i - 1]) ==
                                            std::string::npos))
            return "'=' assigns, a comparison is '=='";
        }
      for (const auto &[word, written] :
           {std::pair("and", "A && B"), {"or", "A || B"}, {"not", "A == 0"}})
        if (mentions(formula, word, std::regex::icase))
          return text_of("'", word, "' is written '", written, "'");
      if (std::regex_search(formula, std::regex("!(?!=)")))
        return "'!A' is written 'A == 0'";
      if (std::regex_search(formula, std::regex("[<>]=?[^<>=!&|,()?:]+[<>]")))
        return "'A < B < C' is written 'A < B && B < C'";
      if (formula.find("**") != std::string::npos)
        return "a power is written '^'";
      if (formula.find("rand") != std::string::npos)
        return "a formula must not depend on chance";
      return "";
    }

    // Zeros in place of components that are 'free', which are taken out of the
    // mask.
    std::string mark_free(const std::string &formulas, dealii::ComponentMask &components)
    {
      if (formulas.find("free") == std::string::npos)
        return formulas;
      std::string marked;
      const auto parts = dealii::Utilities::split_string_list(formulas, ';');
      for (unsigned int c = 0; c < parts.size(); ++c)
        {
          const bool is_free = trim(parts[c]) == "free";
          if (is_free && c < components.size())
            components.set(c, false);
          marked += (c > 0 ? ";" : "") + (is_free ? "0" : parts[c]);
        }
      return marked;
    }

    bool are_formulas(const std::string &text, const unsigned int n_components)
    {
      const auto parts = dealii::Utilities::split_string_list(text, ';');
      return parts.size() == n_components &&
             std::none_of(parts.begin(), parts.end(),
                          [](const std::string &part) { return trim(part).empty(); });
    }
  } // namespace

  ParsedFunction::ParsedFunction(const std::string &expression,
                                 const unsigned int n_components, std::string location,
                                 const double time,
                                 const std::vector<std::string> &quantities)
    : dealii::Function<3>(n_components)
    , expression_(trim(expression))
    , location_(std::move(location))
    , parser_(std::make_unique<dealii::FunctionParser<3>>(n_components))
    , quantities_(quantities)
  {
    if (!are_formulas(expression_, n_components))
      throw InputError(location_ + " = " + expression_ + ", must be " +
                       (n_components == 1
                          ? std::string("one formula")
                          : std::to_string(n_components) + " formulas separated by ';'") +
                       ".");

    const auto parts = dealii::Utilities::split_string_list(expression_, ';');
    for (const std::string &part : parts)
      if (!trap(part).empty())
        throw InputError(location_ + " = " + expression_ + ", " + trap(part) + ".");

    // deal.II's parser has four variables: t becomes a constant of a formula with
    // quantities, which take the places of variables that it does without
    std::vector<std::string> names{"x", "y", "z"};
    names.insert(names.end(), quantities.begin(), quantities.end());
    std::string variables = "x,y,z,t", further;
    std::map<std::string, double> constants{{"pi", dealii::numbers::PI}};
    for (const std::string &name : quantities)
      further += ", " + name;
    if (std::any_of(quantities.begin(), quantities.end(),
                    [&](const std::string &name) { return mentions(expression_, name); }))
      {
        for (const bool is_wanted : {true, false})
          for (std::size_t k = 0; k < names.size(); ++k)
            if (mentions(expression_, names[k]) == is_wanted &&
                (is_wanted || slots_.size() < 4))
              slots_.push_back(k);
        if (slots_.size() > 4)
          throw InputError(location_ + " = " + expression_ +
                           ", must use at most four of x, y, z" + further + ".");
        variables = names[slots_[0]];
        for (std::size_t k = 1; k < 4; ++k)
          variables += "," + names[slots_[k]];
        constants["t"] = time;
      }

    try
      {
        const SilentErrors silence;
        // which reads && and || between blanks alone
        const std::string formulas =
          std::regex_replace(expression_, std::regex("&&|\\|\\|"), " $& ");
        parser_->initialize(variables, formulas, constants, true);
        if (slots_.empty())
          set_time(time);
        // muParser reads a formula when it is first evaluated
        for (unsigned int c = 0; c < n_components; ++c)
          parser_->value(dealii::Point<3>(), c);
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw InputError(location_ + " = " + expression_ +
                         ", is not a formula in x, y, z, t" + further + ": " +
                         complaint_of_parser(exception) + ".");
      }
  }

  ParsedFunction::~ParsedFunction() = default;

  void ParsedFunction::set_time(const double time)
  {
    dealii::Function<3>::set_time(time);
    parser_->set_time(time);
  }

  std::string ParsedFunction::time_in_words() const
  {
    const bool depends = slots_.empty() && mentions(expression_, "t");
    return depends ? text_of(", t = ", get_time()) : "";
  }

  void ParsedFunction::require_no_time() const
  {
    if (!time_in_words().empty())
      throw InputError(location_ + " = " + expression_ +
                       ", must not depend on t: it holds for all times.");
  }

  double ParsedFunction::value(const dealii::Point<3> &p,
                               const unsigned int component) const
  {
    return value_with(p, {}, component);
  }

  double ParsedFunction::value_with(const dealii::Point<3> &p,
                                    const std::vector<double> &quantities,
                                    const unsigned int component) const
  {
    dealii::Point<3> variables = p;
    if (!slots_.empty())
      {
        const auto variable = [&](const unsigned int k) {
          return slots_[k] < 3 ? p[slots_[k]] : quantities.at(slots_[k] - 3);
        };
        variables = {variable(0), variable(1), variable(2)};
        parser_->set_time(variable(3));
      }
    const double value = parser_->value(variables, component);
    if (!(std::abs(value) <= 1e30))
      {
        std::string here = time_in_words();
        for (std::size_t k = 0; k < quantities.size() && !slots_.empty(); ++k)
          here += text_of(", ", quantities_[k], " = ", quantities[k]);
        throw InputError(
          text_of(location_, " = ", expression_, ", gives ", value, " at (", p, ')', here,
                  ", must be a finite number of at most 1e30 everywhere."));
      }
    return value;
  }

  std::vector<double> read_numbers(const std::string &text,
                                   const unsigned int n_components,
                                   const std::string &location, const double time)
  {
    const ParsedFunction function(text, n_components, location, time);
    std::vector<double> numbers;
    for (unsigned int c = 0; c < n_components; ++c)
      {
        numbers.push_back(function.value(dealii::Point<3>(), c));
        if (function.value(dealii::Point<3>(0.37, 0.61, 0.83), c) != numbers.back())
          throw InputError(location + " = " + trim(text) +
                           ", must not depend on x, y, z.");
      }
    return numbers;
  }

  std::vector<std::string> split_at_bars(const std::string &text)
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
        {
          parts.back() = trim(parts.back());
          parts.emplace_back();
        }
    parts.back() = trim(parts.back());
    return parts;
  }

  std::pair<std::string, std::optional<std::string>> split_at_colon(
    const std::string &text)
  {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos)
      return {trim(text), {}};
    return {trim(text.substr(0, colon)), trim(text.substr(colon + 1))};
  }

  bool are_zero(const std::string &formulas)
  {
    for (const std::string &text : dealii::Utilities::split_string_list(formulas, ';'))
      {
        char *end          = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (text != "free" && (*end != '\0' || value != 0.))
          return false;
      }
    return true;
  }

  BoundaryFunction parse_components(const std::string &formulas,
                                    const std::string &location, const std::string &part,
                                    const double time)
  {
    if (!are_formulas(formulas, 3))
      throw InputError(location + " = " + formulas +
                       ", must be 3 formulas separated by ';', or 'free' in place of one "
                       "that is not prescribed.");
    dealii::ComponentMask components(3, true);
    const std::string marked = mark_free(formulas, components);
    if (components.n_selected_components() == 0)
      throw InputError(location + ", " + part +
                       " is free in all components, at least one must be a formula.");
    return {std::make_unique<ParsedFunction>(marked, 3, location, time), components};
  }

  BoundaryFunctions parse_boundary_functions(const std::string &text,
                                             const std::string &location,
                                             const MeshNames &names,
                                             const unsigned int n_components,
                                             const bool may_be_free, const double time)
  {
    BoundaryFunctions functions;
    if (trim(text).empty())
      return functions;

    std::string form = "'boundary : f";
    for (unsigned int c = 0; c < n_components && n_components > 1; ++c)
      form += std::string(c > 0 ? "; f" : "") + "xyz"[c];
    form += "'";

    const std::string entry = location + " = " + trim(text);
    for (const std::string &part : split_at_bars(text))
      {
        const auto [name, formulas] = split_at_colon(part);
        if (!formulas || name.empty())
          throw InputError(entry + ", must read " + form +
                           ", several separated by '|', with the name or the "
                           "number of a boundary.");
        const auto id = names.id(name, entry);
        if (functions.count(id) != 0)
          throw InputError(entry + ", boundary " + name +
                           " stands twice, must stand once.");

        functions[id] =
          may_be_free ? parse_components(*formulas, location, "boundary " + name, time)
                      : BoundaryFunction{std::make_unique<ParsedFunction>(
                                           *formulas, n_components, location, time),
                                         dealii::ComponentMask(n_components, true)};
      }
    return functions;
  }
} // namespace stiction
