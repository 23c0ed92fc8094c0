// What a problem says of itself before it is solved.

#include <stiction/base/blas_choice.h>
#include <stiction/base/cores.h>
#include <stiction/base/log.h>
#include <stiction/base/text/in_words.h>
#include <stiction/base/text/numbers.h>
#include <stiction/base/units.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/output/results/overview.h>
#include <stiction/simulation/contact_problem.h>
#include <stiction/simulation/parameters/parameters.h>
#include <stiction/simulation/parameters/unused_entries.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <map>

namespace stiction
{
  namespace
  {
    // Times the size of the body: an obstacle in other units is farther away.
    constexpr double far_away = 10.;

    // Of loads, obstacles and friction.
    bool has_formula_in_time(const ParameterFile &source)
    {
      const auto entries = source.given();
      return std::any_of(entries.begin(), entries.end(), [](const auto &entry) {
        const auto is_in = [&](const std::string &section) {
          return entry.first.rfind(section, 0) == 0;
        };
        return (is_in("Boundary conditions/") || is_in("Friction/") ||
                is_in("Contact pair ")) &&
               has_variable(entry.second, "t");
      });
    }

    // Of what a body is thick: obstacles that reach deeper into it are on the wrong side.
    constexpr double deep = 0.5;

    // Between a normal and the mean of a boundary's: facets of a flat one have less.
    constexpr double cosine_of_flat = 0.99;

    // Of the size of the body: gaps that differ by less are the same.
    constexpr double rounding_of_gaps = 1e-12;

    // Whether the foundation follows a boundary that is not flat, at one distance.
    bool is_mould(const ContactSurface &surface, const std::size_t boundary)
    {
      std::map<unsigned int, dealii::Tensor<1, 3>> means; // of parts between sharp edges
      double least = std::numeric_limits<double>::max(), most = -least, cosine = 1.;
      const auto for_nodes = [&](const auto &take) {
        for (const ContactNode &node : surface.nodes())
          if (node.boundary == boundary)
            take(node);
      };
      for_nodes([&](const ContactNode &node) {
        means[node.part] += node.area * node.normal;
        least = std::min(least, node.gap);
        most  = std::max(most, node.gap);
      });
      for_nodes([&](const ContactNode &node) {
        const dealii::Tensor<1, 3> &mean = means[node.part];
        cosine = std::min(cosine, node.normal * mean / std::max(mean.norm(), 1e-30));
      });
      return cosine < cosine_of_flat &&
             most - least <=
               rounding_of_gaps * surface.boundaries()[boundary].body_size();
    }
  } // namespace

  void ContactProblem::describe_choices() const
  {
    for (const std::string &what : body_->left_out())
      log_->line(what);
    for (const std::string &what : body_->damages())
      log_->line("WARNING: " + what);
    std::string elements;
    for (const auto &[kind, n] : body_->cut_elements())
      elements += (elements.empty() ? "" : ", ") + std::to_string(n) + ' ' + kind;
    if (!elements.empty()) // beside other bodies the cells are not of these alone
      log_->line("Mesh file: " + elements + ", cut into " +
                 (parameters_.geometry.bodies.empty()
                    ? std::to_string(body_->triangulation().n_cells(0)) + " hexahedra"
                    : "hexahedra"));
    if (!elements.empty() && parameters_.geometry.element_degree == 1)
      log_->line("Cut elements bend too stiffly, by some 7 % with two elements across a "
                 "beam and 2 % with three; 'Geometry/Element degree = 2' does not");
    if (parameters_.material.volume_strain == "automatic" &&
        parameters_.has_mean_dilatation())
      log_->line(format("Volume strain: cell mean, since a Poisson ratio is %g",
                        parameters_.material.largest_poisson_ratio()));
  }

