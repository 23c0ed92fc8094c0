#pragma once

#include <deal.II/base/tensor.h>

#include <nlohmann/json.hpp>

// A list of three numbers. nlohmann::json looks for them in the namespace of the type.
namespace dealii
{
  inline void to_json(nlohmann::json &json, const Tensor<1, 3> &v)
  {
    json = {v[0], v[1], v[2]};
  }

  inline void from_json(const nlohmann::json &json, Tensor<1, 3> &v)
  {
    for (unsigned int c = 0; c < 3; ++c)
      json.at(c).get_to(v[c]);
  }
} // namespace dealii
