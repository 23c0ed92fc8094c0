// What a user should know of an answer that the certificate does not tell.

#include <stiction/base/log.h>
#include <stiction/base/units.h>
#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/certificate/friction_limit.h>
#include <stiction/contact/certificate/obstacle_departure.h>
#include <stiction/contact/certificate/pair_figures.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/pairs/surface_face.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/output/history/step_history.h>
#include <stiction/qp/advice.h>
#include <stiction/qp/node_status.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/warnings/body_warnings.h>
#include <stiction/simulation/warnings/facet_warnings.h>
#include <stiction/simulation/warnings/pair_warnings.h>
#include <stiction/simulation/warnings/warning.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace stiction
{
  namespace
  {
    // Of the forces on a body: more is worth a word.
    constexpr double badly_balanced = 0.01;

    // A warning is given if more than this part of a force acts without friction.
    constexpr double much_without_friction = 0.01;

    // A depth in an obstacle below this part of the displacement is rounding.
    constexpr double rounding_of_depth = 1e-6;

    // ... and what means of the other side, or a node beside, may well have of it.
    constexpr double deep = 0.01;

    // Of what friction can bear: where it falls by more in a step, methods may differ.
    constexpr double much_of_friction = 0.05;

    // Of the way that elastic bodies give, twice their energy over the normal force.
    constexpr double much_of_way = 0.03;

    // Times what a body was given: friction dissipates more only by the forces at the end
    // of steps on whose way they were others.
    constexpr double much_dissipated = 3.;

    // Radians by which normals may turn.
    constexpr double much_turned = 0.05;

    // By which normals may turn with a body.
    constexpr double much_of_friction_angle = 0.1;

    // Of the turn of normals: with more of it shared by the body there is little else.
    constexpr double shared = 0.5;

    // Nodes that bear the force of a contact, of how many: they are too few to tell of
    // pressures.
    constexpr unsigned int few = 4, many = 32;

    std::string warning_on_energies(const StepHistory &steps, const Units &units)
    {
      double given = 0., dissipated = 0., stored = 0.;
      for (const StepResult &step : steps.steps())
        {
          const EnergyBalance::Step &energy = step.energy;
          given += std::abs(energy.loads) + std::abs(energy.supports) +
                   std::abs(energy.obstacles);
          dissipated += energy.dissipation;
          stored = std::max(stored, energy.elastic_energy);
        }
      if (dissipated <= much_dissipated * (given + stored))
        return "";
      return "friction dissipates " +
             with_unit(format("%.3g", dissipated), units.energy) +
             ", and loads, supports and obstacles have worked " +
             with_unit(format("%.3g", given), units.energy) +
             ": forces change within steps, whose energies are not to be trusted; take "
             "smaller 'Time/Steps'.";
    }

    // Where no contact node is pressed at the end, nor in a step before.
    std::string warning_on_no_contact(const Certificate &certificate,
                                      const std::vector<NodeStatus> &statuses,
                                      const double force, const StepHistory *const steps,
                                      const Units &units)
    {
      double borne = 0.;
      if (steps != nullptr)
        for (const StepResult &step : steps->steps())
          for (const BoundaryStep &boundary : step.boundaries)
            borne = std::max(borne, boundary.normal_force);
      if (borne > no_force * force ||
          !std::all_of(statuses.begin(), statuses.end(), [](const NodeStatus &status) {
            return status.normal == NormalStatus::open;
          }))
        return "";
      const auto n = static_cast<Eigen::Index>(statuses.size());
      return "nothing touches" + std::string(steps != nullptr ? " in any step" : "") +
             ", and contact bears no force: the smallest gap that is left is " +
             with_unit(format("%.3g", certificate.gradient().head(n).minCoeff()),
                       units.length) +
             "; see where obstacles are, which way loads go and how large they are.";
    }

    // Whether a cell, of degree 2 a quarter of one, is pressed at all four corners
    // anywhere.
    bool is_face_pressed(const std::vector<SurfaceFace> &faces,
                         const ContactSurface &surface, const State &state,
                         const double least)
    {
      const auto is_pressed = [&](const dealii::types::global_dof_index first_dof) {
        const Eigen::Index i = surface.node_of(first_dof);
        return i >= 0 && state.lambda(i) > least;
      };
      return std::any_of(faces.begin(), faces.end(), [&](const SurfaceFace &face) {
        const unsigned int n = face.degree + 1; // in a row
        for (unsigned int k = 0; k + n + 1 < n * n; ++k)
          if (k % n + 1 < n && is_pressed(face.dofs[k]) && is_pressed(face.dofs[k + 1]) &&
              is_pressed(face.dofs[k + n]) && is_pressed(face.dofs[k + n + 1]))
            return true;
        return false;
      });
    }

    void add_few(const LinearElasticity &elasticity, const ContactSurface &surface,
                 const std::size_t boundary, const State &state, Warnings &warnings)
    {
      Eigen::VectorXd pressing = Eigen::VectorXd::Zero(surface.n_nodes());
      unsigned int n           = 0;
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        if (surface.nodes()[i].boundary == boundary)
          {
            pressing(i) = std::max(0., state.lambda(i));
            ++n;
          }
      const double least                  = no_force * pressing.sum();
      const auto bearing                  = (pressing.array() > least).count();
      const dealii::types::boundary_id id = surface.boundaries()[boundary].id();
      if (bearing > 0 && n >= many &&
          (bearing <= few ||
           !is_face_pressed(surface_faces(elasticity, {id}), surface, state, least)))
        warnings.push_back(
          {"nodes of " + surface.boundaries()[boundary].name(),
           1. / static_cast<double>(bearing),
           format(
             "the force of '%s' acts at %u of its %u nodes%s, too few to tell pressures "
             "and the area: make cells smaller there, as 'Geometry/Contact "
             "refinement' does.",
             surface.boundaries()[boundary].name().c_str(),
             static_cast<unsigned int>(bearing), n,
             bearing <= few ? "" : ", nowhere at four in a square")});
    }

    void add_supports(const ContactBoundary &boundary, const double frictionless,
                      Warnings &warnings)
    {
      if (frictionless > much_without_friction)
        warnings.push_back(
          {"supports of " + boundary.name(), frictionless,
           format(
             "'Prescribed displacement' makes nodes of '%s' slip that bear %.0f %% of "
             "its force, without friction in the directions that it holds; prescribe "
             "it where the boundary does not touch",
             boundary.name().c_str(), 100. * frictionless) +
             (boundary.other_side_may_bear()
                ? ", or let the other side bear the forces ('Slave side')."
              : boundary.is_pair() || boundary.friction().is_orthotropic()
                ? "."
                : ", or both directions along the surface.")});
    }

    void add_idle(const ContactBoundary &boundary, const double depth, const Units &units,
                  Warnings &warnings)
    {
      warnings.push_back(
        {"idle nodes of " + boundary.name(), depth,
         "nodes of '" + boundary.name() +
           "' on which none of its forces act, since their displacement is prescribed or "
           "they belong to a contact boundary before it, came " +
           with_unit(format("%.2g", depth), units.length) + " into " +
           (boundary.is_pair() ? '\'' + boundary.partner_name() + '\'' : "its obstacle") +
           "; the certificate does not speak of them."});
    }

    void add_fall(const ContactBoundary &boundary, const double fall,
                  const bool has_steps, Warnings &warnings)
    {
      if (fall > much_of_friction)
        warnings.push_back(
          {"friction of " + boundary.name(), fall,
           format("friction of '%s' falls by %.0f %% of itself within %s as nodes slip: "
                  "there may be other solutions, which smaller steps ('Time/Steps') tell "
                  "apart.",
                  boundary.name().c_str(), 100. * fall,
                  has_steps ? "the last step" : "the one step")});
    }

    // What linear kinematics leaves out where nodes moved along an obstacle.
    void add_departure(const ContactBoundary &boundary,
                       const ObstacleDeparture &departure, const double way,
                       const Units &units, Warnings &warnings)
    {
      if (departure.slip > departure.spacing &&
          (departure.distance > much_of_way * way || departure.turn > much_turned))
        warnings.push_back(
          {"obstacle of " + boundary.name(), departure.distance,
           "nodes of '" + boundary.name() +
             "' moved along an obstacle that is another one there: the gap is off by " +
             with_unit(format("%.2g", departure.distance), units.length) +
             format(", the normal by %.2g degrees, while bodies give ",
                    departure.turn * 180. / dealii::numbers::PI) +
             with_unit(format("%.2g", way), units.length) +
             (departure.with_body > shared * departure.turn
                ? "; the body turned with it, so that 'Sliding = far' is no better."
                : "; 'Sliding = far' takes gaps and normals where they come to.")});
      if (boundary.slides_far() && departure.coefficient > 0. &&
          departure.with_body > much_of_friction_angle * departure.coefficient)
        warnings.push_back(
          {"turn of " + boundary.name(), departure.with_body,
           format(
             "'%s' turned by %.2g degrees where it is pressed, which is %.2g of the "
             "friction angle: with 'Sliding = far' normals turn with it and its "
             "stiffness does not, so that friction seems more or less by about that; "
             "'Sliding = little' turns neither.",
             boundary.name().c_str(), departure.with_body * 180. / dealii::numbers::PI,
             departure.with_body / departure.coefficient)});
    }
  } // namespace

  std::vector<Warning> ContactProblem::warnings_of_step() const
  {
    const ContactSurface &surface = contact_surface();
    const double largest          = state_.u.linfty_norm();
    const auto &boundaries        = surface.boundaries();
    const double force            = certificate_->force_scale();
    Warnings warnings;
    add_warnings_of_bodies(elasticity(), surface, state_, units_, steps_ != nullptr,
                           warnings);
    if (const double depth = surface.penetration_of_facing_away(state_);
        depth > rounding_of_depth * largest)
      warnings.push_back({"facing away", depth,
                          "a node that faces away from its obstacle came " +
                            with_unit(format("%.2g", depth), units_.length) +
                            " into it; such nodes are no contact nodes, and the "
                            "certificate does not speak of them."});
    if (const auto [body, lacking] = certificate_->worst_balanced();
        lacking > badly_balanced)
      warnings.push_back(
        {"balance", lacking,
         format(
           "forces on body '%s' are out of balance by %.2g %% of themselves, being small "
           "beside those of the others; lower 'Contact solver/Tolerance', or compute it "
           "by itself.",
           body_->pieces()[body].name.c_str(), 100. * lacking)});
    const std::vector<double> frictionless = frictionless_parts(surface, state_),
                              depths       = surface.penetration_of_idle(state_),
                              falls        = falls_of_friction(surface, state_);
    const double pressing = state_.lambda.head(surface.n_nodes()).cwiseMax(0.).sum();
    const double way      = pressing > 0. ? certificate_->energy_scale() / pressing : 0.;
    std::vector<double> borne(boundaries.size(), 0.);
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      borne[surface.nodes()[i].boundary] += std::max(0., state_.lambda(i));
    for (std::size_t b = 0; b < boundaries.size(); ++b)
      {
        if (depths[b] > deep * largest)
          add_idle(boundaries[b], depths[b], units_, warnings);
        if (borne[b] <= no_force * std::max(force, state_.scales.force))
          continue; // rounding tells nothing
        if (!boundaries[b].is_tied())
          add_few(elasticity(), surface, b, state_, warnings);
        add_supports(boundaries[b], frictionless[b], warnings);
        add_fall(boundaries[b], falls[b], steps_ != nullptr, warnings);
        add_departure(boundaries[b], obstacle_departure(surface, boundaries[b], state_),
                      way, units_, warnings);
      }
    add_warnings_of_facets(*body_, surface, state_, way, units_, warnings);
    for (const ContactBoundary &pair : boundaries)
      if (pair.is_pair())
        {
          const PairFigures figures = pair_figures(elasticity(), surface, pair, state_,
                                                   std::max(force, state_.scales.force));
          add_warnings_of_pair(pair, surface, figures, *body_, *certificate_, way, units_,
                               warnings);
        }
    const auto motions =
      elasticity().free_motions().motions(elasticity().free_motion_of(state_.u));
    for (const unsigned int piece :
         bodies_at_friction_limit(elasticity(), surface, motions, state_, node_statuses(),
                                  parameters_.contact_solver.tolerance))
      warnings.push_back(
        {"limit of " + body_->pieces()[piece].name, largest,
         "friction bears all that it can at body '" + body_->pieces()[piece].name +
           "', which slides as a whole: forces balance, but how far it slides, and what "
           "friction dissipates by that, is not determined."});
    return warnings;
  }

  void ContactProblem::remember_warnings()
  {
    for (Warning &warning : warnings_of_step())
      if (const auto before = warned_.find(warning.about);
          before == warned_.end() || before->second.size < warning.size)
        {
          warning.text = format("at t = %.6g: ", elasticity().time()) + warning.text;
          warned_[warning.about] = std::move(warning);
        }
  }

  std::vector<std::string> ContactProblem::warnings() const
  {
    std::vector<std::string> sentences = body_->damages();
    if (parameters_.has_locking())
      sentences.push_back(
        format("with a Poisson ratio of %g trilinear elements lock, bodies and "
               "forces become too stiff, which the certificate does not see: "
               "'Material/Volume strain = cell mean' does not lock.",
               parameters_.material.largest_poisson_ratio()));
    Warnings now;
    const ContactSurface &surface = contact_surface();
    if (status_.converged)
      {
        if (const std::string friction =
              warning_on_friction(surface.largest_coefficient());
            !friction.empty())
          sentences.push_back(friction);
        if (const std::string open = warning_on_no_contact(
              *certificate_, node_statuses(),
              std::max(certificate_->force_scale(), state_.scales.force), steps_.get(),
              units_);
            !open.empty())
          sentences.push_back(open);
        now = warnings_of_step();
      }
    else if (state_.lambda.size() > 0)
      {
        const std::vector<double> frictionless = frictionless_parts(surface, state_);
        for (std::size_t b = 0; b < frictionless.size(); ++b)
          add_supports(surface.boundaries()[b], frictionless[b], now);
      }
    auto earlier = warned_;
    for (const Warning &warning : now)
      {
        sentences.push_back(warning.text);
        earlier.erase(warning.about);
      }
    for (const auto &[about, warning] : earlier)
      sentences.push_back(warning.text);
    if (steps_)
      if (const std::string energies = warning_on_energies(*steps_, units_);
          !energies.empty())
        sentences.push_back(energies);
    return sentences;
  }
} // namespace stiction
