// The mesh of several bodies, of which each is made as if it were alone.

#include <stiction/elasticity/mesh/coarse_mesh.h>
#include <stiction/elasticity/mesh/placed_body.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold.h>

#include <algorithm>
#include <set>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The manifold of a shape where the body is placed.
    class PlacedManifold : public Manifold<3>
    {
    public:
      // The body must outlive the manifold.
      PlacedManifold(const PlacedBody &placed, const Manifold<3> &of_shape)
        : placed_(placed)
        , of_shape_(of_shape.clone())
      {
      }

      std::unique_ptr<Manifold<3>> clone() const override
      {
        return std::make_unique<PlacedManifold>(placed_, *of_shape_);
      }

      Point<3> get_new_point(const ArrayView<const Point<3>> &points,
                             const ArrayView<const double> &weights) const override
      {
        std::vector<Point<3>> in_shape;
        for (const Point<3> &p : points)
          in_shape.push_back(placed_.in_shape(p));
        return placed_.place(
          of_shape_->get_new_point(make_array_view(in_shape), weights));
      }

    private:
      const PlacedBody &placed_;
      const std::unique_ptr<Manifold<3>> of_shape_;
    };

    // The nodes of all active cells, x first, then y, z: those of the cells of second
    // order that they are or came of, or on the curves of the mesh.
    QuadraticCells::Nodes quadratic_nodes(const Triangulation<3> &triangulation,
                                          const QuadraticCells &cells)
    {
      std::vector<Point<3>> unit_points;
      for (const double z : {0., .5, 1.})
        for (const double y : {0., .5, 1.})
          for (const double x : {0., .5, 1.})
            unit_points.emplace_back(x, y, z);
      const MappingQ<3> mapping(2);
      const FE_Q<3> fe(1);
      FEValues<3> values(mapping, fe, Quadrature<3>(unit_points),
                         update_quadrature_points);
      QuadraticCells::Nodes all;
      for (const auto &cell : triangulation.active_cell_iterators())
        {
          all.emplace_back();
          if (cells.empty())
            values.reinit(cell);
          for (unsigned int i = 0; i < 27; ++i)
            all.back()[i] = cells.empty() ? values.quadrature_point(i)
                                          : cells.position(cell, unit_points[i]);
        }
      return all;
    }

    // Those above all of them.
    template<typename Ids> unsigned int first_free(const Ids &ids)
    {
      return ids.empty() ? 0 : *ids.rbegin() + 1;
    }
  } // namespace

  struct CoarseMesh::Parts
  {
    std::vector<Point<3>> vertices;
    std::vector<CellData<3>> cells;
    SubCellData faces;
    QuadraticCells::Nodes nodes; // of all cells if there are any
    std::map<types::manifold_id, std::unique_ptr<Manifold<3>>> manifolds;
    std::set<MeshNames::Id> boundary_ids, material_ids;
    std::map<std::string, MeshNames::Id> boundaries, materials;
    std::map<types::material_id, std::string> body_names;
    std::map<std::string, std::size_t> cut_elements;
    std::vector<std::string> left_out, damages;
    bool is_quadratic = false;
  };

  CoarseMesh::CoarseMesh(const std::vector<std::unique_ptr<PlacedBody>> &bodies)
    : triangulation_(Triangulation<3>::none, false)
  {
    Parts parts;
    std::vector<std::unique_ptr<CoarseMesh>> meshes;
    for (const auto &placed : bodies)
      {
        meshes.push_back(std::make_unique<CoarseMesh>(*placed));
        parts.is_quadratic =
          parts.is_quadratic || !meshes.back()->origin_.quadratic_cells.empty();
      }
    for (std::size_t b = 0; b < bodies.size(); ++b)
      meshes[b]->add_to(parts, *bodies[b]);

    triangulation_.create_triangulation(parts.vertices, parts.cells, parts.faces);
    for (const auto &[id, manifold] : parts.manifolds)
      triangulation_.set_manifold(id, *manifold);
    if (parts.is_quadratic)
      origin_.quadratic_cells = QuadraticCells(std::move(parts.nodes));
    origin_.cut_elements = parts.cut_elements;
    origin_.left_out     = parts.left_out;
    origin_.damages      = parts.damages;
    origin_.boundary_names =
      MeshNames("boundary", parts.boundary_ids, parts.boundaries, parts.materials);
    origin_.material_names =
      MeshNames("material", parts.material_ids, parts.materials, parts.boundaries);
    body_of_material_ = parts.body_names;
  }

  void CoarseMesh::add_to(Parts &parts, const PlacedBody &placed) const
  {
    // refined by itself, with the shape that it has alone
    Triangulation<3> refined(Triangulation<3>::none, false);
    refined.copy_triangulation(triangulation_);
    refined.refine_global(placed.refinement);
    if (!origin_.quadratic_cells.empty())
      origin_.quadratic_cells.place_vertices(refined);
    if (placed.refinement > 0) // the coarse ones are
      require_valid_cells(refined, origin_.quadratic_cells, placed.location);
    Triangulation<3> flat(Triangulation<3>::none, false);
    GridGenerator::flatten_triangulation(refined, flat);
    for (const auto id : triangulation_.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        flat.set_manifold(id, triangulation_.get_manifold(id));

    if (parts.is_quadratic)
      for (auto nodes : quadratic_nodes(refined, origin_.quadratic_cells))
        {
          for (Point<3> &node : nodes)
            node = placed.place(node);
          parts.nodes.push_back(nodes);
        }

    auto [vertices, cells, faces]     = GridTools::get_coarse_mesh_description(flat);
    const auto first_vertex           = static_cast<unsigned int>(parts.vertices.size());
    const unsigned int first_boundary = first_free(parts.boundary_ids);
    const unsigned int first_material = first_free(parts.material_ids);
    const auto first_manifold         = static_cast<types::manifold_id>(
      parts.manifolds.empty() ? 0 : parts.manifolds.rbegin()->first + 1);
    const auto move = [&](auto &of_mesh, auto &all) {
      for (auto &cell : of_mesh)
        {
          for (unsigned int &v : cell.vertices)
            v += first_vertex;
          if (cell.manifold_id != numbers::flat_manifold_id)
            cell.manifold_id += first_manifold;
          all.push_back(cell);
        }
    };
    for (const Point<3> &p : vertices)
      parts.vertices.push_back(placed.place(p));
    const bool is_one_material =
      placed.youngs_modulus || origin_.material_names.ids().size() == 1;
    for (auto &cell : cells)
      cell.material_id = first_material + (is_one_material ? 0 : cell.material_id);
    for (auto &face : faces.boundary_quads)
      if (face.boundary_id != numbers::internal_face_boundary_id)
        face.boundary_id += first_boundary;
    move(cells, parts.cells);
    move(faces.boundary_quads, parts.faces.boundary_quads);
    move(faces.boundary_lines, parts.faces.boundary_lines);
    for (const auto id : flat.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        parts.manifolds[first_manifold + id] =
          std::make_unique<PlacedManifold>(placed, flat.get_manifold(id));

    for (const MeshNames::Id id : origin_.boundary_names.ids())
      {
        parts.boundary_ids.insert(first_boundary + id);
        parts.boundaries[placed.name + '.' + origin_.boundary_names.name(id)] =
          first_boundary + id;
      }
    const auto add_material = [&](const MeshNames::Id id, const std::string &name) {
      parts.material_ids.insert(id);
      parts.materials[name] = id;
      parts.body_names[id]  = placed.name;
    };
    if (is_one_material)
      add_material(first_material, placed.name);
    else
      for (const MeshNames::Id id : origin_.material_names.ids())
        add_material(first_material + id,
                     placed.name + '.' + origin_.material_names.name(id));
    for (const auto &[kind, n] : origin_.cut_elements)
      parts.cut_elements[kind] += n;
    // of a file that several bodies are made of once
    const auto add = [](const std::vector<std::string> &of_body,
                        std::vector<std::string> &all) {
      for (const std::string &what : of_body)
        if (std::find(all.begin(), all.end(), what) == all.end())
          all.push_back(what);
    };
    add(origin_.left_out, parts.left_out);
    add(origin_.damages, parts.damages);
  }
} // namespace stiction
