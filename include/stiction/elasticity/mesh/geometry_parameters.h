#pragma once

#include <stiction/elasticity/mesh/placed_body.h>
#include <stiction/elasticity/mesh/shape_parameters.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace stiction
{
  /// The section 'Geometry'. What an entry means stands, here as in all
  /// sections, in its documentation string, which --print-parameters shows.
  struct GeometryParameters : ShapeParameters
  {
    GeometryParameters();

    /// Fills in what other entries say (a brick by its lengths, a row of Table 1)
    /// and where the mesh file is.
    ///
    /// Throws InputError about what is missing and what a pattern cannot see.
    void complete(const ParameterFile &source);

    /// Declares sections 'Body NAME', which then say what the bodies are in place of
    /// this one.
    /// Throws InputError for a name that could not stand in an entry.
    void declare_bodies(const std::string &file,
                        const std::vector<std::string> &sections);

    /// Says of which boundaries other entries speak; those of bodies are 'BODY.NAME'.
    void set_boundaries_in_use(const std::set<std::string> &names);

    /// Number of cells after refinement; a double, because it may be anything
    /// before it is checked. For bodies other than the brick the least
    /// possible: the cells that their coarse mesh has are known only when it
    /// is there.
    /// Of local refinement the most it can make.
    double n_cells() const;

    /// Of them those of the mesh without local refinement.
    double n_uniform_cells() const;

    /// Whether the mesh is uniform and its cells trilinear.
    bool has_geometric_levels() const
    {
      return contact_refinement == 0 && element_degree == 1;
    }

    /// The entry ("Section/Entry") to blame if these are too many.
    std::string entry_of_size() const;

    std::vector<std::unique_ptr<PlacedBody>> bodies;

    unsigned int global_refinement       = 0;
    unsigned int contact_refinement      = 0;
    std::string contact_refinement_where = "1";
    unsigned int element_degree          = 1;
    unsigned int table_1_level           = 0;
    std::string table_1_reading          = "nodes";

  private:
    /// Puts Lengths, Subdivisions and Global refinement of the paper's table
    /// in place of the given ones when Table 1 level is not 0.
    void apply_table_1_level(const ParameterFile &source);

    void check_size(const ParameterFile &source) const;
  };
} // namespace stiction
