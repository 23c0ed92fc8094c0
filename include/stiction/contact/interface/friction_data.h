#pragma once

#include <array>
#include <memory>
#include <string>

namespace dealii
{
  template<int dim, typename Number> class Point;
}

namespace stiction
{
  struct ContactNode;
  enum class FrictionLaw;
  class ParameterFile;
  class ParsedFunction;

  /// What friction may depend on beside place and time.
  struct Rubbing
  {
    double pressure = 0.; ///< λ_ν/A, Pa
    double slip     = 0.; ///< the length of the way slipped up to now, m
  };

  /// What the user says about friction on one contact boundary, as functions of
  /// place, time, pressure and slip: one number, or two along the principal directions
  /// of an ellipse.
  class FrictionData
  {
  public:
    /// @param coefficient, slip_stress, first_direction the texts of the
    ///   entries of those names, for this boundary; of the first two the one
    ///   that the law has counts.
    /// @param source for messages, must outlive the object.
    /// @param time the value of t.
    ///
    /// Throws InputError if a formula cannot be read.
    FrictionData(FrictionLaw law, const std::string &coefficient,
                 const std::string &slip_stress, const std::string &first_direction,
                 const ParameterFile &source, double time);
    ~FrictionData();

    FrictionLaw law() const { return law_; }

    /// Gives a node with its normal frame the coefficient or the slip stress of
    /// the law without pressure and slip and, for an ellipse, tangents and scales.
    ///
    /// Throws InputError for values that are not allowed at its place.
    void set(ContactNode &node) const;

    /// Whether there are two values, of an ellipse.
    bool is_orthotropic() const;

    /// Whether the values depend on pressure or slip.
    bool depends_on_rubbing() const;

    /// The coefficient or the slip stress at a node that has been set().
    ///
    /// Throws InputError for values that are not allowed, and if an ellipse changes its
    /// proportions: the contact variables belong to them.
    double value(const ContactNode &node, const Rubbing &rubbing) const;

  private:
    /// An entry of one formula or two.
    struct Values
    {
      Values(const ParameterFile &source, const std::string &entry,
             const std::string &expression, double time);
      ~Values();

      std::array<double, 2> at(const dealii::Point<3, double> &p,
                               const Rubbing &rubbing) const;

      const ParameterFile &source;
      const std::string entry;
      std::unique_ptr<ParsedFunction> function;
    };

    void set(ContactNode &node, const Rubbing &rubbing) const;

    [[noreturn]] void refuse_ratio() const;

    const ParameterFile &source_;
    const FrictionLaw law_;
    std::unique_ptr<Values> bound_; ///< coefficient or slip stress, or none
    std::unique_ptr<ParsedFunction> first_direction_; ///< or nullptr
  };
} // namespace stiction
