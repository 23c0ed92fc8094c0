#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/base/log.h>
#include <stiction/output/history/step_history.h>
#include <stiction/output/history/step_json.h>
#include <stiction/output/tensor_json.h>

#include <deal.II/base/data_out_base.h>

#include <filesystem>
#include <fstream>

namespace stiction
{
  using nlohmann::json;

  namespace
  {
    // Of a row: numbers with twelve digits, words in quotes where they need them.
    class Row
    {
    public:
      Row &operator<<(const std::string &text)
      {
        const bool needs_quotes = text.find_first_of(",\"\r\n") != std::string::npos;
        std::string quoted;
        for (const char c : text)
          quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
        return add(needs_quotes ? '"' + quoted + '"' : text);
      }

      Row &operator<<(const double number)
      {
        return add(format("%.12g", number == 0. ? 0. : number));
      }

      Row &operator<<(const dealii::Tensor<1, 3> &v)
      {
        return *this << v[0] << v[1] << v[2];
      }

      std::string line() const { return text_ + '\n'; }

    private:
      Row &add(const std::string &entry)
      {
        text_ += (is_empty_ ? "" : ",") + entry;
        is_empty_ = false;
        return *this;
      }

      std::string text_;
      bool is_empty_ = true;
    };

    const char *const history_header =
      "step,t,boundary,force_x,force_y,force_z,moment_x,moment_y,moment_z,normal_force,"
      "center_x,center_y,center_z,open_area,slip_area,stick_area,obstacle_x,obstacle_y,"
      "obstacle_z,obstacle_angle,torque,dissipated,dissipated_total,pair,opposite\n";

    const char *const energy_header =
      "step,t,work_loads,work_supports,work_obstacles,elastic_energy,"
      "elastic_energy_change,dissipated,time_stepping,balance_error,newton_steps,"
      "krylov_iterations,dual_multiplications,seconds\n";

    std::string energy_row(const StepResult &step)
    {
      const EnergyBalance::Step &energy = step.energy;
      Row row;
      row << step.number << step.time << energy.loads << energy.supports
          << energy.obstacles << energy.elastic_energy << energy.elastic_change
          << energy.dissipation << energy.time_stepping
          << (energy.error ? format("%.3g", *energy.error) : "")
          << step.effort.newton_steps << step.effort.krylov_iterations
          << static_cast<double>(step.effort.dual_multiplications) << step.effort.seconds;
      return row.line();
    }

    std::string history_rows(const StepResult &step)
    {
      std::string rows;
      for (const BoundaryStep &boundary : step.boundaries)
        {
          Row row;
          row << step.number << step.time << boundary.name << boundary.force
              << boundary.moment << boundary.normal_force;
          if (boundary.normal_force > 0. && !boundary.is_tied)
            row << boundary.center;
          else
            row << ""
                << ""
                << "";
          row << boundary.open_area << boundary.slip_area << boundary.stick_area
              << boundary.obstacle_displacement << boundary.obstacle_angle
              << boundary.torque << boundary.dissipated << boundary.dissipated_total
              << boundary.section_name << boundary.opposite;
          rows += row.line();
        }
      return rows;
    }
  } // namespace

  StepHistory::StepHistory(std::string directory, MPI_Comm communicator)
    : directory_(std::move(directory))
    , communicator_(communicator)
  {
  }

  void StepHistory::add(StepResult step)
  {
    for (std::size_t b = 0; b < step.boundaries.size() && !steps_.empty(); ++b)
      {
        BoundaryStep &boundary   = step.boundaries[b];
        const BoundaryStep &last = steps_.back().boundaries[b];
        boundary.dissipated_total += last.dissipated_total;
        // a run that goes on from an older one calls boundaries as it does
        if (last.section_name != boundary.section_name ||
            last.opposite != boundary.opposite)
          for (StepResult &before : steps_)
            {
              before.boundaries[b].section_name = boundary.section_name;
              before.boundaries[b].opposite     = boundary.opposite;
            }
      }
    steps_.push_back(std::move(step));
    append("history.csv", history_header, history_rows);
    append("energy.csv", energy_header, energy_row);
    has_begun_ = true;
  }

  void StepHistory::append(const std::string &file, const std::string &header,
                           const Rows rows) const
  {
    do_on_first_rank(communicator_, [&]() {
      const std::string name = directory_ + "/" + file;
      std::error_code error; // somebody may have removed it
      const auto size = std::filesystem::file_size(name, error);
      if (!has_begun_ || error)
        return write_file(name, [&](std::ostream &out) {
          out << header;
          for (const StepResult &step : steps_)
            out << rows(step);
        });
      std::ofstream out(name, std::ios::app);
      out << rows(steps_.back());
      out.close();
      if (!out)
        std::filesystem::resize_file(name, size, error); // no half of a row
      require_written(out.good(), name);
    });
  }

  EnergyBalance::Step StepHistory::energy() const
  {
    EnergyBalance::Step sum;
    for (const StepResult &step : steps_)
      sum += step.energy;
    return sum;
  }

  std::string StepHistory::tag() const { return format("_%04u", steps_.back().number); }

  void StepHistory::add_file(const std::string &name, const std::string &extension)
  {
    auto &series = series_[name];
    series.emplace_back(steps_.back().time, name + tag() + "." + extension);
    do_on_first_rank(communicator_, [&]() {
      write_file(directory_ + "/" + name + ".pvd", [&](std::ostream &file) {
        dealii::DataOutBase::write_pvd_record(file, series);
      });
    });
  }

  json StepHistory::to_json(const double elastic_solve_seconds) const
  {
    json list = json::array();
    for (const StepResult &step : steps_)
      {
        json entry                         = step;
        entry["certified"]                 = true;
        entry["force_on_body"]             = step.force();
        entry["elastic_solve_equivalents"] = nullptr;
        if (elastic_solve_seconds > 0.)
          entry["elastic_solve_equivalents"] =
            step.effort.seconds / elastic_solve_seconds;
        list.push_back(std::move(entry));
      }
    return list;
  }

  json StepHistory::progress() const { return {{"steps", steps_}, {"series", series_}}; }

  void StepHistory::go_on_from(const json &progress, const bool in_place)
  {
    for (const json &step : progress.at("steps"))
      steps_.push_back(step);
    if (in_place)
      series_ = progress.at("series").get<decltype(series_)>();
  }
} // namespace stiction
