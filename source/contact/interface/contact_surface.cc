#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/contact/interface/state.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The slope of p F(p), p being the pressure, at a node that is pressed.
    double slope_of_bound(const FrictionData &friction, const ContactNode &node,
                          const Rubbing &at)
    {
      const double h     = 1e-5 * at.pressure;
      const auto product = [&](const double pressure) {
        return pressure * friction.value(node, {pressure, at.slip});
      };
      return (product(at.pressure + h) - product(at.pressure - h)) / (2. * h);
    }

    // Of the largest displacement: what is prescribed as zero is so but for rounding.
    constexpr double rounding_of_slip = 1e-10;

    // The place of a boundary in the list, the list's size if it is not there.
    std::size_t index_of(const std::vector<ContactBoundary> &boundaries,
                         const types::boundary_id id)
    {
      std::size_t b = 0;
      while (b < boundaries.size() && boundaries[b].id() != id)
        ++b;
      return b;
    }
  } // namespace

  ContactSurface::ContactSurface(ContactSurface &&) noexcept            = default;
  ContactSurface &ContactSurface::operator=(ContactSurface &&) noexcept = default;
  ContactSurface::~ContactSurface()                                     = default;

  std::set<types::boundary_id> ContactSurface::boundary_ids() const
  {
    std::set<types::boundary_id> ids;
    for (const ContactBoundary &boundary : boundaries_)
      ids.insert(boundary.id());
    return ids;
  }

  const ContactBoundary &ContactSurface::boundary(const types::boundary_id id) const
  {
    return boundaries_.at(index_of(boundaries_, id));
  }

  const ContactBoundary &ContactSurface::boundary_of(const ContactNode &node) const
  {
    return boundaries_[node.boundary];
  }

  bool ContactSurface::is_contact_boundary(const types::boundary_id id) const
  {
    return index_of(boundaries_, id) < boundaries_.size();
  }

  bool ContactSurface::has_obstacles() const
  {
    return !std::all_of(boundaries_.begin(), boundaries_.end(),
                        std::mem_fn(&ContactBoundary::is_pair));
  }

  bool ContactSurface::slides_far() const
  {
    return std::any_of(boundaries_.begin(), boundaries_.end(),
                       std::mem_fn(&ContactBoundary::slides_far));
  }

  bool ContactSurface::has_wavering_side() const
  {
    return std::any_of(
      boundaries_.begin(), boundaries_.end(),
      [](const ContactBoundary &boundary) { return boundary.wavers(boundary.side()); });
  }

  bool ContactSurface::is_other_side(const types::boundary_id id) const
  {
    return std::any_of(
      boundaries_.begin(), boundaries_.end(),
      [&](const ContactBoundary &boundary) { return boundary.has_partner(id); });
  }

  Eigen::Index ContactSurface::opposite_node_of(
    const types::global_dof_index first_dof) const
  {
    const auto node = opposite_node_of_dof_.find(first_dof);
    return node == opposite_node_of_dof_.end() ? -1 : node->second;
  }

  double ContactSurface::largest_coefficient() const
  {
    double largest = 0.;
    for (const ContactNode &node : nodes_) // along t1 and along t2
      largest = std::max(
        {largest, node.coefficient * node.scale[0], node.coefficient * node.scale[1]});
    return largest;
  }

  double ContactSurface::penetration_of_facing_away(const State &state) const
  {
    const Eigen::VectorXd moved = facing_away_dofs_.restriction(state.u);
    const std::size_t m         = facing_away_.size();
    double depth                = 0.;
    for (std::size_t i = 0; i < m; ++i)
      {
        const Point<3> &p               = facing_away_[i].position;
        const ContactBoundary &boundary = boundary_of(facing_away_[i]);
        const Tensor<1, 3> way = to_tensor(at_node(moved, static_cast<Eigen::Index>(i))) -
                                 obstacle_displacement(boundary.id(), state.distances);
        const double came = boundary.penetration(p + way) - boundary.penetration(p);
        if (came <= 2. * way.norm()) // what is deeper is beside an open surface
          depth = std::max(depth, came);
      }
    return depth;
  }

  std::vector<double> ContactSurface::angles() const
  {
    std::vector<double> angles;
    for (const ContactBoundary &boundary : boundaries_)
      angles.push_back(boundary.angle());
    return angles;
  }

  double ContactSurface::turned(const ContactNode &node) const
  {
    return boundary_of(node).angle() - angles_before_[node.boundary];
  }

  std::vector<double> ContactSurface::penetration_of_idle(const State &state) const
  {
    std::vector<double> depths(boundaries_.size(), 0.);
    if (idle_.empty())
      return depths;
    const Eigen::VectorXd moved = idle_B_.relative_displacement(state.u);
    for (std::size_t i = 0; i < idle_.size(); ++i)
      {
        const ContactNode &node = idle_[i];
        const Tensor<1, 3> approach =
          to_tensor(at_node(moved, static_cast<Eigen::Index>(i))) -
          obstacle_displacement(boundary_of(node).id(), state.distances);
        depths[node.boundary] =
          std::max(depths[node.boundary], approach * node.normal - node.gap);
      }
    return depths;
  }

  Tensor<1, 3> ContactSurface::obstacle_displacement(
    const types::boundary_id id, const Eigen::VectorXd &distances) const
  {
    Eigen::Index column = 0;
    for (const ContactBoundary &boundary : boundaries_)
      {
        const double force = boundary.force().norm();
        if (boundary.id() == id)
          return force > 0. && distances.size() > 0
                   ? boundary.displacement() +
                       distances(column) / force * boundary.force()
                   : boundary.displacement();
        column += force > 0. ? 1 : 0;
      }
    return {};
  }

  Eigen::VectorXd ContactSurface::approaches(const Eigen::VectorXd &gaps,
                                             const Eigen::VectorXd &ways,
                                             const Eigen::VectorXd &lambda) const
  {
    std::vector<Eigen::Index> nearest(boundaries_.size(), -1);
    std::vector<bool> is_open(boundaries_.size());
    for (std::size_t b = 0; b < boundaries_.size(); ++b)
      is_open[b] = boundaries_[b].obstacle() != nullptr;
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        const unsigned int b = nodes_[i].boundary;
        if (gaps(i) <= 0. || (lambda.size() > 0 && lambda(i) > 0.))
          is_open[b] = false;
        if (nearest[b] < 0 || gaps(i) < gaps(nearest[b]))
          nearest[b] = i;
      }
    Eigen::VectorXd all = Eigen::VectorXd::Zero(3 * n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      if (const unsigned int b = nodes_[i].boundary; is_open[b])
        set_at_node(all, i, -at_node(ways, nearest[b]));
    return all;
  }

  Eigen::VectorXd ContactSurface::slip_origin(const State &state) const
  {
    const Eigen::VectorXd gaps = gap_and_slip(state).head(n_nodes());
    const Eigen::VectorXd ways = by_nodes(n_nodes(), [&](const Eigen::Index i) {
      return nodes_[i].force_to_cartesian({gaps(i), 0., 0.});
    });
    return relative_displacement(state) + approaches(gaps, ways, state.lambda);
  }

  void ContactSurface::count_slip_from(Eigen::VectorXd origin)
  {
    if (origin.size() == 0)
      {
        origin = approach_at_start();
        if (origin.isZero(0.))
          return;
      }
    origin_                = std::move(origin);
    Eigen::VectorXd offset = motion_.offset_at_start();
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        if (slip_bound_.is_tied(i))
          continue; // it has not slipped
        const Eigen::Vector3d local =
          B_.frames()[i].displacement_to_local(at_node(origin_, i));
        for (unsigned int c = 1; c < 3; ++c)
          offset(i + c * n_nodes()) -= local(c);
      }
    motion_ = ObstacleMotion(std::move(offset), motion_.directions(), motion_.forces());
  }

  bool ContactSurface::has_friction_of_state() const
  {
    return std::any_of(boundaries_.begin(), boundaries_.end(),
                       [](const ContactBoundary &boundary) {
                         return boundary.friction().depends_on_rubbing();
                       });
  }

  void ContactSurface::set_friction(const Eigen::VectorXd &lambda,
                                    const Eigen::VectorXd &path, const FrictionForm form)
  {
    const Eigen::Index m = n_nodes();
    Eigen::VectorXd constant(m), coefficient(m);
    bool is_coulomb = false;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        ContactNode &node            = nodes_[i];
        const FrictionData &friction = boundary_of(node).friction();
        const bool has_coefficient   = friction.law() == FrictionLaw::coulomb;
        const Rubbing at{lambda.size() > 0 ? std::max(lambda(i), 0.) / node.area : 0.,
                         path(i)};
        if (friction.depends_on_rubbing())
          (has_coefficient ? node.coefficient : node.slip_stress) =
            friction.value(node, at);
        constant(i)    = node.area * node.slip_stress;
        coefficient(i) = node.coefficient;
        if (form == FrictionForm::tangent && friction.depends_on_rubbing() &&
            has_coefficient && at.pressure > 0.)
          {
            // a bound grows with the normal force and is nowhere negative
            coefficient(i) =
              std::clamp(slope_of_bound(friction, node, at), 0., node.coefficient);
            constant(i) = (node.coefficient - coefficient(i)) * lambda(i);
          }
        is_coulomb = is_coulomb || has_coefficient;
      }
    slip_bound_ = is_coulomb
                    ? qp::SlipBound::mixed(std::move(constant), std::move(coefficient))
                    : qp::SlipBound::given(std::move(constant));
  }

  Eigen::VectorXd ContactSurface::gap_and_slip(const State &state) const
  {
    Eigen::VectorXd r = motion_.offset(state.distances) - B_.apply(state.u);
    if (dragged_.empty())
      return r;
    const Eigen::VectorXd slip = slip_since_origin(state);
    for (const Eigen::Index i : dragged_)
      {
        const Eigen::Vector3d local = nodes_[i].displacement_to_local(at_node(slip, i));
        set_at_node(r, i, {r(i), local(1), local(2)});
      }
    return r;
  }

  void ContactSurface::add_friction_on_supports(State &state,
                                                const Eigen::VectorXd &before) const
  {
    if (dragged_.empty())
      return;
    const Eigen::VectorXd r     = gap_and_slip(state);
    const Eigen::VectorXd bound = slip_bound_.at(state.lambda);
    const double least          = rounding_of_slip * state.u.linfty_norm();
    for (const Eigen::Index i : dragged_)
      {
        const Eigen::Vector2d slip = -at_node(r, i).tail<2>();
        Eigen::Vector2d force      = Eigen::Vector2d::Zero();
        if (before.size() == state.lambda.size())
          force = at_node(before, i).tail<2>();
        if (slip.norm() > least)
          force = bound(i) * slip.normalized();
        else if (force.norm() > bound(i))
          force *= bound(i) / force.norm();
        set_at_node(state.lambda, i, {state.lambda(i), force(0), force(1)});
      }
  }

  Eigen::VectorXd ContactSurface::without_dragged(Eigen::VectorXd variables) const
  {
    if (variables.size() == 3 * n_nodes())
      for (const Eigen::Index i : dragged_)
        set_at_node(variables, i, {variables(i), 0., 0.});
    return variables;
  }

  Eigen::VectorXd ContactSurface::forces(const Eigen::VectorXd &lambda) const
  {
    return by_nodes(n_nodes(), [&](const Eigen::Index i) {
      return nodes_[i].force_to_cartesian(at_node(lambda, i));
    });
  }

  void ContactSurface::add_forces(const double factor, const Eigen::VectorXd &lambda,
                                  LA::Vector &dst) const
  {
    B_.add_transpose(factor, lambda, dst);
    B_.dofs().add_extension(factor * (forces(lambda) - B_.force_to_cartesian(lambda)),
                            dst);
  }

  Eigen::VectorXd ContactSurface::slip_since_origin(const State &state) const
  {
    Eigen::VectorXd slip =
      relative_displacement(state) + by_nodes(n_nodes(), [&](const Eigen::Index i) {
        return to_vector(nodes_[i].turning);
      });
    if (origin_.size() > 0)
      slip -= origin_;
    return slip;
  }

  Eigen::VectorXd ContactSurface::relative_displacement(const State &state) const
  {
    return obstacle_displacements(state.distances) - B_.relative_displacement(state.u);
  }

  Eigen::VectorXd ContactSurface::obstacle_displacements(
    const Eigen::VectorXd &distances) const
  {
    return by_nodes(n_nodes(), [&](const Eigen::Index i) {
      return to_vector(obstacle_displacement(boundary_of(nodes_[i]).id(), distances));
    });
  }

  Eigen::VectorXd ContactSurface::ways_at_start() const
  {
    return by_nodes(
      n_nodes(), [&](const Eigen::Index i) { return to_vector(nodes_[i].way_at_start); });
  }

  Eigen::VectorXd ContactSurface::approach_at_start() const
  {
    Eigen::VectorXd gaps(n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      gaps(i) = nodes_[i].gap_at_start;
    return approaches(gaps, ways_at_start(), {});
  }

  bool ContactSurface::are_obstacles_too_deep(const Eigen::VectorXd &distances) const
  {
    if (motion_.n_pressed() == 0)
      return false;
    const Eigen::VectorXd offset = motion_.offset(distances);
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      if (const ContactBoundary &boundary = boundary_of(nodes_[i]);
          !boundary.slides_far() && offset(i) < -boundary.body_size())
        return true;
    return false;
  }

  std::vector<std::pair<Eigen::Index, double>> ContactSurface::bearers_at(
    const types::global_dof_index first_dof, const types::boundary_id id,
    const unsigned int part) const
  {
    const std::size_t b = index_of(boundaries_, id);
    if (const Eigen::Index i = node_of(first_dof);
        i >= 0 && nodes_[i].boundary == b && nodes_[i].part == part)
      return {{i, 1.}};
    const auto beside = bearers_.find({first_dof, b, part});
    return beside == bearers_.end() ? decltype(beside->second)() : beside->second;
  }

  Eigen::Index ContactSurface::node_of(const types::global_dof_index first_dof) const
  {
    const auto node = node_of_dof_.find(first_dof);
    return node == node_of_dof_.end() ? -1 : node->second;
  }
} // namespace stiction
