#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <functional>
#include <string>
#include <vector>

namespace stiction
{
  class Body;
  struct GeometryParameters;
  class ParameterFile;

  /// Refines the cells at the contact boundary as often and where 'Geometry'
  /// says. Collective.
  ///
  /// @param contact_boundary as in the parameter file, several separated by '|'.
  /// @param fields called before each refinement, for what Body::refine() carries.
  ///
  /// Throws InputError if the contact boundary does not exist or the formula
  /// cannot be read.
  void refine_contact_boundary(
    Body &body, const GeometryParameters &geometry, const std::string &contact_boundary,
    const ParameterFile &source,
    const std::function<std::vector<LA::Vector *>()> &fields = {});
} // namespace stiction
