#include <stiction/base/interrupt.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stiction
{
  namespace
  {
    // A known displacement with a larger residual is worth less than what the coarse
    // levels find.
    constexpr double warm_residual = 0.1;

    // Of the loads. A body that contact alone holds and that friction may hold without
    // them, as a wedge, may also be where nothing touches it, and coarse levels know
    // nothing of where it was: it begins there if contact bore as much as this.
    constexpr double much_borne = 0.5;

    // Entries of rotated unit vectors below this are zeros.
    constexpr double rounding = 1e-14;

    // In which nodes of pairs count from the other side, on the mesh itself.
    BasisTransformation basis_of(const ContactOperator &B)
    {
      if (!B.has_other_side())
        return {};
      const ContactOperator::OtherSide &other = B.other_side();
      const Eigen::Index m = B.n_nodes(), n = other.weights.cols();
      std::vector<Eigen::Triplet<double>> entries;
      for (Eigen::Index i = 0; i < m; ++i)
        for (unsigned int b = 0; b < 3; ++b)
          {
            const ContactFrame &frame = B.frames()[i];
            const Eigen::Vector3d moved =
              frame.displacement_to_cartesian(
                frame.displacement_to_local(Eigen::Vector3d::Unit(b))) /
              frame.own_part;
            for (decltype(other.A)::InnerIterator entry(other.A, i + b * m); entry;
                 ++entry)
              for (unsigned int a = 0; a < 3; ++a)
                if (std::abs(moved(a)) > rounding)
                  entries.emplace_back(3 * i + a, 3 * (entry.col() % n) + entry.col() / n,
                                       entry.value() * moved(a));
          }
      BasisTransformation::Matrix N(3 * m, 3 * n);
      N.setFromTriplets(entries.begin(), entries.end());
      const auto first = [](const DofSubset &dofs, const Eigen::Index count) {
        return std::vector<dealii::types::global_dof_index>(dofs.dofs().begin(),
                                                            dofs.dofs().begin() + count);
      };
      return {first(B.dofs(), m), first(other.dofs, n), N};
    }

    // The foundation under contact nodes, passed to the nodes opposite of those bodies
    // that contact alone holds.
    Eigen::VectorXd ground_opposite(const LinearElasticity &elasticity,
                                    const ContactSurface &surface)
    {
      const ContactOperator::OtherSide &other = surface.B().other_side();
      LA::Vector is_free                      = elasticity.zero_vector();
      for (const Body::Node &node : elasticity.body().locally_owned_nodes())
        if (elasticity.free_motions().of(node.piece).second > 0)
          is_free(node.dofs[0]) = 1.;
      const Eigen::Index n = other.weights.cols();
      return ContactLevel::regularization(elasticity) *
             other.dofs.restriction(is_free).head(n).cwiseProduct(
               other.weights.transpose() *
               surface.stiffness().foundation(surface.areas(),
                                              elasticity.body().diameter()));
    }

    // Those of all levels.
    std::vector<BasisTransformation> bases_of(const LinearElasticity &elasticity,
                                              const ContactSurface &surface,
                                              const MeshHierarchy &hierarchy,
                                              const DofSubsetHierarchy &nodes)
    {
      std::vector<BasisTransformation> bases(hierarchy.n_levels());
      bases.back() = basis_of(surface.B());
      if (surface.B().has_other_side())
        bases.back().set_ground(ground_opposite(elasticity, surface));
      for (unsigned int l = hierarchy.n_levels() - 1; l > 0; --l)
        bases[l - 1] = bases[l].coarser(
          hierarchy.transfer(l), hierarchy.level(l), hierarchy.level(l - 1),
          nodes.on_finer_level(l - 1), nodes.first_dofs(l - 1));
      return bases;
    }
  } // namespace

  LevelNewton::Options NewtonMultigrid::for_start(LevelNewton::Options options)
  {
    options.max_fallbacks = 1;
    options.factorizes    = true;
    return options;
  }

  NewtonMultigrid::NewtonMultigrid(const LinearElasticity &elasticity,
                                   const ContactSurface &surface,
                                   const bool levels_in_use, LevelNewton::Options options)
    : options_(std::move(options))
    , is_held_by_contact_(elasticity.free_motions().n() > 0)
    , hierarchy_(elasticity.body(), elasticity.mesh(), levels_in_use)
    , dof_hierarchy_(hierarchy_, surface.first_dofs())
    , multigrid_(elasticity, hierarchy_, dof_hierarchy_,
                 bases_of(elasticity, surface, hierarchy_, dof_hierarchy_), levels_in_use)
    , problems_(hierarchy_.n_levels())
    , statistics_(hierarchy_.n_levels())
  {
    problems_.back() = std::make_unique<ContactLevel>(elasticity, surface,
                                                      multigrid_.basis(finest_level()));
    for (unsigned int l = finest_level(); l > 0; --l)
      problems_[l - 1] =
        std::make_unique<ContactLevel>(*problems_[l], multigrid_.basis(l - 1), elasticity,
                                       hierarchy_, dof_hierarchy_, l - 1);
  }

  void NewtonMultigrid::update()
  {
    multigrid_.forget(); // a run that goes on from a checkpoint knows nothing of it
    for (auto problem = problems_.rbegin(); problem != problems_.rend(); ++problem)
      (*problem)->update();
  }

  SolveStatus NewtonMultigrid::solve(State &solution, const double tolerance,
                                     const unsigned int max_steps,
                                     const Observer &observer,
                                     const OtherStart &other_start,
                                     const ContactStep &before)
  {
    for (const auto &problem : problems_)
      problem->set_earlier_scales(solution.scales);
    const unsigned int first = first_level(solution);
    Eigen::VectorXd lambda   = begin(first, solution);
    const auto earlier       = statistics_;
    ContactStep row;
    row.step       = before.step;
    row.iterations = before.iterations;
    SolveStatus status;
    unsigned int steps = 0;
    for (unsigned int l = first; l < hierarchy_.n_levels(); ++l)
      {
        if (l > first)
          lambda =
            status.reason.empty() || row.residual <= worthless ? refine(l) : begin(l, {});
        if (status.interrupted)
          continue; // the iterate is wanted on the finest level
        const bool is_finest = l == finest_level();

        unsigned int iterations           = row.iterations; // before the level
        unsigned int interior_point_steps = 0;
        row.residual                      = 0.; // that of another problem
        const auto after_step             = [&](const LevelNewton::Statistics &statistics,
                                    const ContactResidual &residual) {
          statistics_[l] = earlier[l];
          statistics_[l] += statistics;
          ++row.step;
          row.unknowns    = hierarchy_.level(l).n_dofs();
          row.iterations  = iterations + statistics.krylov_iterations;
          row.contraction = row.residual > 0. ? residual.value() / row.residual : 0.;
          row.residual    = residual.value();
          row.normal_force =
            residual.conditions.lambda().head(problems_[l]->n_nodes()).sum();
          row.remark = "";
          if (interior_point_steps == 0 && statistics.interior_point_steps > 0)
            row.remark = "Newton steps come no closer: from step " +
                         std::to_string(row.step) +
                         " on they take turns with an interior point method.";
          if (statistics.factorized_from == statistics.n_steps() + 1)
            row.remark += std::string(row.remark.empty() ? "" : " ") +
                          "Linear systems take too many iterations (" +
                          options_.hard_systems + "): with " +
                          std::to_string(row.unknowns) +
                          " unknowns they are factorised from here on.";
          interior_point_steps = statistics.interior_point_steps;
          observer(row);
        };
        LevelNewton::Options options = is_finest ? options_ : for_start(options_);
        if (is_finest && other_start)
          options.other_start = [&]() -> Eigen::VectorXd {
            const ContactStep here = row;
            const State start      = other_start(row);
            iterations += row.iterations - here.iterations;
            row.residual = start.u.size() > 0 ? 0. : here.residual;
            return start.u.size() > 0 ? begin(l, start) : Eigen::VectorXd();
          };
        try
          {
            LevelNewton newton(*problems_[l], l, multigrid_, options);
            status.reason =
              newton.solve(*state_, lambda,
                           is_finest ? tolerance : std::max(coarse_tolerance, tolerance),
                           max_steps - steps, after_step);
            status.stands_still = is_finest && newton.stands_still();
          }
        catch (const Interrupted &)
          {
            status.interrupted = true;
          }

        steps += statistics_[l].n_steps() - earlier[l].n_steps();
      }
    solution.u = state_->u;
    multigrid_.basis(finest_level()).to_absolute(solution.u);
    solution.lambda    = state_->lambda;
    solution.distances = state_->distances;
    status.converged   = status.reason.empty() && !status.interrupted;
    return status;
  }

  unsigned int NewtonMultigrid::first_level(const State &known)
  {
    unsigned int coarsest = 0;
    while (coarsest < finest_level() &&
           problems_[coarsest]->unbalanced_part(problems_[coarsest]->slip_bound()) > 0.)
      ++coarsest;
    if (known.u.size() != n_dofs(finest_level()))
      return coarsest;
    begin(finest_level(), known);
    const ContactLevel &problem = *problems_.back();
    const double residual =
      ContactResidual(problem, *state_, problem.slip_bound()).value();
    const bool is_wedged =
      is_held_by_contact_ && known.lambda.size() > 0 &&
      known.lambda.head(problem.n_nodes()).sum() > much_borne * problem.load_sum();
    return residual <= warm_residual || is_wedged ? finest_level() : coarsest;
  }

  Eigen::VectorXd NewtonMultigrid::begin(const unsigned int level, const State &known)
  {
    const ContactLevel &problem = *problems_[level];
    state_                      = ContactState(problem);
    if (known.distances.size() == state_->distances.size())
      state_->distances = known.distances;
    const bool is_warm = known.u.size() == state_->u.size();
    if (is_warm)
      {
        state_->u.copy_locally_owned_data_from(known.u);
        problem.basis().to_relative(state_->u);
      }
    problem.prescribe(state_->u);
    state_->update(problem);
    return is_warm ? known.lambda : Eigen::VectorXd::Zero(state_->lambda.size());
  }

  Eigen::VectorXd NewtonMultigrid::refine(const unsigned int level)
  {
    const ContactLevel &coarse = *problems_[level - 1];
    const ContactLevel &fine   = *problems_[level];

    // tractions are interpolated, forces belong to areas
    const auto &weights  = dof_hierarchy_.prolongation(level);
    const Eigen::Index m = coarse.n_nodes(), n = fine.n_nodes();
    const Eigen::VectorXd coarse_force = coarse.B().force_to_cartesian(state_->lambda);
    Eigen::VectorXd force(3 * n);
    for (unsigned int c = 0; c < 3; ++c)
      force.segment(c * n, n) = fine.areas().cwiseProduct(
        weights * coarse_force.segment(c * m, m).cwiseQuotient(coarse.areas()));
    Eigen::VectorXd lambda = fine.B().force_to_local(force);

    ContactState state(fine);
    state.distances = state_->distances;
    coarse.basis().to_absolute(state_->u);
    hierarchy_.transfer(level).prolongate(state.u, state_->u);
    fine.basis().to_relative(state.u);
    fine.prescribe(state.u);
    state.update(fine);
    state_ = std::move(state);
    return lambda;
  }

  NodalSupports NewtonMultigrid::free_supports() const
  {
    NodalSupports supports;
    for (Eigen::Index i = 0; i < problems_.back()->n_nodes(); ++i)
      supports.push_back(problems_.back()->support(i));
    return supports;
  }
} // namespace stiction
