#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

namespace stiction
{
  /// The boundaries or the materials of a mesh by name: how a user speaks of
  /// them in a parameter file, where their numbers serve as well.
  class MeshNames
  {
  public:
    /// What deal.II calls a boundary id or a material id.
    using Id = unsigned int;

    /// No parts.
    MeshNames() = default;

    /// The parts a mesh has, and the names of some of them.
    ///
    /// @param kind what they are, for messages: "boundary", "material".
    /// @param names those of parts that the mesh does not have are left out; a boundary
    ///   among them is refused with a sentence of its own.
    /// @param others the names of the other kind, which users take for these.
    /// @param how_to_name said where a name is asked for and there are none: a sentence
    ///   on how the file gets names.
    MeshNames(std::string kind, std::set<Id> ids, const std::map<std::string, Id> &names,
              std::map<std::string, Id> others = {}, std::string how_to_name = "");

    /// The boundaries of the brick: left (0), right (1), front (2), back (3),
    /// bottom (4), top (5), which are x = 0, x = Lx, y = 0, y = Ly, z = 0, z =
    /// Lz.
    static MeshNames brick_boundaries();

    /// The id of a part given by its name or by its number.
    ///
    /// @param location the beginning of a sentence about the entry, see
    ///   ParameterFile::locate(). Throws InputError if the mesh has no such
    ///   part.
    Id id(const std::string &name, const std::string &location) const;

    /// The same, nothing if there is no such part.
    std::optional<Id> find(const std::string &name) const;

    /// "4 (bottom)", or the number alone.
    std::string describe(Id id) const;

    /// "bottom", or the number if it has no name: how an entry calls it.
    std::string name(Id id) const;

    const std::set<Id> &ids() const { return ids_; }

  private:
    std::string kind_ = "boundary";
    std::set<Id> ids_;
    std::map<std::string, Id> names_, absent_, others_;
    std::string how_to_name_;
  };
} // namespace stiction
