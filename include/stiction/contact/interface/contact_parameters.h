#ifndef stiction_contact_interface_contact_parameters_h
#define stiction_contact_interface_contact_parameters_h

namespace stiction
{
  struct ContactPairParameters;
  struct FrictionParameters;
  class ParameterFile;

  /// What the parameter file says of contact.
  struct ContactParameters
  {
    const ContactPairParameters &pairs;
    const FrictionParameters &friction;
    const ParameterFile &source; ///< for messages
  };
} // namespace stiction

#endif
