#pragma once

#include <stiction/base/text/mesh_names.h>
#include <stiction/elasticity/mesh/readers/quadratic_cells.h>

#include <deal.II/grid/tria.h>

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace stiction
{
  struct PlacedBody;
  struct ShapeParameters;

  /// What is known of a mesh from where it came, see the functions of Body.
  struct MeshOrigin
  {
    QuadraticCells quadratic_cells; ///< of a file with elements of second order
    std::map<std::string, std::size_t> cut_elements;
    std::vector<std::string> left_out, damages;
    MeshNames boundary_names, material_names;
  };

  /// The mesh of a body, or of several, before it is refined and distributed:
  /// hexahedra with boundary ids, material ids and manifolds.
  class CoarseMesh
  {
  public:
    /// Makes the brick, the cylinder, the half ball or the mesh of a generator, or reads
    /// the file, the same on every rank.
    ///
    /// Throws InputError if there is no such generator or it does not take the
    /// arguments, if the file cannot be used (see read_mesh_file()), if the
    /// mesh has other cells than hexahedra, or if a hexahedron is inverted or
    /// degenerate.
    explicit CoarseMesh(const ShapeParameters &shape);

    /// Puts several bodies side by side, glued nowhere: their boundaries and materials
    /// get other numbers and the names 'BODY.NAME', or the name of the body if it has
    /// but one material. Throws as for each alone.
    explicit CoarseMesh(const std::vector<std::unique_ptr<PlacedBody>> &bodies);

    const dealii::Triangulation<3> &triangulation() const { return triangulation_; }

    const MeshOrigin &origin() const { return origin_; }

    /// How the body of a coarse cell is called, empty if nothing says so.
    std::string body_name(const dealii::Triangulation<3>::cell_iterator &cell) const;

    /// Makes the brick, of one material, with the boundaries of
    /// MeshNames::brick_boundaries().
    static void make_brick(const ShapeParameters &shape,
                           dealii::Triangulation<3> &triangulation);

  private:
    /// What several bodies have together while they are added one by one.
    struct Parts;

    void add_to(Parts &parts, const PlacedBody &placed) const;

    void make_cylinder(double radius, double length);

    void make_tube(double inner, double outer, double length);
    void make_half_ball(double radius);

    void generate(const ShapeParameters &shape);

    void set_names(const std::map<std::string, MeshNames::Id> &boundaries,
                   const std::map<std::string, MeshNames::Id> &materials,
                   const std::string &how_to_name);

    dealii::Triangulation<3> triangulation_;
    MeshOrigin origin_;
    std::vector<std::string> body_names_;
    std::vector<std::size_t> body_of_cell_; // in these
    std::map<dealii::types::material_id, std::string> body_of_material_;
  };

  /// Throws InputError naming a cell whose trilinear map has a determinant that
  /// is not positive at its vertices or Gauss points, or whose map of second
  /// order has one at its Gauss points. Of cells of all levels that are not
  /// artificial.
  ///
  /// @param location the beginning of a sentence about the mesh.
  void require_valid_cells(const dealii::Triangulation<3> &triangulation,
                           const QuadraticCells &quadratic_cells,
                           const std::string &location);
} // namespace stiction
