#pragma once

#include <stiction/base/errors.h>

#include "tests.h"

#include <string>

// "certified", "not converged", or why no equilibrium exists.
inline std::string how_it_ends(const std::string &file, const Settings &settings = {})
{
  try
    {
      const Run run(file, settings);
      return run.converged ? "certified" : "not converged";
    }
  catch (const stiction::InputError &error)
    {
      const std::string text  = error.what();
      const std::size_t begin = text.find("no equilibrium");
      return begin == std::string::npos ? text
                                        : text.substr(begin, text.find(';') - begin);
    }
}
