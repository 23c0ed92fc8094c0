// contact.pvtu: the contact boundaries.

#include "field_output.h"

#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/vtu.h>
#include <stiction/parameters/parameters.h>
#include <stiction/qp/node_status.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <array>
#include <cmath>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The rows of the fields in the patches.
    enum ContactRow : unsigned int
    {
      pressure_row,
      traction_row,
      slip_row              = traction_row + 3,
      gap_row               = slip_row + 3,
      normal_status_row     = gap_row + 1,
      tangential_status_row = normal_status_row + 1,
      area_row              = tangential_status_row + 1,
      slip_bound_row        = area_row + 1,
      boundary_row          = slip_bound_row + 1,
      moved_row             = boundary_row + 1,
      normal_row            = moved_row + 3,
      tangential_row        = normal_row + 3,
      n_contact_rows        = tangential_row + 3
    };

    std::vector<Field> contact_fields(const Units &units)
    {
      return {{"pressure", 1, units.stress},
              {"traction", 3, units.stress},
              {"slip", 3, units.length},
              {"gap", 1, units.length},
              {"normal_status", 1, ""},
              {"tangential_status", 1, ""},
              {"area", 1, units.area},
              {"slip_bound", 1, units.stress},
              {"boundary", 1, ""},
              {"displacement", 3, units.length},
              {"normal", 3, ""},
              {"tangential_traction", 3, units.stress}};
    }

    // One patch a face.
    class ContactOutput : public FieldOutput<2>
    {
    public:
      ContactOutput(const LinearElasticity &elasticity, const LA::Vector &u,
                    const ContactSurface &surface, const Certificate &certificate,
                    const std::vector<NodeStatus> &statuses, const Units &units)
        : FieldOutput<2>(contact_fields(units))
        , body_(elasticity.body())
        , surface_(surface)
        , certificate_(certificate)
        , statuses_(statuses)
      {
        const FiniteElement<3> &fe = body_.dof_handler().get_fe();
        // points of a patch are in the order of a table, unknowns first those
        // of the vertices, then those of the edges
        const auto order = FETools::lexicographic_to_hierarchic_numbering<2>(fe.degree);
        std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());
        FEFaceValues<3> places(body_.mapping(), fe,
                               QIterated<2>(QTrapezoid<1>(), fe.degree),
                               update_quadrature_points);
        for (const auto &cell : body_.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned())
            for (const unsigned int f : cell->face_indices())
              if (const auto face = cell->face(f);
                  face->at_boundary() && surface.is_contact_boundary(face->boundary_id()))
                {
                  face->get_dof_indices(dofs);
                  Patch patch;
                  patch.n_subdivisions       = fe.degree;
                  patch.reference_cell       = ReferenceCells::Quadrilateral;
                  patch.patch_index          = patches_.size();
                  patch.points_are_available = true; // it may be curved
                  patch.data.reinit(n_contact_rows + 3, order.size());
                  places.reinit(cell, f);
                  for (const unsigned int v : face->vertex_indices())
                    patch.vertices[v] = face->vertex(v);
                  for (unsigned int p = 0; p < order.size(); ++p)
                    {
                      const auto dof       = dofs[3 * order[p]];
                      Values values        = values_at(dof);
                      values[boundary_row] = face->boundary_id();
                      for (unsigned int c = 0; c < 3; ++c)
                        values[moved_row + c] = u(dof + c);
                      for (unsigned int k = 0; k < n_contact_rows; ++k)
                        patch.data(k, p) = static_cast<float>(values[k]);
                      for (unsigned int c = 0; c < 3; ++c)
                        patch.data(n_contact_rows + c, p) =
                          static_cast<float>(places.quadrature_point(p)[c]);
                    }
                  patches_.push_back(patch);
                }
      }

    private:
      using Values = std::array<double, n_contact_rows>;

      // At a node of the boundary, interpolated if it hangs; its status is
      // then that of the first node it follows.
      Values values_at(const types::global_dof_index first_dof) const
      {
        if (!body_.is_hanging(first_dof))
          return values_at_node(surface_.node_of(first_dof));
        Values sum{};
        const auto &masters = *body_.hanging_nodes().get_constraint_entries(first_dof);
        for (auto master = masters.rbegin(); master != masters.rend(); ++master)
          {
            const Values values = values_at_node(surface_.node_of(master->first));
            for (unsigned int k = 0; k < n_contact_rows; ++k)
              sum[k] += master->second * values[k];
            for (const auto row : {normal_status_row, tangential_status_row})
              sum[row] = values[row];
          }
        sum[area_row] = 0.; // it has none of its own
        const double length =
          std::hypot(sum[normal_row], sum[normal_row + 1], sum[normal_row + 2]);
        for (unsigned int c = 0; c < 3 && length > 0.; ++c)
          sum[normal_row + c] /= length;
        return sum;
      }

      Values values_at_node(const Eigen::Index i) const
      {
        Values values{};
        if (i < 0) // clamped or facing away: not a contact node
          {
            values[normal_status_row] = values[tangential_status_row] = -1.;
            return values;
          }
        const Eigen::Index m    = surface_.n_nodes();
        const ContactNode &node = surface_.nodes()[i];
        const auto &lambda      = certificate_.lambda();
        const auto &r           = certificate_.gradient();

        const Eigen::Vector3d force = node.force_to_cartesian(at_node(lambda, i));
        const Eigen::Vector3d slip_vector =
          node.displacement_to_cartesian({0., -r(i + m), -r(i + 2 * m)});

        values[pressure_row]          = lambda(i) / node.area;
        values[gap_row]               = r(i);
        values[area_row]              = node.area;
        values[slip_bound_row]        = certificate_.slip_bound()(i) / node.area;
        values[normal_status_row]     = static_cast<double>(statuses_[i].normal);
        values[tangential_status_row] = static_cast<double>(statuses_[i].tangential);
        for (unsigned int c = 0; c < 3; ++c)
          {
            values[traction_row + c] = -force[c] / node.area;
            values[slip_row + c]     = slip_vector[c];
            values[normal_row + c]   = node.normal[c];
            values[tangential_row + c] =
              (lambda(i) * node.normal[c] - force[c]) / node.area;
          }
        return values;
      }

      const Body &body_;
      const ContactSurface &surface_;
      const Certificate &certificate_;
      const std::vector<NodeStatus> &statuses_;
    };
  } // namespace

  void write_contact(const LinearElasticity &elasticity, const LA::Vector &u,
                     const ContactSurface &surface, const Certificate &certificate,
                     const std::vector<NodeStatus> &statuses,
                     const OutputParameters &parameters)
  {
    const Body &body = elasticity.body();
    LA::Vector with_ghosts(body.locally_owned_dofs(), body.locally_relevant_dofs(),
                           body.communicator());
    with_ghosts = u;
    with_ghosts.update_ghost_values();
    ContactOutput out(elasticity, with_ghosts, surface, certificate, statuses,
                      Units::named(parameters.units));
    out.write(parameters.directory, "contact", body.communicator());
  }
} // namespace stiction
