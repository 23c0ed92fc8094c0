#include "node_shares.h"

#include <stiction/base/all_gather.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>

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
  } // namespace

  NodeShares::NodeShares(const LinearElasticity &elasticity,
                         const std::vector<ContactBoundary> &boundaries)
    : elasticity_(elasticity)
    , body_(elasticity.body())
    , boundaries_(boundaries)
  {
    add_faces();
    exchange();
  }

  void NodeShares::add_faces()
  {
    const FiniteElement<3> &fe = body_.dof_handler().get_fe();
    const QGauss<2> quadrature(fe.degree + 1);
    FEFaceValues<3> values(body_.mapping(), fe, quadrature,
                           update_values | update_normal_vectors | update_JxW_values);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());

    for (const auto &cell : body_.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary())
              continue;
            const auto place =
              std::find_if(boundaries_.begin(), boundaries_.end(), [&](const auto &b) {
                return b.id() == cell->face(f)->boundary_id();
              });
            if (place == boundaries_.end())
              continue;
            values.reinit(cell, f);
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); i += 3)
              {
                if (!fe.has_support_on_face(i, f))
                  continue;
                Share share{};
                share[modulus] =
                  elasticity_.materials().of(cell->material_id()).youngs_modulus;
                for (const unsigned int q : values.quadrature_point_indices())
                  {
                    const double w = values.shape_value(i, q) * values.JxW(q);
                    share[area] += w;
                    for (unsigned int c = 0; c < 3; ++c)
                      share[normal + c] += w * values.normal_vector(q)[c];
                  }
                boundary_area_ += share[area];
                share[boundary] =
                  static_cast<double>(place - boundaries_.begin()) +
                  (place->is_tied() ? 0. : static_cast<double>(boundaries_.size()));
                for (const auto &[dof, weight] : body_.followed_by(dofs[i]))
                  add_with_prescribed(dof, weight, share);
              }
          }
    boundary_area_ = Utilities::MPI::sum(boundary_area_, body_.communicator());
  }

  void NodeShares::add_with_prescribed(const types::global_dof_index dof,
                                       const double weight, Share share)
  {
    unsigned int components = 0;
    for (unsigned int c = 0; c < 3; ++c)
      if (elasticity_.is_prescribed(dof + c))
        components |= 1u << c;
    share[prescribed] = components;
    add(dof, weight, share);
  }

  void NodeShares::add(const types::global_dof_index dof, const double weight,
                       const Share &share)
  {
    const auto [place, is_new] = shares_.emplace(std::pair(dof, share[boundary]), share);
    Share &sum                 = place->second;
    for (unsigned int k = area; k < position; ++k)
      sum[k] = weight * share[k] + (is_new ? 0. : sum[k]);
    sum[modulus]   = std::max(share[modulus], is_new ? 0. : sum[modulus]);
    sum[first_dof] = static_cast<double>(dof);
  }

  void NodeShares::exchange()
  {
    std::vector<Share> mine;
    for (const auto &share : shares_)
      mine.push_back(share.second);
    shares_.clear();
    for (const Share &share : all_gather(mine, body_.communicator()))
      add(static_cast<types::global_dof_index>(share[first_dof]), 1., share);
  }

  std::vector<NodeShares::Share> NodeShares::with_places() const
  {
    // a node that others hang on need not be on a face of this rank
    const IndexSet &owned = body_.locally_owned_dofs();
    std::vector<double> places;
    for (const auto &share : shares_)
      if (const auto dof = share.first.first; owned.is_element(dof))
        {
          const Body::Node &node =
            body_.locally_owned_nodes()[owned.index_within_set(dof) / 3];
          for (unsigned int c = 0; c < 3; ++c)
            places.push_back(node.position[c]);
          places.push_back(node.piece);
        }
      else
        places.resize(places.size() + 4, 0.);
    Utilities::MPI::sum(places, body_.communicator(), places);

    std::vector<Share> all;
    for (const auto &share : shares_)
      {
        const std::size_t begin = 4 * all.size();
        all.push_back(share.second);
        std::copy_n(&places[begin], 4, &all.back()[position]);
      }
    return all;
  }

  std::vector<ContactNode> NodeShares::nodes() const
  {
    // The unknowns' numbers depend on the partition, places do not. Rounded,
    // because a vertex may have been computed along different edges. Bodies, boundaries
    // and the lips of a crack have nodes at the same places.
    std::vector<Share> sorted = with_places();
    const Point<3> &corner    = body_.bounding_box().get_boundary_points().first;
    const double unit         = 1e-9 * body_.diameter();
    const auto key            = [&](const Share &share) {
      std::array<long long, 8> k{};
      for (unsigned int c = 0; c < 3; ++c)
        {
          k[c]     = std::llround((share[position + c] - corner[c]) / unit);
          k[5 + c] = std::llround(1e6 * share[normal + c] / share[area]);
        }
      k[3] = std::llround(share[piece]);
      k[4] = std::llround(share[boundary]);
      return k;
    };
    std::sort(sorted.begin(), sorted.end(),
              [&](const Share &a, const Share &b) { return key(a) < key(b); });

    std::vector<ContactNode> nodes;
    for (const Share &share : sorted)
      {
        ContactNode node;
        for (unsigned int c = 0; c < 3; ++c)
          {
            node.position[c]   = share[position + c];
            node.normal[c]     = share[normal + c];
            node.prescribed[c] = has_component(share[prescribed], c);
          }
        node.normal /= node.normal.norm();
        node.area           = share[area];
        node.youngs_modulus = share[modulus];
        node.boundary  = static_cast<unsigned int>(share[boundary]) % boundaries_.size();
        node.first_dof = static_cast<types::global_dof_index>(share[first_dof]);
        nodes.push_back(node);
      }
    return nodes;
  }
} // namespace stiction
