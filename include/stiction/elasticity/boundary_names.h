#ifndef stiction_elasticity_boundary_names_h
#define stiction_elasticity_boundary_names_h

#include <deal.II/base/types.h>

#include <map>
#include <set>
#include <string>

namespace stiction
{
  /// The boundaries of a mesh by name: how a user speaks of them in a
  /// parameter file, where their numbers serve as well.
  class BoundaryNames
  {
  public:
    using Id = dealii::types::boundary_id;

    /// No boundaries.
    BoundaryNames() = default;

    /// The boundaries a mesh has, and the names of some of them.
    BoundaryNames(std::set<Id> ids, std::map<std::string, Id> names);

    /// Those of the brick: left (0), right (1), front (2), back (3), bottom
    /// (4), top (5), which are x = 0, x = Lx, y = 0, y = Ly, z = 0, z = Lz.
    static BoundaryNames
    brick();

    /// The id of a boundary given by its name or by its number.
    ///
    /// @param location the beginning of a sentence about the entry, see
    ///   ParameterFile::locate(). Throws InputError if the mesh has no such
    ///   boundary.
    Id
    id(const std::string &name, const std::string &location) const;

    /// "4 (bottom)", or the number alone.
    std::string
    describe(Id id) const;

    const std::set<Id> &
    ids() const
    {
      return ids_;
    }

  private:
    std::set<Id> ids_;
    std::map<std::string, Id> names_;
  };
} // namespace stiction

#endif
