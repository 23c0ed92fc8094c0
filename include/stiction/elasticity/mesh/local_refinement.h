#pragma once

#include <string>

namespace stiction
{
  class Body;
  struct GeometryParameters;
  class ParameterFile;

  /// Refines the cells at the contact boundary as often and where 'Geometry'
  /// says. Collective.
  ///
  /// @param contact_boundary as in the parameter file, several separated by '|'.
  ///
  /// Throws InputError if the contact boundary does not exist or the formula
  /// cannot be read.
  void refine_contact_boundary(Body &body, const GeometryParameters &geometry,
                               const std::string &contact_boundary,
                               const ParameterFile &source);
} // namespace stiction
