#pragma once

#include <stiction/base/text/mesh_names.h>

#include <deal.II/base/function.h>
#include <deal.II/base/types.h>
#include <deal.II/fe/component_mask.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  template<int dim> class FunctionParser;
}

namespace stiction
{
  /// A formula of the user in x, y, z, t with n components separated by ';', as
  /// deal.II functions go. Values that are not finite are refused when they
  /// are met. Quantities that the answer decides may stand in it beside them.
  class ParsedFunction : public dealii::Function<3>
  {
  public:
    /// @param location the beginning of a sentence about the entry, see
    ///   ParameterFile::locate().
    /// @param time the value of t, until set_time(), which a formula that depends on
    ///   quantities does not know.
    /// @param quantities the names of quantities that may stand in the formula.
    ///
    /// Throws InputError if the number of components is wrong or a component
    /// is not a formula muParser can read, or uses more than four of x, y, z and the
    /// quantities.
    ParsedFunction(const std::string &expression, unsigned int n_components,
                   std::string location, double time = 1.,
                   const std::vector<std::string> &quantities = {});
    ~ParsedFunction() override;

    /// Gives t another value.
    void set_time(double time) override;

    /// Throws InputError if the value is not a finite number.
    double value(const dealii::Point<3> &p, unsigned int component = 0) const override;

    /// Whether a quantity stands in it.
    bool has_quantities() const { return !slots_.empty(); }

    /// The value at a place with these quantities, in the order of their names.
    double value_with(const dealii::Point<3> &p, const std::vector<double> &quantities,
                      unsigned int component) const;

    /// ", t = 2" if it depends on t, for a sentence about one of its values.
    std::string time_in_words() const;

    /// Throws InputError if it depends on t: it is evaluated once.
    void require_no_time() const;

    /// As the user wrote it.
    const std::string &expression() const { return expression_; }

  private:
    std::string expression_;
    std::string location_;
    std::unique_ptr<dealii::FunctionParser<3>> parser_;
    std::vector<std::string> quantities_;
    /// Which of x, y, z and the quantities are the four variables of the parser; none:
    /// these are x, y, z, t.
    std::vector<std::size_t> slots_;
  };

  /// The values of formulas separated by ';' that depend on t alone.
  ///
  /// Throws InputError as ParsedFunction, and if they depend on x, y, z.
  std::vector<double> read_numbers(const std::string &text, unsigned int n_components,
                                   const std::string &location, double time);

  /// What a user says about a boundary: a vector of formulas.
  struct BoundaryFunction
  {
    std::unique_ptr<ParsedFunction> function;
    /// Which components are spoken of; the others are said to be 'free'.
    dealii::ComponentMask components;
  };

  /// Vector-valued formulas by boundary id.
  using BoundaryFunctions = std::map<dealii::types::boundary_id, BoundaryFunction>;

  /// The parts of a text between single bars, without blanks around them:
  /// '||' is muParser's "or" and does not separate.
  std::vector<std::string> split_at_bars(const std::string &text);

  /// What stands before the first colon and, if there is one, behind it, without blanks
  /// around them.
  std::pair<std::string, std::optional<std::string>> split_at_colon(
    const std::string &text);

  /// Whether all of the formulas 'ux; uy; uz' are the number 0 or 'free'.
  bool are_zero(const std::string &formulas);

  /// Reads 'fx; fy; fz', where 'free' may stand in place of a formula, but not
  /// of all.
  ///
  /// @param part whose components these are, for messages: "boundary top".
  ///
  /// Throws InputError as ParsedFunction, and if all are free.
  BoundaryFunction parse_components(const std::string &formulas,
                                    const std::string &location, const std::string &part,
                                    double time);

  /// Reads 'boundary : fx; fy; fz | boundary : fx; fy; fz ...', a boundary
  /// being a name or a number; an empty text gives an empty map.
  ///
  /// @param n_components formulas for each boundary.
  /// @param may_be_free whether 'free' may stand in place of a formula (but not
  ///   of all).
  /// @param time the value of t.
  ///
  /// Throws InputError for a boundary that the mesh does not have or that
  /// stands twice, and as ParsedFunction.
  BoundaryFunctions parse_boundary_functions(const std::string &text,
                                             const std::string &location,
                                             const MeshNames &names,
                                             unsigned int n_components = 3,
                                             bool may_be_free = false, double time = 1.);
} // namespace stiction
