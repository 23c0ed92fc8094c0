#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

namespace stiction
{
  class ParameterFile;

  /// How friction limits the tangential contact force at a node.
  enum class FrictionLaw
  {
    frictionless, ///< g = 0
    given,        ///< g = area × slip stress, also where the node is open
    coulomb,      ///< g = F λ_ν
    tied          ///< g = ∞: neither slips nor opens
  };

  /// The section 'Friction', of several contact boundaries separated by '|'.
  struct FrictionParameters : dealii::ParameterAcceptor
  {
    FrictionParameters();

    /// Throws InputError about what a pattern cannot see.
    void check(const ParameterFile &source) const;

    /// The entry Law as values: one, or one a contact boundary.
    std::vector<FrictionLaw> laws() const;

    /// Whether Coulomb's law holds on a contact boundary.
    bool has_coulomb() const;

    /// The one law of all contact boundaries as in the entry, or 'mixed'.
    std::string name() const;

    std::string law_name;
    std::string coefficient;
    std::string slip_stress;
    std::string first_direction;
  };
} // namespace stiction
