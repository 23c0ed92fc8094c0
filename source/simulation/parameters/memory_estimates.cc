#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/base/memory.h>
#include <stiction/contact/pairs/slave_side.h>
#include <stiction/simulation/parameters/memory_estimates.h>
#include <stiction/simulation/parameters/parameters.h>

#include <cmath>

namespace stiction
{
  double memory_for_mesh(const Parameters &parameters, const double n_cells)
  {
    // Mesh and unknowns with a stiffness matrix of up to 81 × 3 entries a node,
    // or what runs with ten million unknowns took without one; element matrices in
    // both precisions where they are kept and cells are not alike, and directions with
    // pressures of the cells where there are means; then all nodes
    // of all cells for the volume output. One assembled matrix of degree 2 has
    // 64 × 3 entries in the mean and eight nodes a cell.
    const bool is_quadratic = parameters.geometry.element_degree == 2;
    const bool are_kept =
      parameters.has_mean_dilatation() && !parameters.geometry.is_brick();
    const double trilinear = (parameters.is_matrix_free() ? 2.2e3 : 6e3) +
                             (are_kept ? 7e3 : 0.) +
                             (parameters.has_mean_dilatation() ? 1e3 : 0.);
    const double matrices = is_quadratic ? 1.3e5 : trilinear;
    const double fields   = parameters.output.has_all_fields() ? 4.3e3 : 2.6e3;
    return n_cells *
           (matrices +
            (parameters.output.write_solution ? (is_quadratic ? 8. : 1.) * fields : 0.));
  }

  namespace
  {
    // Bytes a rank: its code and libraries.
    constexpr double program = 1.7e8;

    // Bytes a cell of the coarsest level, if that is no small brick, for coarser grids.
    constexpr double background = 1e4;

    // Bytes an unknown: of the directions that a linear system of many iterations keeps,
    // and of factors where multigrid is no good or 'newton' goes on.
    constexpr double directions = 480., factors = 6e3;

    double memory_for_Q(const Parameters &parameters, const double n_dual_unknowns,
                        MPI_Comm communicator)
    {
      int n_ranks = 1;
      MPI_Comm_size(communicator, &n_ranks);

      // Q on every rank, and on the first one the Schur complement and a copy;
      // one more on every rank where Q is factorised, and where forces press
      // obstacles on
      const double copies =
        (parameters.contact_solver.method == "admm" ? 2. : 1.) * n_ranks +
        (parameters.contact.has_pressed_obstacles() ? n_ranks : 0.) + 2.;
      return 8. * n_dual_unknowns * n_dual_unknowns * copies;
    }
  } // namespace

  double memory_for_dual_operator(const Parameters &parameters,
                                  const double n_dual_unknowns, MPI_Comm communicator)
  {
    return parameters.dual_operator.form == "assembled" &&
               !parameters.contact_solver.is_primal()
             ? memory_for_Q(parameters, n_dual_unknowns, communicator)
             : 0.;
  }

  bool has_memory_to_hand_over(const Parameters &parameters, const double n_dual_unknowns,
                               MPI_Comm communicator)
  {
    return memory_for_Q(parameters, n_dual_unknowns, communicator) <
           0.5 * available_memory(communicator);
  }

  void require_memory_for_mesh(const Parameters &parameters, const double n_cells,
                               MPI_Comm communicator)
  {
    const std::string entry =
      parameters.source.describe(parameters.geometry.entry_of_size());
    if (n_cells > GeometryParameters::max_cells)
      throw InputError(entry + format(", makes %g cells, allowed are at most %g.",
                                      n_cells, GeometryParameters::max_cells));

    const double bytes     = memory_for_mesh(parameters, n_cells);
    const double available = available_memory(communicator);
    if (bytes > available)
      throw InputError(entry +
                       format(", makes %.3g cells that need about %.3g GB of memory, "
                              "at most %.3g GB are here.",
                              n_cells, bytes / 1e9, available / 1e9));
  }

  void require_memory_for_dual_operator(const Parameters &parameters,
                                        const double n_dual_unknowns,
                                        MPI_Comm communicator)
  {
    const double bytes =
      memory_for_dual_operator(parameters, n_dual_unknowns, communicator);
    const double available = available_memory(communicator);
    parameters.source.require(
      bytes <= available, "Dual operator/Form",
      format("needs %.3g GB of memory for %.0f dual unknowns, at most %.3g GB are here, "
             "must be 'by solves' for a mesh as fine as this",
             bytes / 1e9, n_dual_unknowns, available / 1e9));
  }

  void print_memory(Log &log, const Parameters &parameters, const double n_cells,
                    const double n_unknowns, const double n_dual_unknowns,
                    MPI_Comm communicator)
  {
    int n_ranks = 1;
    MPI_Comm_size(communicator, &n_ranks);
    const double n_coarse =
      parameters.geometry.is_brick()
        ? 0.
        : n_cells / std::pow(8., parameters.geometry.global_refinement);
    const double mesh =
      memory_for_mesh(parameters, n_cells) + background * n_coarse + n_ranks * program;
    const double dual =
      memory_for_dual_operator(parameters, n_dual_unknowns, communicator);
    log.line("Memory, estimated");
    log.line(format("  mesh and elastic solves  %.3g GB", mesh / 1e9));
    log.line(format("  dual operator            %.3g GB", dual / 1e9));
    if (parameters.contact_solver.is_primal())
      {
        double more = directions * n_unknowns;
        if (n_unknowns <= max_for_newton)
          more += factors * n_unknowns +
                  (parameters.dual_operator.form == "assembled"
                     ? memory_for_Q(parameters, n_dual_unknowns, communicator)
                     : 0.);
        log.line(format("  more if systems are hard %.3g GB", more / 1e9));
      }
    log.line(
      format("  available                %.3g GB", available_memory(communicator) / 1e9));
  }
} // namespace stiction
