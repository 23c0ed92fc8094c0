#pragma once

#include <stiction/output/history/step_result.h>

#include <nlohmann/json_fwd.hpp>

namespace stiction
{
  /// A certified step with all its digits, as in the list "steps" of summary.json.
  void to_json(nlohmann::json &entry, const StepResult &step);

  /// Back. Throws what nlohmann's library does if something is missing.
  void from_json(const nlohmann::json &entry, StepResult &step);
} // namespace stiction
