// A block on which obstacles slide far, and what the tests of that ask of a run.

#pragma once

#include "several_bodies.h"

#include <algorithm>
#include <string>

namespace stiction
{
  inline const std::string block = "subsection Geometry\n"
                                   "  set Lengths = 40, 20, 10\n"
                                   "  set Subdivisions = 20, 10, 4\n"
                                   "end\n"
                                   "subsection Material\n"
                                   "  set Young's modulus = 1000\n"
                                   "  set Poisson ratio = 0.3\n"
                                   "end\n"
                                   "subsection Boundary conditions\n"
                                   "  set Prescribed displacement = bottom : 0; 0; 0\n"
                                   "  set Contact boundary = top\n"
                                   "  set Sliding = far\n"
                                   "end\n"
                                   "subsection Friction\n"
                                   "  set Law = coulomb\n"
                                   "  set Coefficient = 0.2\n"
                                   "end\n"
                                   "subsection Contact solver\n"
                                   "  set Tolerance = 1e-9\n"
                                   "end\n";

  inline const std::string force = "Boundary conditions/Obstacle force=0; 0; -400",
                           drag  = "Boundary conditions/Obstacle displacement=";

  inline double worst_balance(const Run &run)
  {
    double worst = 0.;
    for (const auto &step : run.summary()["steps"])
      if (step["energy"]["balance_error"].is_number())
        worst = std::max(worst, step["energy"]["balance_error"].get<double>());
    return worst;
  }
} // namespace stiction
