#pragma once

namespace stiction
{
  struct BoundaryParameters;
  struct MaterialParameters;
  class ParameterFile;

  /// What the parameter file says of the body on its mesh.
  struct BodyParameters
  {
    const MaterialParameters &material;
    const BoundaryParameters &boundary;
    const ParameterFile &source; ///< for messages
    double time;                 ///< the t of the first loads
  };
} // namespace stiction
