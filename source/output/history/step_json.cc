#include <stiction/output/history/step_json.h>

#include <nlohmann/json.hpp>

namespace stiction
{
  using dealii::Tensor;
  using nlohmann::json;

  namespace
  {
    Tensor<1, 3> vector_from(const json &list)
    {
      Tensor<1, 3> vector;
      for (unsigned int c = 0; c < 3; ++c)
        vector[c] = list.at(c);
      return vector;
    }

    json to_json(const EnergyBalance::Step &energy)
    {
      return {{"work_loads", energy.loads},
              {"work_supports", energy.supports},
              {"work_obstacles", energy.obstacles},
              {"elastic_energy", energy.elastic_energy},
              {"elastic_energy_change", energy.elastic_change},
              {"dissipated", energy.dissipation},
              {"time_stepping", energy.time_stepping},
              {"balance_error", energy.error ? json(*energy.error) : json(nullptr)}};
    }

    EnergyBalance::Step energy_from(const json &energy)
    {
      EnergyBalance::Step step;
      step.loads          = energy.at("work_loads");
      step.supports       = energy.at("work_supports");
      step.obstacles      = energy.at("work_obstacles");
      step.elastic_energy = energy.at("elastic_energy");
      step.elastic_change = energy.at("elastic_energy_change");
      step.dissipation    = energy.at("dissipated");
      step.time_stepping  = energy.at("time_stepping");
      if (!energy.at("balance_error").is_null())
        step.error = energy.at("balance_error").get<double>();
      return step;
    }

    json to_json(const BoundaryStep &boundary)
    {
      return {
        {"name", boundary.name},
        {"force", stiction::to_json(boundary.force)},
        {"moment", stiction::to_json(boundary.moment)},
        {"normal_force", boundary.normal_force},
        {"center", stiction::to_json(boundary.center)},
        {"open_area", boundary.open_area},
        {"slip_area", boundary.slip_area},
        {"stick_area", boundary.stick_area},
        {"obstacle_displacement", stiction::to_json(boundary.obstacle_displacement)},
        {"obstacle_angle", boundary.obstacle_angle},
        {"torque", boundary.torque},
        {"dissipated", boundary.dissipated},
        {"dissipated_total", boundary.dissipated_total},
        {"is_pair", boundary.is_pair},
        {"is_tied", boundary.is_tied}};
    }

    BoundaryStep boundary_from(const json &boundary)
    {
      return {boundary.at("name"),
              vector_from(boundary.at("force")),
              vector_from(boundary.at("moment")),
              boundary.at("normal_force"),
              vector_from(boundary.at("center")),
              boundary.at("open_area"),
              boundary.at("slip_area"),
              boundary.at("stick_area"),
              vector_from(boundary.at("obstacle_displacement")),
              boundary.at("obstacle_angle"),
              boundary.at("torque"),
              boundary.at("dissipated"),
              boundary.at("dissipated_total"),
              boundary.value("is_pair", false),
              boundary.value("is_tied", false)};
    }
  } // namespace

  json to_json(const Tensor<1, 3> &vector)
  {
    return {vector[0], vector[1], vector[2]};
  }

  json to_json(const StepResult &step)
  {
    json boundaries = json::array();
    for (const BoundaryStep &boundary : step.boundaries)
      boundaries.push_back(to_json(boundary));
    return {{"step", step.number},
            {"t", step.time},
            {"residual", step.residual},
            {"boundaries", boundaries},
            {"energy", to_json(step.energy)},
            {"newton_steps", step.effort.newton_steps},
            {"krylov_iterations", step.effort.krylov_iterations},
            {"dual_multiplications", step.effort.dual_multiplications},
            {"seconds", step.effort.seconds}};
  }

  StepResult step_from_json(const json &step)
  {
    StepResult result;
    result.number   = step.at("step");
    result.time     = step.at("t");
    result.residual = step.at("residual");
    for (const json &boundary : step.at("boundaries"))
      result.boundaries.push_back(boundary_from(boundary));
    result.energy = energy_from(step.at("energy"));
    result.effort = {step.at("newton_steps"), step.at("krylov_iterations"),
                     step.at("dual_multiplications"), step.at("seconds")};
    return result;
  }
} // namespace stiction
