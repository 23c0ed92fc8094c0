#pragma once

// Two to four bricks on one another, by number, the same everywhere: of other sizes,
// meshes and moduli, one of them held or none, on a foundation or not, pressed, pulled
// aside, moved, heavy, or pressed together by nothing but loads; in pairs of any law,
// with gaps and without, that bear their forces on either side.

#include "../random_numbers.h"
#include "several_bodies.h"

#include <cmath>
#include <string>
#include <vector>

struct RandomAssembly : private RandomNumbers
{
  explicit RandomAssembly(const unsigned int number)
    : RandomNumbers(number)
  {
    const unsigned int n       = 2 + one_of(3);
    const unsigned int degree  = one_of(4) == 0 ? 2 : 1;
    const unsigned int support = one_of(4); // bottom, foundation, none, both ends
    double z = 0., width = 1.;
    for (unsigned int i = 0; i < n; ++i)
      {
        width                = i == 0 ? 1. : pick({1., 1., 0.6, 1.4});
        const double height  = pick({0.3, 0.5, 1., 1.5});
        const double aside   = i == 0 ? 0. : pick({0., 0.5 * (1. - width)});
        std::string segments = std::to_string(2 + one_of(3));
        for (unsigned int d = 1; d < 3; ++d)
          segments += "," + std::to_string(2 + one_of(3));
        text +=
          brick(body(i), exact(width) + "," + exact(width) + "," + exact(height),
                segments, three(aside, aside, z), "0;0;0;0;0;1;0",
                exact(1000. * std::pow(10., one_of(2) == 0 ? 0. : uniform(-2., 2.))));
        z += height;
      }
    load(support, body(n - 1), width);
    for (unsigned int i = 1; i < n; ++i)
      pair(body(i) + ".bottom", body(i - 1) + ".top");
    if (support == 1)
      text +=
        section("Contact pair ground", {"Boundary = b0.bottom", "Obstacle = foundation",
                                        "Law = coulomb", "Coefficient = 0.5"});
    text += section("Geometry", {"Element degree = " + std::to_string(degree),
                                 "Global refinement = " +
                                   std::to_string(degree == 1 ? one_of(2) : 0)}) +
            section("Contact solver", {"Tolerance = 1e-8"}) +
            section("Refinement", {"Estimate error = false"}) +
            section("Output", {"Write solution = false"});
  }

  std::string text; ///< the parameter file

private:
  static std::string body(const unsigned int i) { return "b" + std::to_string(i); }

  void load(const unsigned int support, const std::string &top, const double width)
  {
    const double aside = pick({0., 0.05});
    std::vector<std::string> lines;
    std::string held = support == 0 || support == 3 ? "b0.bottom : 0;0;0" : "";
    if (support == 2) // nothing but loads that are in balance
      lines = {"Pressure = b0.bottom : 1 | " + top +
               ".top : " + exact(1. / width / width)};
    else if (support == 3)
      held += " | " + top + ".top : " + three(1e-3 * aside, 0., -1e-3);
    else if (one_of(2) == 0)
      lines = {"Gravity = " + three(aside, 0., -1.)};
    else
      lines = {"Traction = " + top + ".top : " + three(aside, 0.3 * aside, -1.)};
    if (!held.empty())
      lines.push_back("Prescribed displacement = " + held);
    text += section("Boundary conditions", lines);
  }

  void pair(const std::string &boundary, const std::string &other)
  {
    const std::string law = pick<std::string>(
      {"coulomb", "coulomb", "coulomb", "frictionless", "given", "tied"});
    std::vector<std::string> lines = {"Boundary = " + boundary,
                                      "Obstacle = boundary : " + other, "Law = " + law};
    if (law == "coulomb")
      lines.push_back("Coefficient = " + exact(pick({0.1, 0.2, 0.5, 1.})));
    if (law == "given")
      lines.push_back("Slip stress = " + exact(pick({0.1, 1., 10.})));
    const std::string side = pick<std::string>({"", "boundary", "obstacle"});
    if (!side.empty())
      lines.push_back("Slave side = " + side);
    const std::string gap = pick<std::string>({"", "", "1e-4", "1e-3*(x-0.5)^2"});
    if (!gap.empty() && law != "tied")
      lines.push_back("Initial gap = " + gap);
    text += section("Contact pair " + boundary, lines);
  }
};
