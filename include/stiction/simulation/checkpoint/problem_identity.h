#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace stiction
{
  class Parameters;

  /// What must be the same for a computation to go on: body, mesh, material, contact
  /// boundaries and kinds of friction. Loads, supports, times, solvers and output may
  /// change. Reads the mesh file; not collective.
  nlohmann::json problem_identity(const Parameters &parameters);

  /// Throws InputError, naming the entry and both values, unless the problem is the
  /// one that a checkpoint is of. Not collective.
  ///
  /// @param identity problem_identity() of then. @param checkpoint its directory.
  void require_same_problem(const Parameters &parameters, const nlohmann::json &identity,
                            const std::string &checkpoint);
} // namespace stiction
