#include "contact_traction.h"

#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <limits>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of what is around a node: where less has something opposite, forces act on as much.
    // A force beyond the edge of that is as large as beside it, whatever its strip.
    constexpr double half_covered = 0.5;

    // Over which the estimate spreads the force of each node.
    Eigen::VectorXd spread_areas(const ContactSurface &surface)
    {
      Eigen::VectorXd areas = surface.areas();
      for (Eigen::Index i = 0; i < areas.size(); ++i)
        areas(i) *= std::max(half_covered / surface.nodes()[i].cover, 1.);
      return areas;
    }

    // Of what is around each node opposite, how much the contact nodes face.
    Eigen::VectorXd covers_opposite(const Body &body, const ContactSurface &surface)
    {
      const auto &W = surface.B().other_side().weights;
      if (W.cols() == 0)
        return {};
      const FiniteElement<3> &fe = body.dof_handler().get_fe();
      std::vector<double> around(W.cols(), 0.);
      FEFaceValues<3> values(body.mapping(), fe, QGauss<2>(fe.degree + 1),
                             update_values | update_JxW_values);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : body.locally_owned_cells())
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary() ||
                !surface.is_other_side(cell->face(f)->boundary_id()))
              continue;
            values.reinit(cell, f);
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); i += 3)
              {
                if (!fe.has_support_on_face(i, f))
                  continue;
                double area = 0.;
                for (const unsigned int q : values.quadrature_point_indices())
                  area += values.shape_value(i, q) * values.JxW(q);
                for (const auto &[dof, weight] : body.followed_by(dofs[i]))
                  if (const auto j = surface.opposite_node_of(dof); j >= 0)
                    around[j] += weight * area;
              }
          }
      Utilities::MPI::sum(around, body.communicator(), around);
      return (W.transpose() * surface.areas())
        .cwiseQuotient(Eigen::VectorXd::Map(around.data(), W.cols())
                         .cwiseMax(std::numeric_limits<double>::min()));
    }
  } // namespace

  ContactTraction::ContactTraction(const LinearElasticity &elasticity,
                                   const ContactSurface &surface,
                                   const Eigen::VectorXd &lambda)
    : elasticity_(elasticity)
    , surface_(surface)
    , at_nodes_(
        surface.forces(lambda).cwiseQuotient(spread_areas(surface).replicate(3, 1)))
    , fe_(elasticity.body().dof_handler().get_fe())
    , dofs_(fe_.n_dofs_per_cell())
  {
    const Eigen::VectorXd covers = covers_opposite(elasticity.body(), surface);
    const Eigen::Index m = surface.n_nodes(), n = covers.size();
    opposite_.resize(3 * n);
    for (Eigen::Index c = 0; c < 3 && n > 0; ++c)
      opposite_.segment(c * n, n) =
        (covers.array() / half_covered).max(0.).min(1.) *
        (surface.to_other_side() * at_nodes_.segment(c * m, m)).array();
  }

  std::vector<Tensor<1, 3>> ContactTraction::at_points(
    const FEFaceValues<3> &values, const DoFHandler<3>::cell_iterator &cell)
  {
    cell->get_dof_indices(dofs_);
    const unsigned int f = values.get_face_number();
    const auto id        = cell->face(f)->boundary_id();
    const auto part      = surface_.parts().of(cell->face(f));
    std::vector<std::optional<Tensor<1, 3>>> at_nodes(fe_.n_dofs_per_face(f) / 3);
    Tensor<1, 3> mean;
    double n_known = 0.;
    for (unsigned int a = 0; a < at_nodes.size(); ++a)
      {
        at_nodes[a] = at_node(dofs_[fe_.face_to_cell_index(3 * a, f)], id, part);
        if (at_nodes[a])
          {
            mean += *at_nodes[a];
            n_known += 1.;
          }
      }
    if (n_known == 0.)
      return {};
    mean /= n_known;

    std::vector<Tensor<1, 3>> tractions(values.n_quadrature_points);
    for (unsigned int a = 0; a < at_nodes.size(); ++a)
      for (unsigned int q = 0; q < tractions.size(); ++q)
        tractions[q] += values.shape_value(fe_.face_to_cell_index(3 * a, f), q) *
                        at_nodes[a].value_or(mean);
    return tractions;
  }

  std::optional<Tensor<1, 3>> ContactTraction::at_node(
    const types::global_dof_index first_dof, const types::boundary_id id,
    const unsigned int part) const
  {
    Tensor<1, 3> traction;
    for (const auto &[dof, weight] : elasticity_.body().followed_by(first_dof))
      {
        const Eigen::Index j =
          surface_.is_other_side(id) ? surface_.opposite_node_of(dof) : -1;
        const auto bearers = surface_.bearers_at(dof, id, part);
        const bool is_elsewhere =
          bearers.empty() &&
          (surface_.node_of(dof) >= 0 || elasticity_.is_prescribed(dof) ||
           elasticity_.is_prescribed(dof + 1) || elasticity_.is_prescribed(dof + 2));
        if (j < 0 && is_elsewhere)
          return std::nullopt;
        for (unsigned int c = 0; c < 3; ++c)
          if (j >= 0)
            traction[c] += weight * opposite_(j + c * opposite_.size() / 3);
          else
            for (const auto &[i, share] : bearers)
              traction[c] -= weight * share * at_nodes_(i + c * surface_.n_nodes());
      }
    return traction;
  }
} // namespace stiction
