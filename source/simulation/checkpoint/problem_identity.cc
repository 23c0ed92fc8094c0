#include <stiction/base/errors.h>
#include <stiction/base/text/boundary_functions.h>
#include <stiction/base/text/contact_pairs.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_pair_parameters.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/simulation/checkpoint/problem_identity.h>
#include <stiction/simulation/checkpoint/word_file.h>
#include <stiction/simulation/parameters/parameters.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

namespace stiction
{
  using nlohmann::json;

  namespace
  {
    const std::string mesh_file = "Geometry/Mesh file";

    bool is_of_problem(const std::string &entry)
    {
      static const std::set<std::string> single = {
        "Boundary conditions/Contact boundary", "Boundary conditions/Obstacle",
        "Boundary conditions/Sliding", "Friction/Law", "Refinement/Adaptive steps"};
      static const std::set<std::string> of_pair = {"Boundary", "Obstacle", "Sliding",
                                                    "Law"};
      const bool is_pair                         = entry.rfind("Contact pair ", 0) == 0;
      return entry.rfind("Geometry/", 0) == 0 ||
             entry.rfind(PlacedBody::section_name + " ", 0) == 0 ||
             entry.rfind("Material/", 0) == 0 || single.count(entry) > 0 ||
             (is_pair && of_pair.count(entry.substr(entry.rfind('/') + 1)) > 0);
    }

    // Of obstacles which other boundaries they are: what is rigid may be another one.
    std::string identity_of(const std::string &entry, const std::string &value)
    {
      if (entry.substr(entry.rfind('/') + 1) != "Obstacle")
        return value;
      std::string pairs;
      for (const std::string &obstacle : split_at_bars(value))
        if (!paired_boundaries(obstacle).empty())
          pairs += (pairs.empty() ? "" : " | ") + obstacle;
      return pairs;
    }

    // Without what may be written in several ways.
    std::string without_blanks(std::string value)
    {
      value.erase(std::remove_if(value.begin(), value.end(),
                                 [](const unsigned char c) { return std::isspace(c); }),
                  value.end());
      return value;
    }

    bool are_same(const std::string &now, const std::string &then)
    {
      return without_blanks(now) == without_blanks(then);
    }

    // Names the first contact pair that differs, if the file has sections of them.
    [[noreturn]] void refuse(const ParameterFile &source, const std::string &entry,
                             const std::string &now, const std::string &then,
                             const std::string &checkpoint)
    {
      const auto says = [&](const std::string &value) {
        return "must be what it was in the checkpoint " + checkpoint +
               (value.empty() ? ", where it has no value" : ", '" + value + "'");
      };
      const auto of_now = split_at_bars(now), of_then = split_at_bars(then);
      const std::size_t n = split_at_bars(source.given(true).at(entry)).size();
      if (!ContactPairs::is_pair(source.section_of_pair(entry, 0)) ||
          of_now.size() != n || of_then.size() != n)
        source.refuse(entry, says(then));
      const auto [differs, value] =
        std::mismatch(of_now.begin(), of_now.end(), of_then.begin(), are_same);
      source.of_pair(differs - of_now.begin()).refuse(entry, says(*value));
    }
  } // namespace

  json problem_identity(const Parameters &parameters)
  {
    json identity;
    for (const auto &[entry, value] : parameters.source.given(true))
      if (is_of_problem(entry))
        identity["entries"][entry] = identity_of(entry, value);
    if (parameters.geometry.type == "file")
      {
        const auto digest     = word_file::digest(parameters.geometry.mesh_file);
        identity["mesh_file"] = {digest.n_words, digest.checksum};
      }
    for (const auto &body : parameters.geometry.bodies)
      if (body->type == "file")
        {
          const auto digest                  = word_file::digest(body->mesh_file);
          identity["mesh_files"][body->name] = {digest.n_words, digest.checksum};
        }
    return identity;
  }

  void require_same_problem(const Parameters &parameters, const json &identity,
                            const std::string &checkpoint)
  {
    const json here = problem_identity(parameters);
    for (const auto &item : here.at("entries").items())
      {
        const auto now  = item.value().get<std::string>();
        const auto then = identity.at("entries").value(item.key(), std::string());
        if (item.key() != mesh_file && !are_same(now, then))
          refuse(parameters.source, item.key(), now, then, checkpoint);
      }
    if (here.value("mesh_files", json()) != identity.value("mesh_files", json()))
      throw InputError(parameters.source.file() +
                       ": the mesh files of the bodies must have the content that they "
                       "had in the checkpoint " +
                       checkpoint + ".");
    if (here.value("mesh_file", json()) != identity.value("mesh_file", json()))
      parameters.source.refuse(
        mesh_file, "must have the content that it had in the checkpoint " + checkpoint +
                     ", where its name was '" +
                     identity.at("entries").value(mesh_file, std::string()) + "'");
  }

  std::vector<std::string> slave_sides(const ContactSurface &surface)
  {
    std::vector<std::string> sides;
    for (const ContactBoundary &boundary : surface.boundaries())
      sides.push_back(boundary.side().is_first ? "boundary" : "obstacle");
    return sides;
  }

  void require_same_sides(const ContactSurface &surface,
                          const std::vector<std::string> &sides,
                          const std::string &checkpoint)
  {
    const std::vector<std::string> here = slave_sides(surface);
    for (std::size_t b = 0; b < sides.size(); ++b)
      {
        const ContactBoundary &boundary = surface.boundaries()[b];
        boundary.source().require(
          here[b] == sides[b], "Boundary conditions/Slave side",
          "makes boundary '" + boundary.name() + "' bear the forces of its pair with '" +
            boundary.partner_name() + "', must be '" + sides[b] +
            "', as in the checkpoint " + checkpoint + ", whose slips are of that side");
      }
  }
} // namespace stiction
