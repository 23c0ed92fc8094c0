#include <stiction/contact/contact_surface.h>
#include <stiction/elasticity/body.h>
#include <stiction/elasticity/boundary_functions.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/errors.h>
#include <stiction/parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace stiction
{
  using namespace dealii;

  void
  set_tangents(ContactNode &node)
  {
    Tensor<1, 3> e;
    e[std::abs(node.normal[0]) > 0.9 ? 1 : 0] = 1.;
    node.tangent1 = e - (e * node.normal) * node.normal;
    node.tangent1 /= node.tangent1.norm();
    node.tangent2 = cross_product_3d(node.tangent1, node.normal);
  }



  ContactSurface::ContactSurface(const LinearElasticity &elasticity,
                                 const Parameters &parameters)
    : law_(parameters.friction.law())
  {
    const std::string entry = "Boundary conditions/Contact boundary";
    boundary_id_            = elasticity.body().boundary_names().id(
      dealii::Utilities::trim(parameters.boundary.contact_boundary),
      parameters.source.locate(entry));
    collect_nodes(elasticity);
    if (nodes_.empty())
      throw InputError(parameters.source.describe(entry) +
                       ", the displacement is prescribed at every node of "
                       "this boundary, must be a boundary with free nodes.");
    evaluate_data(parameters);
  }



  void
  ContactSurface::collect_nodes(const LinearElasticity &elasticity)
  {
    const Body &body = elasticity.body();

    // What a rank knows of a node, or all ranks together.
    enum : unsigned int
    {
      first_dof,
      area,
      normal,                // × area
      position = normal + 3, // from the owner of the node
      n_data   = position + 3
    };
    using Share = std::array<double, n_data>;
    std::map<types::global_dof_index, Share> shares;
    const auto add = [&](const types::global_dof_index dof,
                         const double weight,
                         const Share &share) {
      if (elasticity.is_prescribed(dof))
        return;
      Share &sum     = shares.emplace(dof, Share{}).first->second;
      sum[first_dof] = static_cast<double>(dof);
      for (unsigned int k = area; k < position; ++k)
        sum[k] += weight * share[k];
    };

    const FiniteElement<3> &fe = body.dof_handler().get_fe();
    const QGauss<2> quadrature(fe.degree + 1);
    FEFaceValues<3> values(body.mapping(),
                           fe,
                           quadrature,
                           update_values | update_normal_vectors |
                             update_JxW_values);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());

    for (const auto &cell : body.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == boundary_id_)
            {
              values.reinit(cell, f);
              cell->get_dof_indices(dofs);
              for (unsigned int i = 0; i < dofs.size(); i += 3)
                {
                  if (!fe.has_support_on_face(i, f))
                    continue;
                  Share share{};
                  for (const unsigned int q : values.quadrature_point_indices())
                    {
                      const double w = values.shape_value(i, q) * values.JxW(q);
                      share[area] += w;
                      for (unsigned int c = 0; c < 3; ++c)
                        share[normal + c] += w * values.normal_vector(q)[c];
                    }
                  boundary_area_ += share[area];
                  if (!elasticity.is_hanging(dofs[i]))
                    add(dofs[i], 1., share);
                  else
                    for (const auto &master :
                         *body.hanging_nodes().get_constraint_entries(dofs[i]))
                      add(master.first, master.second, share);
                }
            }
    boundary_area_ = Utilities::MPI::sum(boundary_area_, body.communicator());

    std::vector<Share> mine;
    for (const auto &share : shares)
      mine.push_back(share.second);
    shares.clear();
    for (const auto &theirs :
         Utilities::MPI::all_gather(body.communicator(), mine))
      for (const Share &share : theirs)
        {
          const auto dof =
            static_cast<types::global_dof_index>(share[first_dof]);
          Share &sum     = shares.emplace(dof, Share{}).first->second;
          sum[first_dof] = share[first_dof];
          for (unsigned int k = area; k < position; ++k)
            sum[k] += share[k];
        }

    // a node that others hang on need not be on a face of this rank
    const IndexSet &owned = body.locally_owned_dofs();
    std::vector<double> positions;
    for (const auto &share : shares)
      for (unsigned int c = 0; c < 3; ++c)
        positions.push_back(
          owned.is_element(share.first)
            ? body
                .locally_owned_nodes()[owned.index_within_set(share.first) / 3]
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
    std::sort(sorted.begin(),
              sorted.end(),
              [&](const Share &a, const Share &b) { return key(a) < key(b); });

    const std::size_t m = sorted.size();
    std::vector<types::global_dof_index> dofs_by_blocks(3 * m);
    for (std::size_t i = 0; i < m; ++i)
      {
        ContactNode node;
        for (unsigned int c = 0; c < 3; ++c)
          {
            dofs_by_blocks[i + c * m] =
              static_cast<types::global_dof_index>(sorted[i][first_dof]) + c;
            node.position[c] = sorted[i][position + c];
            node.normal[c]   = sorted[i][normal + c];
          }
        node.normal /= node.normal.norm();
        node.area = sorted[i][area];
        set_tangents(node);
        node_of_dof_[dofs_by_blocks[i]] = static_cast<Eigen::Index>(i);
        nodes_.push_back(node);
      }
    trace_ = Trace(std::move(dofs_by_blocks));
  }



  void
  ContactSurface::evaluate_data(const Parameters &parameters)
  {
    const auto read = [&](const std::string &entry,
                          const std::string &expression) {
      return ParsedFunction(expression, 1, parameters.source.locate(entry));
    };
    const ParsedFunction gap =
      read("Boundary conditions/Initial gap", parameters.boundary.initial_gap);
    const ParsedFunction coefficient =
      read("Friction/Coefficient", parameters.friction.coefficient);
    const ParsedFunction slip_stress =
      read("Friction/Slip stress", parameters.friction.slip_stress);

    const auto not_negative = [&](const ParsedFunction &function,
                                  const std::string &entry,
                                  const Point<3> &p) {
      const double value = function.value(p);
      if (value < 0.)
        {
          std::ostringstream message;
          message << parameters.source.describe(entry) << ", gives " << value
                  << " at (" << p << "), must be >= 0 everywhere.";
          throw InputError(message.str());
        }
      return value;
    };

    gaps_.resize(n_nodes());
    areas_.resize(n_nodes());
    Eigen::VectorXd bound = Eigen::VectorXd::Zero(n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        ContactNode &node = nodes_[i];
        node.gap          = gap.value(node.position);
        if (law_ == FrictionLaw::coulomb)
          node.coefficient =
            not_negative(coefficient, "Friction/Coefficient", node.position);
        if (law_ == FrictionLaw::given)
          node.slip_stress =
            not_negative(slip_stress, "Friction/Slip stress", node.position);
        gaps_(i)  = node.gap;
        areas_(i) = node.area;
        bound(i)  = law_ == FrictionLaw::coulomb ? node.coefficient
                                                 : node.area * node.slip_stress;
      }
    slip_bound_ = law_ == FrictionLaw::coulomb
                    ? qp::SlipBound::coulomb(std::move(bound))
                    : qp::SlipBound::given(std::move(bound));
  }



  Eigen::Index
  ContactSurface::node_of(const types::global_dof_index first_dof) const
  {
    const auto node = node_of_dof_.find(first_dof);
    return node == node_of_dof_.end() ? -1 : node->second;
  }



  Eigen::VectorXd
  ContactSurface::apply_B(const LA::Vector &u) const
  {
    return to_local(trace_.restriction(u));
  }



  void
  ContactSurface::add_transpose_B(const double factor,
                                  const Eigen::VectorXd &lambda,
                                  LA::Vector &dst) const
  {
    trace_.add_extension(factor * to_cartesian(lambda), dst);
  }



  Eigen::VectorXd
  ContactSurface::to_local(const Eigen::VectorXd &v) const
  {
    const Eigen::Index m = n_nodes();
    Eigen::VectorXd w(v.size());
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const Tensor<1, 3> x({v(i), v(i + m), v(i + 2 * m)});
        w(i)         = nodes_[i].normal * x;
        w(i + m)     = nodes_[i].tangent1 * x;
        w(i + 2 * m) = nodes_[i].tangent2 * x;
      }
    return w;
  }



  void
  ContactSurface::rotate_to_local(Eigen::MatrixXd &C) const
  {
    const Eigen::Index m = n_nodes();
    std::vector<Eigen::Matrix3d> R(m);
    for (Eigen::Index i = 0; i < m; ++i)
      for (unsigned int c = 0; c < 3; ++c)
        {
          R[i](0, c) = nodes_[i].normal[c];
          R[i](1, c) = nodes_[i].tangent1[c];
          R[i](2, c) = nodes_[i].tangent2[c];
        }
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index i = 0; i < m; ++i)
        {
          Eigen::Matrix3d block;
          for (Eigen::Index b = 0; b < 3; ++b)
            for (Eigen::Index a = 0; a < 3; ++a)
              block(a, b) = C(i + a * m, j + b * m);
          block = (R[i] * block * R[j].transpose()).eval();
          for (Eigen::Index b = 0; b < 3; ++b)
            for (Eigen::Index a = 0; a < 3; ++a)
              C(i + a * m, j + b * m) = block(a, b);
        }
  }



  Eigen::VectorXd
  ContactSurface::to_cartesian(const Eigen::VectorXd &v) const
  {
    const Eigen::Index m = n_nodes();
    Eigen::VectorXd w(v.size());
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const Tensor<1, 3> x = v(i) * nodes_[i].normal +
                               v(i + m) * nodes_[i].tangent1 +
                               v(i + 2 * m) * nodes_[i].tangent2;
        for (unsigned int c = 0; c < 3; ++c)
          w(i + c * m) = x[c];
      }
    return w;
  }



  bool
  ContactSurface::is_plane() const
  {
    return std::all_of(nodes_.begin(), nodes_.end(), [&](const auto &node) {
      return (node.normal - nodes_[0].normal).norm() < 1e-10;
    });
  }
} // namespace stiction
