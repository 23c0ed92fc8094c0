#ifndef stiction_contact_friction_data_h
#define stiction_contact_friction_data_h

#include <array>
#include <memory>
#include <string>

namespace dealii
{
  template<int dim, typename Number>
  class Point;
}

namespace stiction
{
  class Parameters;
  class ParsedFunction;
  struct ContactNode;

  /// What the user says about friction, as functions of place: one number, or
  /// two along the principal directions of an ellipse.
  class FrictionData
  {
  public:
    /// The parameters must outlive the object. Throws InputError if a formula
    /// cannot be read.
    explicit FrictionData(const Parameters &parameters);
    ~FrictionData();

    /// Gives a node with its normal frame the coefficient or the slip stress of
    /// the law and, for an ellipse, tangents and scales.
    ///
    /// Throws InputError for values that are not allowed at its place.
    void
    set(ContactNode &node) const;

  private:
    /// An entry of one formula or two.
    struct Values
    {
      Values(const Parameters &parameters,
             const std::string &entry,
             const std::string &expression);
      ~Values();

      std::array<double, 2>
      at(const dealii::Point<3, double> &p) const;

      const Parameters &parameters;
      const std::string entry;
      std::unique_ptr<ParsedFunction> function;
    };

    const Parameters &parameters_;
    const Values coefficient_, slip_stress_;
    std::unique_ptr<ParsedFunction> first_direction_; ///< or nullptr
  };
} // namespace stiction

#endif
