// Nodes of several contact boundaries, or of parts of one that meet at a sharp edge: they
// bear the forces of the first of these alone. What the others exert on the area around
// them, and what there is around nodes of degree 2 of which a sliver has something
// opposite, is borne by nodes beside them, for both: a force λ_i acts by parts at node i
// and at those it bears for, and the gap and slip that it closes are the means of theirs.
// As with the crosspoints of mortar methods (B. Wohlmuth, A mortar finite element method
// using dual spaces for the Lagrange multiplier, 2000) a pressure that is the same
// everywhere is borne exactly.

#include <stiction/contact/interface/node_shares.h>

#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/pairs/held_slaves.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the area around a node: with less opposite it bears for no other.
    constexpr double least_cover_of_bearers = 0.1;

    // Of the weights by which a node sees what is opposite: their sum is 1, that of their
    // sizes 2 to 4 on meshes that do not match.
    constexpr double largest_weights = 10.;
  } // namespace

  void ContactSurface::lend_slivers(const LinearElasticity &elasticity)
  {
    const auto is_sliver = [&](const ContactNode &node) {
      if (!boundary_of(node).is_pair() || boundary_of(node).is_tied())
        return false;
      const Mortar &mortar = mortars_[node.boundary][node.part];
      const auto weights   = mortar.weights.row(mortar.row_of(node.first_dof));
      return node.area < 0. || weights.cwiseAbs().sum() > largest_weights;
    };
    std::vector<ContactNode> slivers, others, bearers;
    for (const ContactNode &node : nodes_)
      (is_sliver(node) ? slivers : others).push_back(node);
    std::copy_if(
      others.begin(), others.end(), std::back_inserter(bearers),
      [](const ContactNode &node) { return node.cover >= least_cover_of_bearers; });
    std::set<std::size_t> borne;
    for (const auto &neighbour :
         neighbours_on_boundary(elasticity, boundaries_, parts_, slivers, bearers))
      borne.insert(neighbour.row());
    for (std::size_t k = 0; k < slivers.size(); ++k)
      if (borne.count(k) > 0)
        lenders_.push_back(slivers[k]);
      else if (slivers[k].area > 0.) // a body that stands within a face of the other one
        others.push_back(slivers[k]);
    nodes_ = std::move(others);
  }

  void ContactSurface::lend_areas(const LinearElasticity &elasticity)
  {
    if (elasticity.body().dof_handler().get_fe().degree > 1)
      lend_slivers(elasticity);
    const auto k = static_cast<Eigen::Index>(lenders_.size());
    loans_.resize(n_nodes(), k);
    if (k == 0)
      return;
    // Not those that lend themselves, in a circle where owners change along an edge, nor
    // those with next to nothing of their own.
    std::set<types::global_dof_index> lend;
    for (const ContactNode &lender : lenders_)
      lend.insert(lender.first_dof);
    std::vector<ContactNode> among = nodes_;
    for (ContactNode &node : among)
      if (lend.count(node.first_dof) > 0 || node.cover < least_cover_of_bearers)
        node.boundary = numbers::invalid_unsigned_int;
    const auto neighbours =
      neighbours_on_boundary(elasticity, boundaries_, parts_, lenders_, among);
    // what is beyond an edge has no pressure
    std::set<types::global_dof_index> of_several;
    for (const ContactNode &node : nodes_)
      if (lend.count(node.first_dof) > 0)
        of_several.insert(node.first_dof);
    std::vector<Eigen::Triplet<double>> lent;
    for (const auto &neighbour : neighbours)
      {
        const ContactNode &lender = lenders_[neighbour.row()];
        if (of_several.count(lender.first_dof) > 0)
          bearers_[{lender.first_dof, lender.boundary, lender.part}].emplace_back(
            neighbour.col(), neighbour.value());
        lent.emplace_back(neighbour.col(), neighbour.row(),
                          neighbour.value() * lender.area);
      }
    for (const ContactNode &lender : lenders_)
      if (of_several.count(lender.first_dof) > 0 &&
          bearers_.count({lender.first_dof, lender.boundary, lender.part}) == 0)
        idle_.push_back(lender);
    loans_.setFromTriplets(lent.begin(), lent.end());

    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        ContactNode &node = nodes_[i];
        if (node.area + loans_.row(i).sum() <= 0.)
          loans_.row(i) *= 0.;
        const double area = node.area + loans_.row(i).sum();
        loans_.row(i) /= area;
        node.own_part = node.area / area;
        node.area     = area;
        node.gap *= node.own_part;
        node.way_at_start *= node.own_part;
        node.arm *= node.own_part;
        node.turning *= node.own_part;
        node.center *= node.own_part;
        for (decltype(loans_)::InnerIterator loan(loans_, i); loan; ++loan)
          {
            const ContactNode &lender = lenders_[loan.col()];
            node.gap += loan.value() * lender.gap;
            node.way_at_start += loan.value() * lender.way_at_start;
            node.arm += loan.value() * lender.arm;
            node.turning += loan.value() * lender.turning;
            node.center += loan.value() * lender.center;
          }
      }
  }

  ContactOperator::OtherSide ContactSurface::with_loans(
    const LinearElasticity &elasticity, const ContactOperator::OtherSide &opposite,
    const ContactOperator::OtherSide &of_lenders) const
  {
    const Eigen::Index n = opposite.weights.cols(), m = n_nodes();
    std::vector<types::global_dof_index> nodes;
    std::map<types::global_dof_index, Eigen::Index> column;
    const auto add = [&](const types::global_dof_index first_dof) {
      if (column.emplace(first_dof, nodes.size()).second)
        nodes.push_back(first_dof);
    };
    for (Eigen::Index j = 0; j < n; ++j)
      add(opposite.dofs.dofs()[j]);
    for (const ContactNode &lender : lenders_)
      add(lender.first_dof);

    const auto n_all = static_cast<Eigen::Index>(nodes.size());
    std::vector<Eigen::Triplet<double>> weights, A;
    const auto add_rows = [&](const ContactOperator::OtherSide &side,
                              const Eigen::Index from, const Eigen::Index to,
                              const double part) {
      if (n == 0)
        return; // Eigen has no rows without columns
      for (decltype(loans_)::InnerIterator w(side.weights, from); w; ++w)
        weights.emplace_back(to, w.col(), part * w.value());
      for (Eigen::Index c = 0; c < 3; ++c)
        for (decltype(loans_)::InnerIterator a(side.A, from + c * side.weights.rows()); a;
             ++a)
          A.emplace_back(to + c * m, a.col() % n + a.col() / n * n_all, part * a.value());
    };
    for (Eigen::Index i = 0; i < m; ++i)
      {
        add_rows(opposite, i, i, nodes_[i].own_part);
        for (decltype(loans_)::InnerIterator loan(loans_, i); loan; ++loan)
          {
            add_rows(of_lenders, loan.col(), i, loan.value());
            for (Eigen::Index c = 0; c < 3; ++c)
              A.emplace_back(i + c * m,
                             column.at(lenders_[loan.col()].first_dof) + c * n_all,
                             -loan.value());
          }
      }
    ContactOperator::OtherSide all;
    all.dofs    = DofSubset::of_nodes(nodes);
    all.is_free = 1. - prescribed_of(elasticity, all.dofs).array();
    all.weights.resize(m, n_all);
    all.weights.setFromTriplets(weights.begin(), weights.end());
    all.A.resize(3 * m, 3 * n_all);
    all.A.setFromTriplets(A.begin(), A.end());
    return all;
  }

} // namespace stiction
