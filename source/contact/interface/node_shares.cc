#include <stiction/contact/interface/node_shares.h>

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
#include <tuple>
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

    // Calls back with the values of each face of the contact boundaries that this rank
    // owns, the unknowns of its cell, the place of its boundary and the part of that.
    template<typename Callback>
    void for_each_contact_face(const Body &body,
                               const std::vector<ContactBoundary> &boundaries,
                               const SmoothParts &parts, const Callback &callback)
    {
      const FiniteElement<3> &fe = body.dof_handler().get_fe();
      const QGauss<2> quadrature(fe.degree + 1);
      FEFaceValues<3> values(body.mapping(), fe, quadrature,
                             update_values | update_normal_vectors | update_JxW_values);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : body.locally_owned_cells())
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary())
              continue;
            const auto place =
              std::find_if(boundaries.begin(), boundaries.end(), [&](const auto &b) {
                return b.id() == cell->face(f)->boundary_id();
              });
            if (place == boundaries.end())
              continue;
            values.reinit(cell, f);
            cell->get_dof_indices(dofs);
            callback(cell, values, dofs, place - boundaries.begin(),
                     parts.of(cell->face(f)));
          }
    }
  } // namespace

  std::vector<Eigen::Triplet<double>> neighbours_on_boundary(
    const LinearElasticity &elasticity, const std::vector<ContactBoundary> &boundaries,
    const SmoothParts &parts, const std::vector<ContactNode> &of,
    const std::vector<ContactNode> &among)
  {
    if (of.empty())
      return {};
    using Numbers =
      std::map<std::tuple<types::global_dof_index, long, unsigned int>, unsigned int>;
    const auto numbers = [](const std::vector<ContactNode> &nodes) {
      Numbers numbers;
      for (const ContactNode &node : nodes)
        numbers.emplace(std::tuple(node.first_dof, node.boundary, node.part),
                        numbers.size());
      return numbers;
    };
    const Numbers rows = numbers(of), columns = numbers(among);
    struct Entry
    {
      unsigned int row, column;
      double weight;
    };
    std::vector<Entry> entries;
    const Body &body           = elasticity.body();
    const FiniteElement<3> &fe = body.dof_handler().get_fe();
    for_each_contact_face(
      body, boundaries, parts,
      [&](const auto &, const auto &values, const auto &dofs, const long boundary,
          const unsigned int part) {
        const auto on_face = [&](const Numbers &numbers) {
          std::vector<std::tuple<unsigned int, unsigned int, double>> found;
          for (unsigned int i = 0; i < dofs.size(); i += 3)
            if (fe.has_support_on_face(i, values.get_face_number()))
              for (const auto &[dof, weight] : body.followed_by(dofs[i]))
                if (const auto n = numbers.find({dof, boundary, part});
                    n != numbers.end())
                  found.emplace_back(i, n->second, std::abs(weight));
          return found;
        };
        const auto lenders = on_face(rows);
        if (lenders.empty())
          return;
        for (const auto &[j, column, of_column] : on_face(columns))
          for (const auto &[i, row, of_row] : lenders)
            {
              double overlap = 0.;
              for (const unsigned int q : values.quadrature_point_indices())
                overlap += std::abs(values.shape_value(i, q) * values.shape_value(j, q)) *
                           values.JxW(q);
              entries.push_back({row, column, of_row * of_column * overlap});
            }
      });
    std::map<std::pair<unsigned int, unsigned int>, double> sums;
    std::vector<double> of_rows(of.size(), 0.);
    for (const Entry &entry : all_gather(entries, body.communicator()))
      {
        sums[{entry.row, entry.column}] += entry.weight;
        of_rows[entry.row] += entry.weight;
      }
    std::vector<Eigen::Triplet<double>> neighbours;
    for (const auto &[place, weight] : sums)
      neighbours.emplace_back(place.first, place.second, weight / of_rows[place.first]);
    return neighbours;
  }

  NodeShares::NodeShares(const LinearElasticity &elasticity,
                         const std::vector<ContactBoundary> &boundaries,
                         const SmoothParts &parts)
    : elasticity_(elasticity)
    , body_(elasticity.body())
    , boundaries_(boundaries)
    , parts_(parts)
  {
    add_faces();
    exchange();
  }

  void NodeShares::add_faces()
  {
    const FiniteElement<3> &fe = body_.dof_handler().get_fe();
    for_each_contact_face(
      body_, boundaries_, parts_,
      [&](const auto &cell, const auto &values, const auto &dofs, const long place,
          const unsigned int part_of_boundary) {
        for (unsigned int i = 0; i < dofs.size(); i += 3)
          {
            if (!fe.has_support_on_face(i, values.get_face_number()))
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
              static_cast<double>(place) + (boundaries_[place].is_tied()
                                              ? 0.
                                              : static_cast<double>(boundaries_.size()));
            share[part] = part_of_boundary;
            for (const auto &[dof, weight] : body_.followed_by(dofs[i]))
              add_with_prescribed(dof, weight, share);
          }
      });
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
    const auto [place, is_new] =
      shares_.emplace(std::tuple(dof, share[boundary], share[part]), share);
    Share &sum = place->second;
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
      if (const auto dof = std::get<0>(share.first); owned.is_element(dof))
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
      std::array<long long, 9> k{};
      for (unsigned int c = 0; c < 3; ++c)
        {
          k[c]     = std::llround((share[position + c] - corner[c]) / unit);
          k[6 + c] = std::llround(1e6 * share[normal + c] / share[area]);
        }
      k[3] = std::llround(share[piece]);
      k[4] = std::llround(share[boundary]);
      k[5] = std::llround(share[part]);
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
        node.center = node.position;
        node.normal /= node.normal.norm();
        node.area           = share[area];
        node.youngs_modulus = share[modulus];
        node.boundary  = static_cast<unsigned int>(share[boundary]) % boundaries_.size();
        node.part      = static_cast<unsigned int>(share[part]);
        node.first_dof = static_cast<types::global_dof_index>(share[first_dof]);
        nodes.push_back(node);
      }
    return nodes;
  }
} // namespace stiction
