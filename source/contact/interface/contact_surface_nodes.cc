// Which nodes of the contact boundaries are contact nodes, their data, and what they
// face.

#include <stiction/contact/interface/node_shares.h>

#include <stiction/base/errors.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_pair_parameters.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/obstacles/pressed_obstacles.h>
#include <stiction/contact/pairs/held_slaves.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/contact/pairs/rigid_turn.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <map>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of a pair the side with the forces need not be the one that it says.
    const std::string contact_boundary_entry = "Boundary conditions/Contact boundary";

    // Of the area around a node: with less opposite it is beyond an edge.
    constexpr double mostly_covered = 0.5;

    std::vector<types::global_dof_index> first_dofs_of(
      const std::vector<ContactNode> &nodes)
    {
      std::vector<types::global_dof_index> dofs;
      for (const ContactNode &node : nodes)
        dofs.push_back(node.first_dof);
      return dofs;
    }
  } // namespace

  ContactSurface::ContactSurface(const LinearElasticity &elasticity,
                                 const ContactParameters &parameters,
                                 const SlipHistory &history, const State *const there,
                                 const ContactSurface *const before)
    : boundaries_(ContactBoundary::read(parameters, elasticity.body(), elasticity.time()))
    , angles_before_(history.angles)
  {
    angles_before_.resize(boundaries_.size());
    if (before != nullptr)
      join_pairs_as(*before);
    else
      join_pairs(elasticity);
    collect_nodes(elasticity);
    stiffness_.softest = elasticity.materials().smallest_youngs_modulus();
    require_nodes(contact_boundary_entry,
                  "the displacement is prescribed at every node of this "
                  "boundary, must be a boundary with free nodes");
    move_nodes(there);
    place_obstacles();
    require_nodes("Boundary conditions/Obstacle",
                  "no free node of the contact boundary faces it, its surface must lie "
                  "opposite to the boundary, its normal towards the body",
                  ", and nearer than the smaller of both is large");
    lend_areas(elasticity);
    evaluate_data();
    number_nodes(elasticity);
    find_dragged_nodes();
    displace_obstacles();
    count_slip_from(on_nodes(history, *this).origin);
  }

  void ContactSurface::collect_nodes(const LinearElasticity &elasticity)
  {
    const NodeShares shares(elasticity, boundaries_, parts_);
    boundary_area_ = shares.boundary_area();
    for (ContactNode node : shares.nodes())
      (set_tangents(node) ? nodes_ : idle_).push_back(node);
  }

  void ContactSurface::move_nodes(const State *const there)
  {
    if (!slides_far())
      return;
    const auto move = [&](std::vector<ContactNode> &nodes) {
      Eigen::VectorXd u =
        Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(nodes.size()));
      if (there != nullptr)
        u = DofSubset::of_nodes(first_dofs_of(nodes)).restriction(there->u);
      const Eigen::VectorXd distances =
        there != nullptr ? there->distances : Eigen::VectorXd();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (const ContactBoundary &boundary = boundary_of(nodes[i]);
            boundary.slides_far())
          nodes[i].moved = to_tensor(at_node(u, static_cast<Eigen::Index>(i))) -
                           obstacle_displacement(boundary.id(), distances);
    };
    move(nodes_);
    move(idle_);
  }

  void ContactSurface::require_nodes(const std::string &entry, const std::string &reason,
                                     const std::string &of_pair) const
  {
    std::vector<unsigned int> n(boundaries_.size(), 0);
    for (const ContactNode &node : nodes_)
      ++n[node.boundary];
    const auto empty = std::find(n.begin(), n.end(), 0u);
    if (empty == n.end())
      return;
    const auto b                    = static_cast<unsigned int>(empty - n.begin());
    const ContactBoundary &boundary = boundaries_[b];
    if (std::any_of(lenders_.begin(), lenders_.end(),
                    [&](const ContactNode &lender) { return lender.boundary == b; }))
      boundary.source().refuse(
        contact_boundary_entry,
        "all nodes of boundary '" + boundary.name() +
          "' bear the forces of one before it, must have nodes of its own: finer cells, "
          "or its place before that one");
    boundary.source().refuse(
      entry, (n.size() == 1 && !(boundary.is_pair() && entry == contact_boundary_entry)
                ? ""
                : "boundary '" + boundary.name() + "', ") +
               reason + (boundary.is_pair() ? of_pair : ""));
  }

  bool ContactSurface::place(ContactNode &node) const
  {
    const ContactBoundary &boundary = boundary_of(node);
    ContactNode at_start            = node;
    at_start.moved                  = {};
    const bool faces = boundary.is_pair() ? place_in_pair(node) : boundary.place(node);
    if (node.moved.norm() == 0. || boundary.obstacle() == nullptr)
      at_start = node;
    else
      boundary.place_if_possible(at_start);
    node.gap_at_start = at_start.gap;
    node.way_at_start = at_start.gap * at_start.normal;
    if (boundary.is_pair() || !faces)
      return faces;
    // the axis moves along with the obstacle
    const Tensor<1, 3> across = node.moved - (node.normal * node.moved) * node.normal;
    node.arm = boundary.arm(node.position + across + node.gap * node.normal, node.normal);
    node.turning = turned(node) * node.arm;
    return true;
  }

  void ContactSurface::place_obstacles()
  {
    std::vector<ContactNode> placed, away, facing, held;
    for (ContactNode &node : nodes_)
      {
        const ContactBoundary &boundary = boundary_of(node);
        if (!place(node))
          {
            if (!boundary.is_pair())
              away.push_back(node);
          }
        else if (set_tangents(node))
          placed.push_back(node);
        else if (!boundary.is_tied())
          held.push_back(node);
      }
    // A node bears the forces of the first of its boundaries; of tied ones before others,
    // as a hole in a part is worse than a node without contact. Of the parts of a
    // boundary it is the one with the smallest gap.
    std::map<types::global_dof_index, std::size_t> bearing;
    for (std::size_t i = 0; i < placed.size(); ++i)
      {
        std::size_t &best = bearing.emplace(placed[i].first_dof, i).first->second;
        if (placed[i].boundary == placed[best].boundary &&
            placed[i].gap < placed[best].gap)
          best = i;
      }
    for (std::size_t i = 0; i < placed.size(); ++i)
      if (bearing[placed[i].first_dof] == i)
        facing.push_back(placed[i]);
      else if (!boundary_of(placed[i]).is_tied())
        lenders_.push_back(placed[i]);
    for (const ContactNode &node : away)
      if (bearing.count(node.first_dof) == 0)
        {
          boundary_of(node).require_outside(node);
          facing_away_.push_back(node);
        }
    nodes_ = std::move(facing);

    // what is wrong for a node that bears nothing is no reason to refuse a problem
    for (ContactNode &node : idle_)
      try
        {
          if (!boundary_of(node).is_tied() && place(node) && node.cover > mostly_covered)
            held.push_back(node);
        }
      catch (const InputError &)
        {
        }
    idle_ = std::move(held);
  }

  void ContactSurface::number_nodes(const LinearElasticity &elasticity)
  {
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      node_of_dof_[nodes_[i].first_dof] = i;
    B_ = contact_operator(elasticity, nodes_);
    for (Eigen::Index j = 0; j < B_.other_side().weights.cols(); ++j)
      opposite_node_of_dof_[B_.other_side().dofs.dofs()[j]] = j;
    if (loans_.nonZeros() > 0)
      B_ = {B_.dofs(), B_.frames(),
            with_loans(elasticity, B_.other_side(),
                       contact_operator(elasticity, lenders_).other_side())};
    idle_B_ = contact_operator(elasticity, idle_);
    find_weights_of_other_side();
    facing_away_dofs_ = DofSubset::of_nodes(first_dofs_of(facing_away_));
  }

  ContactOperator ContactSurface::contact_operator(
    const LinearElasticity &elasticity, const std::vector<ContactNode> &nodes) const
  {
    if (nodes.empty())
      return {};
    const DofSubset own = DofSubset::of_nodes(first_dofs_of(nodes));
    return {own, {nodes.begin(), nodes.end()}, other_side(elasticity, own, nodes)};
  }

  ContactOperator::OtherSide ContactSurface::other_side(
    const LinearElasticity &elasticity, const DofSubset &own,
    const std::vector<ContactNode> &nodes) const
  {
    const auto n_rows = static_cast<Eigen::Index>(nodes.size());
    std::vector<types::global_dof_index> masters;
    for (const auto &of_parts : mortars_)
      for (const Mortar &mortar : of_parts)
        masters.insert(masters.end(), mortar.masters.begin(), mortar.masters.end());
    if (masters.empty())
      return {};
    sort_once(masters);
    using Matrix          = decltype(Mortar::weights);
    const auto of_mortars = [&](const Matrix Mortar::*const of_mortar) {
      std::vector<Eigen::Triplet<double>> entries;
      for (Eigen::Index i = 0; i < n_rows; ++i)
        if (const auto &of_parts = mortars_[nodes[i].boundary]; !of_parts.empty())
          {
            const Mortar &mortar = of_parts[nodes[i].part];
            for (Matrix::InnerIterator a(mortar.*of_mortar,
                                         mortar.row_of(nodes[i].first_dof));
                 a; ++a)
              entries.emplace_back(i, place_in(masters, mortar.masters[a.col()]),
                                   a.value());
          }
      Matrix matrix(n_rows, static_cast<Eigen::Index>(masters.size()));
      matrix.setFromTriplets(entries.begin(), entries.end());
      return matrix;
    };

    ContactOperator::OtherSide other;
    other.dofs        = DofSubset::of_nodes(masters);
    other.is_free     = 1. - prescribed_of(elasticity, other.dofs).array();
    other.weights     = of_mortars(&Mortar::weights);
    LA::Vector places = elasticity.zero_vector();
    for (const Body::Node &node : elasticity.body().locally_owned_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        places(node.dofs[c]) = node.position[c];
    std::vector<unsigned int> pairs;
    for (const ContactNode &node : nodes)
      pairs.push_back(node.boundary + boundaries_.size() * node.part);
    other.A =
      with_rigid_turns(other.weights, of_mortars(&Mortar::overlaps),
                       own.restriction(places), other.dofs.restriction(places), pairs);
    return other;
  }

  void ContactSurface::find_weights_of_other_side()
  {
    if (!B_.has_other_side())
      return; // Eigen knows no product of sparse matrices without columns
    const auto &other = B_.other_side();
    // with their signs, sums of a node that the slave hardly covers may be rounding
    to_other_side_ = other.weights.cwiseAbs().transpose() * areas_.asDiagonal();
    const Eigen::VectorXd of_nodes = to_other_side_ * Eigen::VectorXd::Ones(n_nodes());
    for (Eigen::Index j = 0; j < of_nodes.size(); ++j)
      to_other_side_.row(j) *= of_nodes(j) > 0. ? 1. / of_nodes(j) : 0.;
  }

  void ContactSurface::evaluate_data()
  {
    areas_.resize(n_nodes());
    stiffness_.youngs_moduli.resize(n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        ContactNode &node = nodes_[i];
        boundary_of(node).friction().set(node);
        areas_(i)                   = node.area;
        stiffness_.youngs_moduli(i) = node.youngs_modulus;
      }
    set_friction({}, Eigen::VectorXd::Zero(n_nodes()), FrictionForm::value);
  }

  void ContactSurface::find_dragged_nodes()
  {
    constexpr double rounding = 1e-6; // normals of a mesh are no better known
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        ContactNode &node               = nodes_[i];
        const ContactBoundary &boundary = boundary_of(node);
        const Tensor<1, 3> &P           = boundary.force();
        // friction is along the slip, and moves neither obstacles nor anything opposite
        const bool is_isotropic = !boundary.friction().is_orthotropic();
        const bool is_normal    = (node.normal - node.free_normal).norm() <= rounding;
        const bool is_pressed_straight =
          (P - (P * node.normal) * node.normal).norm() <= rounding * P.norm();
        if (node.scale[0] == 0. && node.scale[1] == 0. && !boundary.is_pair() &&
            is_isotropic && is_normal && is_pressed_straight)
          {
            node.scale = {{1., 1.}};
            dragged_.push_back(i);
          }
      }
  }

  void ContactSurface::displace_obstacles()
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
    Eigen::VectorXd offset(3 * n_nodes());
    Eigen::MatrixXd directions =
      Eigen::MatrixXd::Zero(3 * n_nodes(), static_cast<Eigen::Index>(forces.size()));
    std::vector<double> largest_approach(boundaries_.size(), 0.);
    const auto seen_from = [](const ContactFrame &frame, const Tensor<1, 3> &U) {
      return frame.displacement_to_local(to_vector(U));
    };
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        const ContactNode &node         = nodes_[i];
        const ContactBoundary &boundary = boundary_of(node);
        const ContactFrame &frame       = B_.frames()[i];
        Eigen::Vector3d e               = seen_from(frame, boundary.displacement());
        e(0) += node.gap;
        e.tail<2>() += seen_from(frame, node.turning).tail<2>();
        if (e(0) < -boundary.body_size() && !boundary.slides_far())
          boundary.source().refuse(
            boundary.displacement().norm() > 0.
              ? "Boundary conditions/Obstacle displacement"
              : "Boundary conditions/Initial gap",
            "has the obstacle of boundary '" + boundary.name() +
              "' inside of the body by more than the body is large, must be small like "
              "the displacements of the body");

        set_at_node(offset, i, e);
        if (column[node.boundary] < 0)
          continue;
        const Eigen::Vector3d direction =
          seen_from(frame, boundary.force() / boundary.force().norm());
        for (unsigned int c = 0; c < 3; ++c)
          directions(i + c * n_nodes(), column[node.boundary]) = direction(c);
        largest_approach[node.boundary] =
          std::max(largest_approach[node.boundary], -direction(0));
      }
    for (std::size_t b = 0; b < boundaries_.size(); ++b)
      boundaries_[b].source().require(
        column[b] < 0 || largest_approach[b] > least_approach,
        "Boundary conditions/Obstacle force",
        "does not press the obstacle of boundary '" + boundaries_[b].name() +
          "' against the body, must point from the obstacle into the body");
    motion_ = ObstacleMotion(std::move(offset), std::move(directions),
                             Eigen::Map<const Eigen::VectorXd>(
                               forces.data(), static_cast<Eigen::Index>(forces.size())));
  }
} // namespace stiction
