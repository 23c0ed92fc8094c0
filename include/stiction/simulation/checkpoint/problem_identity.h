#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace stiction
{
  class ContactSurface;
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

  /// What 'Slave side' would say of each contact boundary, were it not automatic:
  /// "boundary" or "obstacle"; the former where nothing deformable is opposite.
  std::vector<std::string> slave_sides(const ContactSurface &surface);

  /// Throws InputError, naming the first pair that differs, unless the sides that bear
  /// forces are those of a checkpoint: its nodes know forces and slips.
  ///
  /// @param sides slave_sides() of then. @param checkpoint its directory.
  void require_same_sides(const ContactSurface &surface,
                          const std::vector<std::string> &sides,
                          const std::string &checkpoint);
} // namespace stiction
