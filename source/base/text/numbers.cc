#include <stiction/base/text/numbers.h>

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/utilities.h>

#include <cctype>

namespace stiction
{
  bool is_sane(const double value) { return value >= 1e-30 && value <= 1e30; }

  bool has_variable(const std::string &formula, const std::string &variables)
  {
    const auto is_in_word = [](const char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
    };
    for (std::size_t i = 0; i < formula.size(); ++i)
      if (variables.find(formula[i]) != std::string::npos &&
          (i == 0 || !is_in_word(formula[i - 1])) &&
          (i + 1 == formula.size() || !is_in_word(formula[i + 1])))
        return true;
    return false;
  }

  void add_number(dealii::ParameterAcceptor &section, const std::string &name,
                  std::optional<double> &number, const std::string &documentation)
  {
    dealii::ParameterHandler &prm = dealii::ParameterAcceptor::prm;
    section.enter_my_subsection(prm);
    prm.declare_entry(name, "", dealii::Patterns::List(dealii::Patterns::Double(), 0, 1),
                      documentation);
    prm.add_action(name, [&number](const std::string &text) {
      if (text.empty())
        number.reset();
      else
        number = dealii::Utilities::string_to_double(text);
    });
    section.leave_my_subsection(prm);
  }
} // namespace stiction
