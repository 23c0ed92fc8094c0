#include <stiction/base/text/numbers.h>

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/utilities.h>

namespace stiction
{
  bool is_sane(const double value) { return value >= 1e-30 && value <= 1e30; }

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
