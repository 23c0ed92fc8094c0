#include <stiction/output/phases.h>

#include <nlohmann/json.hpp>

namespace stiction
{
  Phases::Scope::Scope(double &seconds)
    : seconds_(seconds)
    , begin_(std::chrono::steady_clock::now())
  {
  }



  Phases::Scope::~Scope()
  {
    seconds_ +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_)
        .count();
  }



  nlohmann::json
  Phases::to_json() const
  {
    nlohmann::json section;
    for (const char *phase : {"mesh",
                              "assembly",
                              "stiffness_setup",
                              "dual_operator",
                              "dual_iteration",
                              "displacement_iteration",
                              "contact_solve",
                              "error_estimate",
                              "elastic_solve",
                              "elastic_solve_iteration",
                              "sparse_factorization",
                              "dual_cholesky",
                              "output",
                              "total"})
      {
        const auto entry = seconds_.find(phase);
        section[phase]   = entry == seconds_.end()
                             ? nlohmann::json(nullptr)
                             : nlohmann::json(entry->second);
      }
    return section;
  }
} // namespace stiction
