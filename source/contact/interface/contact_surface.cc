#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/contact/interface/state.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <algorithm>
#include <array>
#include <cmath>
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

    // Of the largest displacement: less is no slip worth a word.
    constexpr double least_slip = 1e-3;

    // ... and less is none: what is prescribed as zero is so but for rounding.
    constexpr double rounding_of_slip = 1e-10;

    // Of the largest slip of a pair: beside a plane of symmetry a mean of what lies
    // opposite slips by less.
    constexpr double part_of_pair = 0.3;

    // Of the largest force of earlier steps: less friction is what a tolerance left.
    constexpr double least_friction = 1e-6;

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

  bool ContactSurface::is_contact_boundary(const types::boundary_id id) const
  {
    return index_of(boundaries_, id) < boundaries_.size();
  }

  bool ContactSurface::has_obstacles() const
  {
    return !std::all_of(
      boundaries_.begin(), boundaries_.end(),
      [](const ContactBoundary &boundary) { return boundary.is_pair(); });
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
        const ContactBoundary &boundary = boundaries_[facing_away_[i].boundary];
        const Tensor<1, 3> way = to_tensor(at_node(moved, static_cast<Eigen::Index>(i))) -
                                 obstacle_displacement(boundary.id(), state.distances);
        const double came = boundary.penetration(p + way) - boundary.penetration(p);
        if (came <= 2. * way.norm()) // what is deeper is beside an open surface
          depth = std::max(depth, came);
      }
    return depth;
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
          obstacle_displacement(boundaries_[node.boundary].id(), state.distances);
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
          return force > 0. ? boundary.displacement() +
                                distances(column) / force * boundary.force()
                            : boundary.displacement();
        column += force > 0. ? 1 : 0;
      }
    return {};
  }

  void ContactSurface::count_slip_from(const Eigen::VectorXd &origin)
  {
    if (origin.size() == 0)
      return;
    origin_                = origin;
    Eigen::VectorXd offset = motion_.offset_at_start();
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        if (slip_bound_.is_tied(i))
          continue; // it has not slipped
        const Eigen::Vector3d local =
          B_.frames()[i].displacement_to_local(at_node(origin, i));
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
        const FrictionData &friction = boundaries_[node.boundary].friction();
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
    Eigen::VectorXd forces(3 * n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      set_at_node(forces, i, nodes_[i].force_to_cartesian(at_node(lambda, i)));
    return forces;
  }

  void ContactSurface::add_forces(const double factor, const Eigen::VectorXd &lambda,
                                  LA::Vector &dst) const
  {
    B_.add_transpose(factor, lambda, dst);
    B_.dofs().add_extension(factor * (forces(lambda) - B_.force_to_cartesian(lambda)),
                            dst);
  }

  std::vector<double> ContactSurface::frictionless_parts(const State &state) const
  {
    // who has come back lacks friction as well
    const Eigen::VectorXd of_all_steps = relative_displacement(state),
                          of_this_step = slip_since_origin(state),
                          bound        = slip_bound_.at(state.lambda);
    std::vector<double> parts(boundaries_.size(), 0.), all = parts;
    std::vector<std::array<double, 3>> least(boundaries_.size());
    for (auto &of_components : least)
      of_components.fill(least_slip * state.u.linfty_norm());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      if (const ContactNode &node = nodes_[i]; boundaries_[node.boundary].is_pair())
        {
          const Tensor<1, 3> slip       = to_tensor(at_node(of_all_steps, i));
          const Tensor<1, 3> tangential = slip - (slip * node.normal) * node.normal;
          for (unsigned int c = 0; c < 3; ++c)
            least[node.boundary][c] =
              std::max(least[node.boundary][c], part_of_pair * std::abs(tangential[c]));
        }
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        const ContactNode &node = nodes_[i];
        const double force      = std::max(state.lambda(i), 0.);
        if (slip_bound_.is_tied(i))
          continue;
        all[node.boundary] += force;
        bool lacks = false; // dragged nodes have scales
        for (unsigned int c = 0; c < 3; ++c)
          lacks = lacks || (node.prescribed[c] && node.scale[0] == 0. &&
                            std::max(std::abs(at_node(of_all_steps, i)(c)),
                                     std::abs(at_node(of_this_step, i)(c))) >
                              least[node.boundary][c]);
        if (bound(i) > 0. && lacks)
          parts[node.boundary] += force;
      }
    for (std::size_t b = 0; b < parts.size(); ++b)
      parts[b] = all[b] > 0. ? parts[b] / all[b] : 0.;
    return parts;
  }

  std::vector<double> ContactSurface::falls_of_friction(const State &state) const
  {
    const Eigen::VectorXd r     = gap_and_slip(state);
    const Eigen::VectorXd &path = state.history.path;
    std::vector<double> falls(boundaries_.size(), 0.), all = falls;
    for (Eigen::Index i = 0; i < path.size(); ++i)
      {
        const ContactNode &node      = nodes_[i];
        const FrictionData &friction = boundaries_[node.boundary].friction();
        if (state.lambda(i) <= 0. || !friction.depends_on_rubbing())
          continue;
        const double pressure = state.lambda(i) / node.area;
        const double slip =
          node.displacement_to_cartesian({0., r(i + n_nodes()), r(i + 2 * n_nodes())})
            .norm();
        const double before =
                       friction.value(node, {pressure, std::max(path(i) - slip, 0.)}),
                     now = friction.value(node, {pressure, path(i)});
        const double weight =
          friction.law() == FrictionLaw::coulomb ? state.lambda(i) : node.area;
        all[node.boundary] += weight * before;
        falls[node.boundary] += weight * std::max(before - now, 0.);
      }
    for (std::size_t b = 0; b < falls.size(); ++b)
      falls[b] = all[b] > least_friction * state.scales.force ? falls[b] / all[b] : 0.;
    return falls;
  }

  Eigen::VectorXd ContactSurface::slip_since_origin(const State &state) const
  {
    Eigen::VectorXd slip = relative_displacement(state);
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
    Eigen::VectorXd all(3 * n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      {
        const Tensor<1, 3> U =
          obstacle_displacement(boundaries_[nodes_[i].boundary].id(), distances) +
          nodes_[i].turning;
        set_at_node(all, i, {U[0], U[1], U[2]});
      }
    return all;
  }

  bool ContactSurface::are_obstacles_too_deep(const Eigen::VectorXd &distances) const
  {
    return n_nodes() > 0 && motion_.n_pressed() > 0 &&
           motion_.offset(distances).head(n_nodes()).minCoeff() <
             -boundaries_.front().body_size();
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
