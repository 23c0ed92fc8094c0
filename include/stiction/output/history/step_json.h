#ifndef stiction_output_history_step_json_h
#define stiction_output_history_step_json_h

#include <stiction/output/history/step_result.h>

#include <nlohmann/json_fwd.hpp>

namespace stiction
{
  /// A list of three numbers.
  nlohmann::json to_json(const dealii::Tensor<1, 3> &vector);

  /// A certified step with all its digits, as in the list "steps" of summary.json.
  nlohmann::json to_json(const StepResult &step);

  /// Back. Throws what nlohmann's library does if something is missing.
  StepResult step_from_json(const nlohmann::json &step);
} // namespace stiction

#endif
