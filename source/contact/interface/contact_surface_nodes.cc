// Which nodes of the contact boundaries are contact nodes, and their data.

#include <stiction/base/errors.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/parameters/parameters.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Whether the bit of a component is set.
    bool has_component(const double bits, const unsigned int c)
    {
      return (static_cast<unsigned int>(bits) >> c & 1u) != 0;
    }

    std::vector<types::global_dof_index> first_dofs(const std::vector<ContactNode> &nodes)
    {
      std::vector<types::global_dof_index> dofs;
      for (const ContactNode &node : nodes)
        dofs.push_back(node.first_dof);
      return dofs;
    }
  } // namespace

  ContactSurface::ContactSurface(const LinearElasticity &elasticity,
                                 const Parameters &parameters)
    : boundaries_(ContactBoundary::read(parameters, elasticity.body()))
  {
    collect_nodes(elasticity);
    stiffness_.softest = elasticity.materials().smallest_youngs_modulus();
    require_nodes(parameters, "Boundary conditions/Contact boundary",
                  boundaries_.size() == 1
                    ? "the displacement is prescribed at every node of this "
                      "boundary, must be a boundary with free nodes"
                    : "the displacement is prescribed at every node that belongs "
                      "to no boundary before this one, must be a boundary with "
                      "free nodes of its own");
    place_obstacles();
    require_nodes(parameters, "Boundary conditions/Obstacle",
                  "no free node of the contact boundary faces it, its "
                  "surface must lie opposite to the boundary, its normal "
                  "towards the body");
    evaluate_data();
    number_nodes();
    displace_obstacles(parameters);
  }

  void ContactSurface::collect_nodes(const LinearElasticity &elasticity)
  {
    const Body &body = elasticity.body();

    // What a rank knows of a node, or all ranks together.
    enum : unsigned int
    {
      first_dof,
      boundary,
      prescribed, // components, as bits
      modulus,    // Young's, the largest
      area,
      normal,                // × area
      value    = normal + 3, // of prescribed components
      position = value + 3,  // from the owner of the node
      n_data   = position + 3
    };
    using Share = std::array<double, n_data>;
    std::map<types::global_dof_index, Share> shares;
    // A node belongs to the first of its boundaries, which is why the others'
    // shares are dropped.
    const auto add = [&](const types::global_dof_index dof, const double weight,
                         const Share &share) {
      const auto place = shares.emplace(dof, share);
      Share &sum       = place.first->second;
      if (!place.second && share[boundary] > sum[boundary])
        return;
      const bool is_new = place.second || share[boundary] < sum[boundary];
      for (unsigned int k = area; k < value; ++k)
        sum[k] = weight * share[k] + (is_new ? 0. : sum[k]);
      sum[modulus]    = std::max(share[modulus], is_new ? 0. : sum[modulus]);
      sum[first_dof]  = static_cast<double>(dof);
      sum[boundary]   = share[boundary];
      sum[prescribed] = share[prescribed];
      std::copy_n(&share[value], 3, &sum[value]);
    };
    const auto add_with_prescribed = [&](const types::global_dof_index dof,
                                         const double weight, Share share) {
      unsigned int components = 0;
      for (unsigned int c = 0; c < 3; ++c)
        if (elasticity.is_prescribed(dof + c))
          {
            components |= 1u << c;
            share[value + c] = elasticity.prescribed_value(dof + c);
          }
      if (components == 7)
        return;
      share[prescribed] = components;
      add(dof, weight, share);
    };

    const FiniteElement<3> &fe = body.dof_handler().get_fe();
    const QGauss<2> quadrature(fe.degree + 1);
    FEFaceValues<3> values(body.mapping(), fe, quadrature,
                           update_values | update_normal_vectors | update_JxW_values);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());

    for (const auto &cell : body.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              is_contact_boundary(cell->face(f)->boundary_id()))
            {
              values.reinit(cell, f);
              cell->get_dof_indices(dofs);
              for (unsigned int i = 0; i < dofs.size(); i += 3)
                {
                  if (!fe.has_support_on_face(i, f))
                    continue;
                  Share share{};
                  share[modulus] =
                    elasticity.materials().of(cell->material_id()).youngs_modulus;
                  for (const unsigned int q : values.quadrature_point_indices())
                    {
                      const double w = values.shape_value(i, q) * values.JxW(q);
                      share[area] += w;
                      for (unsigned int c = 0; c < 3; ++c)
                        share[normal + c] += w * values.normal_vector(q)[c];
                    }
                  boundary_area_ += share[area];
                  share[boundary] = static_cast<double>(
                    &this->boundary(cell->face(f)->boundary_id()) - boundaries_.data());
                  if (!elasticity.is_hanging(dofs[i]))
                    add_with_prescribed(dofs[i], 1., share);
                  else
                    for (const auto &master :
                         *body.hanging_nodes().get_constraint_entries(dofs[i]))
                      add_with_prescribed(master.first, master.second, share);
                }
            }
    boundary_area_ = Utilities::MPI::sum(boundary_area_, body.communicator());

    std::vector<Share> mine;
    for (const auto &share : shares)
      mine.push_back(share.second);
    shares.clear();
    for (const auto &theirs : Utilities::MPI::all_gather(body.communicator(), mine))
      for (const Share &share : theirs)
        add(static_cast<types::global_dof_index>(share[first_dof]), 1., share);

    // a node that others hang on need not be on a face of this rank
    const IndexSet &owned = body.locally_owned_dofs();
    std::vector<double> positions;
    for (const auto &share : shares)
      for (unsigned int c = 0; c < 3; ++c)
        positions.push_back(
          owned.is_element(share.first)
            ? body.locally_owned_nodes()[owned.index_within_set(share.first) / 3]
                .position[c]
            : 0.);
    Utilities::MPI::sum(positions, body.communicator(), positions);

    std::vector<Share> sorted;
    for (const auto &share : shares)
      {
        const std::size_t begin = 3 * sorted.size();
        sorted.push_back(share.second);
        std::copy_n(&positions[begin], 3, &sorted.back()[position]);
      }

    // The unknowns' numbers depend on the partition, places do not. Rounded,
    // because a vertex may have been computed along different edges.
    const auto corners = body.bounding_box().get_boundary_points();
    const double unit  = 1e-9 * corners.first.distance(corners.second);
    const auto key     = [&](const Share &share) {
      std::array<long long, 3> k;
      for (unsigned int c = 0; c < 3; ++c)
        k[c] = std::llround((share[position + c] - corners.first[c]) / unit);
      return k;
    };
    std::sort(sorted.begin(), sorted.end(),
              [&](const Share &a, const Share &b) { return key(a) < key(b); });

    for (const Share &share : sorted)
      {
        ContactNode node;
        for (unsigned int c = 0; c < 3; ++c)
          {
            node.position[c]                = share[position + c];
            node.normal[c]                  = share[normal + c];
            node.prescribed[c]              = has_component(share[prescribed], c);
            node.prescribed_displacement[c] = share[value + c];
          }
        node.normal /= node.normal.norm();
        node.area           = share[area];
        node.youngs_modulus = share[modulus];
        node.boundary       = static_cast<unsigned int>(share[boundary]);
        if (!set_tangents(node))
          continue;
        node.first_dof = static_cast<types::global_dof_index>(share[first_dof]);
        nodes_.push_back(node);
      }
  }

  void ContactSurface::require_nodes(const Parameters &parameters,
                                     const std::string &entry,
                                     const std::string &reason) const
  {
    std::vector<unsigned int> n(boundaries_.size(), 0);
    for (const ContactNode &node : nodes_)
      ++n[node.boundary];
    const auto empty = std::find(n.begin(), n.end(), 0u);
    if (empty == n.end())
      return;
    throw InputError(parameters.source.describe(entry) +
                     (n.size() == 1
                        ? ""
                        : ", boundary '" + boundaries_[empty - n.begin()].name() + "'") +
                     ", " + reason + ".");
  }

  void ContactSurface::place_obstacles()
  {
    std::vector<ContactNode> facing;
    for (ContactNode &node : nodes_)
      {
        if (!boundaries_[node.boundary].place(node))
          {
            facing_away_.push_back(node);
            continue;
          }
        const Tensor<1, 3> normal = node.normal;
        if (!set_tangents(node))
          continue;
        node.gap_growth = normal;
        // of a normal that is partly held, the free part has to close the gap
        if (node.is_held())
          {
            node.gap_growth /= normal * node.normal;
            node.gap = node.gap / (normal * node.normal) -
                       node.gap_growth * node.prescribed_displacement;
          }
        facing.push_back(node);
      }
    nodes_ = std::move(facing);
  }

  void ContactSurface::number_nodes()
  {
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      node_of_dof_[nodes_[i].first_dof] = i;
    B_                = ContactOperator(DofSubset::of_nodes(first_dofs(nodes_)),
                                        {nodes_.begin(), nodes_.end()});
    facing_away_dofs_ = DofSubset::of_nodes(first_dofs(facing_away_));
  }

  void ContactSurface::evaluate_data()
  {
    areas_.resize(n_nodes());
    stiffness_.youngs_moduli.resize(n_nodes());
    Eigen::VectorXd constant(n_nodes()), coefficient(n_nodes());
    bool is_coulomb = false;
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        ContactNode &node               = nodes_[i];
        const ContactBoundary &boundary = boundaries_[node.boundary];
        boundary.set_friction(node);

        areas_(i)                   = node.area;
        stiffness_.youngs_moduli(i) = node.youngs_modulus;
        constant(i)                 = node.area * node.slip_stress;
        coefficient(i)              = node.coefficient;
        is_coulomb = is_coulomb || boundary.law() == FrictionLaw::coulomb;
      }
    slip_bound_ = is_coulomb
                    ? qp::SlipBound::mixed(std::move(constant), std::move(coefficient))
                    : qp::SlipBound::given(std::move(constant));
  }

  void ContactSurface::displace_obstacles(const Parameters &parameters)
  {
    // of those with a force, the column; of the others none
    std::vector<Eigen::Index> column(boundaries_.size(), -1);
    std::vector<double> forces;
    for (std::size_t b = 0; b < boundaries_.size(); ++b)
      if (boundaries_[b].force().norm() > 0.)
        {
          column[b] = static_cast<Eigen::Index>(forces.size());
          forces.push_back(boundaries_[b].force().norm());
        }
    pressing_forces_ = Eigen::Map<const Eigen::VectorXd>(
      forces.data(), static_cast<Eigen::Index>(forces.size()));

    Eigen::VectorXd offset(3 * n_nodes());
    Eigen::MatrixXd directions =
      Eigen::MatrixXd::Zero(3 * n_nodes(), pressing_forces_.size());
    std::vector<double> largest_approach(boundaries_.size(), 0.);
    const auto seen_from = [](const ContactNode &node, const Tensor<1, 3> &displacement) {
      Eigen::Vector3d local =
        node.displacement_to_local({displacement[0], displacement[1], displacement[2]});
      local(0) = node.gap_growth * displacement;
      return local;
    };
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        const ContactNode &node         = nodes_[i];
        const ContactBoundary &boundary = boundaries_[node.boundary];
        Eigen::Vector3d e               = seen_from(node, boundary.displacement());
        e(0) += node.gap;
        if (e(0) < -boundary.body_size())
          throw InputError(
            parameters.source.describe("Boundary conditions/Obstacle displacement") +
            ", moves the obstacle of boundary '" + boundary.name() +
            "' into the body by more than the body is large, must be small "
            "like the displacements of the body.");

        set_at_node(offset, i, e);
        if (column[node.boundary] < 0)
          continue;
        const Eigen::Vector3d direction =
          seen_from(node, boundary.force() / boundary.force().norm());
        for (unsigned int c = 0; c < 3; ++c)
          directions(i + c * n_nodes(), column[node.boundary]) = direction(c);
        largest_approach[node.boundary] =
          std::max(largest_approach[node.boundary], -direction(0));
      }
    for (std::size_t b = 0; b < boundaries_.size(); ++b)
      if (column[b] >= 0 && largest_approach[b] < least_approach)
        throw InputError(
          parameters.source.describe("Boundary conditions/Obstacle force") +
          ", does not press the obstacle of boundary '" + boundaries_[b].name() +
          "' against the body, must point from the obstacle into the body.");
    motion_ = ObstacleMotion(std::move(offset), std::move(directions));
  }
} // namespace stiction
