#include <stiction/base/errors.h>
#include <stiction/base/log.h>
#include <stiction/parameters/memory.h>
#include <stiction/parameters/parameters.h>

#include <algorithm>
#include <sys/resource.h>
#include <unistd.h>

namespace stiction
{
  double available_memory(MPI_Comm communicator)
  {
    // the ranks that share a machine share its memory
    MPI_Comm machine;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    int n_neighbours = 1;
    MPI_Comm_size(machine, &n_neighbours);
    MPI_Comm_free(&machine);

    double mine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                  static_cast<double>(sysconf(_SC_PAGE_SIZE)) / n_neighbours;
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      mine = std::min(mine, static_cast<double>(limit.rlim_cur));

    double all = 0.;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, communicator);
    return all;
  }

  double memory_for_mesh(const Parameters &parameters, const double n_cells)
  {
    // Mesh and unknowns with a stiffness matrix of up to 81 × 3 entries a node,
    // or what runs with ten million unknowns took without one; then all nodes
    // of all cells for the volume output. Where K is assembled in any case
    // there are two matrices; one of degree 2 has 64 × 3 entries in the mean
    // and eight nodes a cell.
    const bool is_quadratic = parameters.geometry.element_degree == 2;
    const double matrices   = parameters.is_matrix_free()         ? 2.2e3
                              : parameters.has_geometric_levels() ? 6e3
                              : is_quadratic                      ? 1.3e5
                                                                  : 1e4;
    const double fields     = parameters.output.has_all_fields() ? 4.3e3 : 2.6e3;
    return n_cells *
           (matrices +
            (parameters.output.write_solution ? (is_quadratic ? 8. : 1.) * fields : 0.));
  }

  double memory_for_dual_operator(const Parameters &parameters,
                                  const double n_dual_unknowns, MPI_Comm communicator)
  {
    if (parameters.dual_operator.form != "assembled" ||
        parameters.contact_solver.is_primal())
      return 0.;
    int n_ranks = 1;
    MPI_Comm_size(communicator, &n_ranks);

    // Q on every rank, and on the first one the Schur complement and a copy;
    // one more on every rank where Q is factorised, and where forces press
    // obstacles on
    const double copies =
      (parameters.contact_solver.method == "admm" ? 2. : 1.) * n_ranks +
      (parameters.boundary.has_pressed_obstacles() ? n_ranks : 0.) + 2.;
    return 8. * n_dual_unknowns * n_dual_unknowns * copies;
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
    if (bytes > available)
      throw InputError(parameters.source.describe("Dual operator/Form") +
                       format(", needs %.3g GB of memory for %.0f dual "
                              "unknowns, at most %.3g GB are here, must be "
                              "'by solves' for a mesh as fine as this.",
                              bytes / 1e9, n_dual_unknowns, available / 1e9));
  }
} // namespace stiction