  void ContactProblem::describe_machine()
  {
    if (!parameters_.performance.print_timing)
      return;
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(communicator_);
    log_->line(format("stiction %s (deal.II %s, %s, %u rank%s)", STICTION_VERSION,
                      DEAL_II_PACKAGE_VERSION, STICTION_BUILD_TYPE, n_ranks,
                      n_ranks == 1 ? "" : "s"));
    if (!blas_remark().empty())
      log_->line(blas_remark());
    const SharedCores shared = shared_cores(communicator_);
    if (shared.n_ranks > shared.n_cores)
      log_->line(format("WARNING: %u ranks share %u core%s, which is slower "
                        "than as many ranks as cores.",
                        shared.n_ranks, shared.n_cores, shared.n_cores == 1 ? "" : "s"));
  }

  void ContactProblem::describe_body()
  {
    log_->line(text_of("Body: ", body_->triangulation().n_global_active_cells(),
                       " cells, ", body_->n_nodes(), " nodes, ",
                       body_->dof_handler().n_dofs(), " unknowns"));
    if (body_->pieces().size() > 1)
      {
        std::vector<std::string> names;
        for (const Piece &piece : body_->pieces())
          names.push_back(piece.name);
        log_->line("Several bodies: " + listed(names));
      }
    if (body_->n_hanging_nodes() > 0)
      log_->line(text_of("Hanging nodes: ", body_->n_hanging_nodes()));
  }

  void ContactProblem::describe_applied() const
  {
    const ContactSurface &surface = contact_surface();
    if (parameters_.time.has_steps())
      log_->line(format("At t = %.6g:", elasticity().time()));
    print_applied(*log_, elasticity(), surface);
    if (!parameters_.time.has_steps() && has_formula_in_time(parameters_.source))
      log_->line(
        format("  time       t = %.6g in all formulas: one step; 'Time/Steps' goes "
               "there in several, on which friction depends",
               elasticity().time()));
    for (const std::string &entry : unused_entries(parameters_))
      log_->line("  not used   " + entry);
    for (std::size_t b = 0; b < surface.boundaries().size(); ++b)
      if (const ContactBoundary &boundary = surface.boundaries()[b];
          boundary.obstacle() == nullptr && !boundary.is_pair() && is_mould(surface, b))
        log_->line("  the foundation of '" + boundary.name() +
                   "', which is curved, fits it everywhere as a mould does; a flat floor "
                   "is 'Obstacle = plane : ...'");
  }

  void ContactProblem::describe_touching_bodies() const
  {
    std::vector<std::pair<dealii::types::boundary_id, dealii::types::boundary_id>> pairs;
    for (const ContactBoundary &boundary : contact_surface().boundaries())
      for (const auto partner : boundary.partners())
        pairs.emplace_back(boundary.id(), partner);
    for (const auto &[first, second] : body_->touching_without(pairs))
      log_->line(
        "WARNING: bodies '" + first + "' and '" + second +
        "' touch and are no contact pair, so that they pass through one another; "
        "pair their boundaries, or merge their nodes if they are one body");
  }

  void ContactProblem::describe_gaps()
  {
    const Eigen::VectorXd gaps = contact_surface().gaps();
    const double rounding      = 1e-9 * body_->diameter();
    const auto n               = (gaps.array() < -rounding).count();
    bool is_deep               = false;
    for (Eigen::Index i = 0; i < gaps.size(); ++i)
      for (const unsigned int piece :
           contact_surface().boundary_of(contact_surface().nodes()[i]).pieces(*body_))
        for (unsigned int c = 0; c < 3; ++c)
          is_deep =
            is_deep || -gaps(i) > deep * body_->pieces()[piece].box.side_length(c);
    if (n > 0)
      log_->line(
        text_of("  ", n, n == 1 ? " contact node overlaps" : " contact nodes overlap",
                " the obstacle before the body gives way, by up to ",
                with_unit(format("%.3g", -gaps.minCoeff()), units_.length),
                is_deep ? ", more than half of what a body is thick: is the obstacle "
                          "on the right side?"
                        : ""));
    if (gaps.size() > 0 && gaps.minCoeff() > far_away * body_->diameter())
      log_->line("  the nearest obstacle is " +
                 with_unit(format("%.3g", gaps.minCoeff()), units_.length) +
                 format(" away, %.3g times the size of the body: has it the same units?",
                        gaps.minCoeff() / body_->diameter()));
  }
} // namespace stiction
