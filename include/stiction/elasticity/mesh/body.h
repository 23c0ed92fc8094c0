#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/elasticity/mesh/coarse_mesh.h>
#include <stiction/elasticity/mesh/mesh_pieces.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  struct GeometryParameters;

  /// The mesh and the displacement unknowns on it: trilinear or triquadratic
  /// hexahedra (Q1, Q2), three unknowns a node, distributed over the ranks by
  /// p4est.
  ///
  /// Where cells of different size meet there are hanging nodes. Their
  /// displacement u = C û follows from that of other nodes; their unknowns are
  /// numbered like any, but take part in nothing: they have no stiffness, no
  /// load, no area, and whatever a vector holds there is ignored. On curved
  /// bodies they lie where their displacement comes from, on the edge or face of
  /// the large cell, or rigid rotations would strain it and moments not balance.
  class Body
  {
  public:
    /// Makes the mesh and numbers the unknowns. Collective.
    ///
    /// @param check_size is told how many cells the mesh will have once they
    ///   are known, before the cells are refined; it may throw.
    ///
    /// Throws InputError if the geometry cannot be made or its file not read,
    /// see CoarseMesh.
    Body(const GeometryParameters &geometry, MPI_Comm communicator,
         const std::function<void(double n_cells)> &check_size = {});

    /// Cuts cells into eight, and those that p4est's balance wants besides;
    /// moves cells between the ranks and numbers the unknowns anew. Whatever
    /// was made from the body before is void. Collective.
    ///
    /// Throws InputError if cells of second order are folded where they are
    /// cut.
    ///
    /// @param is_cut one flag for each active cell by its active_cell_index();
    ///   those of cells that this rank does not own are ignored.
    /// @param fields over the unknowns, with right values at hanging nodes: they
    ///   are interpolated to the new mesh.
    void refine(const std::vector<bool> &is_cut,
                const std::vector<LA::Vector *> &fields = {});

    /// Whether the mesh is uniform: then it is the last of its refinement levels.
    bool has_levels() const { return is_uniform_; }

    MPI_Comm communicator() const { return triangulation_.get_communicator(); }

    const dealii::parallel::distributed::Triangulation<3> &triangulation() const
    {
      return triangulation_;
    }

    const dealii::DoFHandler<3> &dof_handler() const { return dof_handler_; }

    /// The active cells of this rank, of dof_handler().
    auto locally_owned_cells() const
    {
      return dof_handler_.active_cell_iterators() |
             dealii::IteratorFilters::LocallyOwnedCell();
    }

    /// The trilinear displacements of the same cells, with those of all levels if the
    /// mesh has them: dof_handler() itself for elements of degree 1.
    const dealii::DoFHandler<3> &vertex_dof_handler() const
    {
      return vertex_dof_handler_ ? *vertex_dof_handler_ : dof_handler_;
    }

    /// The shape of the cells: of the degree of the elements, so that the
    /// nodes inside of edges and faces lie on curved boundaries, too. On a mesh
    /// of second order from a file all vertices and nodes lie in its cells, but
    /// for hanging ones.
    const dealii::Mapping<3> &mapping() const { return *mapping_; }

    const dealii::IndexSet &locally_owned_dofs() const
    {
      return dof_handler_.locally_owned_dofs();
    }

    /// Owned unknowns and those of neighbouring cells.
    const dealii::IndexSet &locally_relevant_dofs() const
    {
      return locally_relevant_dofs_;
    }

    /// A copy of a vector over the unknowns that knows those of neighbouring cells.
    /// Collective.
    LA::Vector with_ghosts(const LA::Vector &field) const;

    /// C: how the unknowns of hanging nodes follow from others.
    const dealii::AffineConstraints<double> &hanging_nodes() const
    {
      return hanging_nodes_;
    }
    bool is_hanging(const dealii::types::global_dof_index dof) const
    {
      return hanging_nodes_.is_constrained(dof);
    }

    /// The unknowns that one follows and their weights: those that it hangs on, or
    /// itself with 1.
    std::vector<std::pair<dealii::types::global_dof_index, double>> followed_by(
      dealii::types::global_dof_index dof) const;

    /// Hanging nodes of the whole mesh.
    dealii::types::global_dof_index n_hanging_nodes() const { return n_hanging_nodes_; }

    /// A mesh node: its unknowns along x, y, z, the place of its piece in pieces(), and
    /// where it is, in m.
    struct Node
    {
      std::array<dealii::types::global_dof_index, 3> dofs;
      unsigned int piece;
      dealii::Point<3> position;
    };

    /// The nodes whose unknowns this rank owns, in the order of the unknowns.
    const std::vector<Node> &locally_owned_nodes() const { return nodes_; }

    /// Nodes of the whole mesh, hanging ones included: a third of the
    /// unknowns.
    dealii::types::global_dof_index n_nodes() const { return dof_handler_.n_dofs() / 3; }

    /// Unknowns before adaptive refinement, the same in all of a history: those when
    /// begin_adaptive_refinement() was called, or the body was made.
    dealii::types::global_dof_index n_first_dofs() const { return n_first_dofs_; }
    void begin_adaptive_refinement() { n_first_dofs_ = dof_handler_.n_dofs(); }

    /// Where a vertex is on the curved body: of hanging ones the place that they have
    /// once they do not hang.
    const dealii::Point<3> &vertex_on_curve(
      const dealii::Triangulation<3>::active_cell_iterator &cell,
      const unsigned int v) const
    {
      return curved_vertices_.empty() ? cell->vertex(v)
                                      : curved_vertices_[cell->vertex_index(v)];
    }

    /// The smallest box around the body, in m.
    const dealii::BoundingBox<3> &bounding_box() const { return bounding_box_; }

    /// The diagonal of its bounding box, m.
    double diameter() const { return stiction::diameter(bounding_box_); }

    /// The elastic bodies that the mesh is of.
    const std::vector<Piece> &pieces() const { return pieces_.list(); }

    /// The places in pieces() of those with cells at a boundary.
    std::set<unsigned int> pieces_at(const dealii::types::boundary_id id) const
    {
      return pieces_.at_boundary(id);
    }

    /// The place in pieces() of a cell of any level.
    unsigned int piece_of(const dealii::Triangulation<3>::cell_iterator &cell) const
    {
      return pieces_.of(cell);
    }

    /// Names of elastic bodies that touch or overlap though none of these pairs of
    /// boundaries is of both.
    std::vector<std::pair<std::string, std::string>> touching_without(
      const std::vector<std::pair<dealii::types::boundary_id, dealii::types::boundary_id>>
        &pairs) const;

    /// How many elements of a file were cut into hexahedra before these were
    /// refined, by kinds: "tetrahedra". Empty if none were.
    const std::map<std::string, std::size_t> &cut_elements() const
    {
      return origin_.cut_elements;
    }

    /// What of mesh files is left out, a line each with the file's name.
    const std::vector<std::string> &left_out() const { return origin_.left_out; }

    /// Where mesh files seem to be damaged, a sentence each with the file's name.
    const std::vector<std::string> &damages() const { return origin_.damages; }

    /// The boundaries of the mesh, with their names.
    const MeshNames &boundary_names() const { return origin_.boundary_names; }

    /// The materials of the mesh, which are the material ids of its cells,
    /// with their names. Bodies that are not read from a file have the
    /// material 0 without a name.
    const MeshNames &material_names() const { return origin_.material_names; }

    /// Gives all cells that came of a coarse cell the material id of the
    /// centre of that coarse cell. Nothing changes if the function throws.
    void set_material_ids(
      const std::function<dealii::types::material_id(const dealii::Point<3> &)> &id_at);

  private:
    void make_grid(const GeometryParameters &geometry,
                   const std::function<void(double n_cells)> &check_size);

    // Gives cells that were refined the shape of the coarse ones.
    void shape_cells();

    void find_bounding_boxes();

    void distribute_dofs();

    // Puts hanging nodes of curved bodies where Σ weight × the nodes that they
    // follow is.
    void straighten_hanging_nodes();

    // The nodes of the cells around hanging nodes by active_cell_index(), those
    // that hang where they follow others. Collective.
    std::map<unsigned int, std::vector<dealii::Point<3>>> straight_nodes() const;

    // Puts vertices on the curves that new ones are to lie on.
    void put_hanging_nodes_back();

    void collect_nodes();

    dealii::parallel::distributed::Triangulation<3> triangulation_;
    dealii::FESystem<3> fe_;
    MeshOrigin origin_;
    std::string location_; // of the entry that says what the body is
    std::unique_ptr<dealii::Mapping<3>> mapping_;
    dealii::DoFHandler<3> dof_handler_;
    std::unique_ptr<dealii::DoFHandler<3>> vertex_dof_handler_; // for degree 2
    dealii::IndexSet locally_relevant_dofs_;
    bool is_uniform_ = true, is_curved_ = false;
    std::vector<dealii::Point<3>> curved_vertices_; // before hanging ones were moved
    dealii::AffineConstraints<double> hanging_nodes_;
    dealii::types::global_dof_index n_hanging_nodes_ = 0, n_first_dofs_ = 0;
    std::vector<Node> nodes_;
    MeshPieces pieces_;
    dealii::BoundingBox<3> bounding_box_;
  };
} // namespace stiction
