#ifndef stiction_elasticity_boundary_functions_h
#define stiction_elasticity_boundary_functions_h

#include <deal.II/base/function.h>
#include <deal.II/base/types.h>

#include <map>
#include <memory>
#include <string>

namespace dealii
{
  template<int dim>
  class FunctionParser;
}

namespace stiction
{
  /// A formula of the user in x, y, z with n components separated by ';', as
  /// deal.II functions go. Values that are not finite are refused when they
  /// are met.
  class ParsedFunction : public dealii::Function<3>
  {
  public:
    /// @param location the beginning of a sentence about the entry, see
    ///   ParameterFile::locate().
    ///
    /// Throws InputError if the number of components is wrong or a component
    /// is not a formula muParser can read.
    ParsedFunction(const std::string &expression,
                   unsigned int n_components,
                   std::string location);
    ~ParsedFunction() override;

    /// Throws InputError if the value is not a finite number.
    double
    value(const dealii::Point<3> &p, unsigned int component = 0) const override;

  private:
    std::string expression_;
    std::string location_;
    std::unique_ptr<dealii::FunctionParser<3>> parser_;
  };



  /// Vector-valued formulas by boundary id.
  using BoundaryFunctions =
    std::map<dealii::types::boundary_id, std::unique_ptr<ParsedFunction>>;



  /// Reads 'id : fx; fy; fz | id : fx; fy; fz ...'; an empty text gives an
  /// empty map. '||' is muParser's "or" and does not separate.
  ///
  /// Throws InputError for an id that is not a number or stands twice, and as
  /// ParsedFunction.
  BoundaryFunctions
  parse_boundary_functions(const std::string &text,
                           const std::string &location);
} // namespace stiction

#endif
