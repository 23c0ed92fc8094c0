#include <stiction/output/history/step_json.h>
#include <stiction/output/tensor_json.h>

#include <utility>

namespace stiction
{
  using nlohmann::json;

  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BoundaryStep, name, section_name, opposite, force,
                                     moment, normal_force, center, open_area, slip_area,
                                     stick_area, obstacle_displacement, obstacle_angle,
                                     torque, dissipated, dissipated_total, is_tied)
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SolverEffort, newton_steps, krylov_iterations,
                                     dual_multiplications, seconds)

  namespace
  {
    using Energy = EnergyBalance::Step;

    constexpr std::pair<const char *, double Energy::*> energy_terms[] = {
      {"work_loads", &Energy::loads},
      {"work_supports", &Energy::supports},
      {"work_obstacles", &Energy::obstacles},
      {"elastic_energy", &Energy::elastic_energy},
      {"elastic_energy_change", &Energy::elastic_change},
      {"dissipated", &Energy::dissipation},
      {"time_stepping", &Energy::time_stepping}};
  } // namespace

  void to_json(json &entry, const StepResult &step)
  {
    entry = step.effort;
    entry.update(json({{"step", step.number},
                       {"t", step.time},
                       {"residual", step.residual},
                       {"boundaries", step.boundaries}}));
    json &energy = entry["energy"];
    for (const auto &[name, term] : energy_terms)
      energy[name] = step.energy.*term;
    energy["balance_error"] = nullptr;
    if (step.energy.error)
      energy["balance_error"] = *step.energy.error;
  }

  void from_json(const json &entry, StepResult &step)
  {
    step.effort   = entry;
    step.number   = entry.at("step");
    step.time     = entry.at("t");
    step.residual = entry.at("residual");
    for (const json &boundary : entry.at("boundaries"))
      {
        json all = {// not in old files
                    {"section_name", ""},
                    {"opposite", boundary.value("is_pair", false) ? "?" : ""},
                    {"is_tied", false}};
        all.update(boundary);
        step.boundaries.push_back(all);
      }
    const json &energy = entry.at("energy");
    for (const auto &[name, term] : energy_terms)
      step.energy.*term = energy.at(name);
    if (!energy.at("balance_error").is_null())
      step.energy.error = energy.at("balance_error").get<double>();
  }
} // namespace stiction
