#include <stiction/elasticity/mesh/cell_marking.h>

#include <deal.II/base/mpi.h>

namespace stiction
{
  using namespace dealii;

  std::vector<bool> mark_largest_cells(const Vector<double> &values,
                                       const double fraction, MPI_Comm communicator)
  {
    // the sum over all cells with at least this value
    const auto sum_from = [&](const double threshold) {
      double sum = 0.;
      for (const double value : values)
        sum += value >= threshold ? value : 0.;
      return Utilities::MPI::sum(sum, communicator);
    };

    const double wanted = fraction * sum_from(0.);
    double taken        = 0.; // from here on there is enough
    double not_taken    = Utilities::MPI::max(values.linfty_norm(), communicator);
    constexpr unsigned int n_bits = 50;
    for (unsigned int k = 0; k < n_bits; ++k)
      {
        const double middle                              = (taken + not_taken) / 2.;
        (sum_from(middle) >= wanted ? taken : not_taken) = middle;
      }

    std::vector<bool> is_marked(values.size());
    for (unsigned int i = 0; i < values.size(); ++i)
      is_marked[i] = values[i] > 0. && values[i] >= (1. - 1e-3) * taken;
    return is_marked;
  }
} // namespace stiction
