#include <stiction/base/errors.h>
#include <stiction/base/text/did_you_mean.h>
#include <stiction/base/text/mesh_names.h>

#include <utility>

namespace stiction
{
  namespace
  {
    bool is_number(const std::string &name)
    {
      return !name.empty() && name.size() <= 9 &&
             name.find_first_not_of("0123456789") == std::string::npos;
    }
  } // namespace

  MeshNames::MeshNames(std::string kind, std::set<Id> ids,
                       const std::map<std::string, Id> &names,
                       std::map<std::string, Id> others, std::string how_to_name)
    : kind_(std::move(kind))
    , ids_(std::move(ids))
    , others_(std::move(others))
    , how_to_name_(std::move(how_to_name))
  {
    for (const auto &name : names)
      (ids_.count(name.second) != 0 ? names_ : absent_).insert(name);
  }

  MeshNames MeshNames::brick_boundaries()
  {
    return MeshNames(
      "boundary", {0, 1, 2, 3, 4, 5},
      {{"left", 0}, {"right", 1}, {"front", 2}, {"back", 3}, {"bottom", 4}, {"top", 5}});
  }

  std::optional<MeshNames::Id> MeshNames::find(const std::string &name) const
  {
    const auto named = names_.find(name);
    if (named != names_.end())
      return named->second;
    if (is_number(name) && ids_.count(static_cast<Id>(std::stoul(name))) != 0)
      return static_cast<Id>(std::stoul(name));
    return {};
  }

  MeshNames::Id MeshNames::id(const std::string &name, const std::string &location) const
  {
    if (const auto found = find(name))
      return *found;

    std::string known;
    for (const Id other : ids_)
      known += (known.empty() ? "" : ", ") + describe(other);
    std::vector<std::string> names;
    for (const auto &other : names_)
      names.push_back(other.first);
    if (kind_ == "boundary" && absent_.count(name) != 0)
      throw InputError(location + ": boundary '" + name +
                       "' of the mesh file has no face on the outside of the mesh, must "
                       "have some: it is a name without faces, or they are inside, "
                       "between cells that share their nodes (bodies that are to be two "
                       "need nodes of their own); on the outside there are " +
                       known + ".");
    throw InputError(
      location + ": the mesh has no " + kind_ + " " +
      (is_number(name) ? name : "'" + name + "'") +
      (others_.count(name) == 0 ? did_you_mean(name, names)
       : kind_ == "boundary"    ? " (that is a body or a material)"
                                : " (that is a boundary)") +
      ", it has " + known +
      (names_.empty() && !how_to_name_.empty() ? ": " + how_to_name_ : "") + ".");
  }

  std::string MeshNames::describe(const Id id) const
  {
    const std::string number = std::to_string(id);
    return name(id) == number ? number : number + " (" + name(id) + ")";
  }

  std::string MeshNames::name(const Id id) const
  {
    for (const auto &name : names_)
      if (name.second == id)
        return name.first;
    return std::to_string(id);
  }
} // namespace stiction
