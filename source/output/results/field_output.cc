#include "field_output.h"

#include <stiction/base/errors.h>
#include <stiction/base/files.h>

#include <deal.II/base/mpi.h>

namespace stiction
{
  using namespace dealii;

  template<int dim>
  unsigned int FieldOutput<dim>::add_field(const std::string &name,
                                           const unsigned int n_components,
                                           const std::string &unit)
  {
    const unsigned int first = row_names_.size();
    row_names_.insert(row_names_.end(), n_components, name);
    if (n_components > 1)
      ranges_.emplace_back(first, first + n_components - 1, name,
                           n_components == 3
                             ? DataComponentInterpretation::component_is_part_of_vector
                             : DataComponentInterpretation::component_is_part_of_tensor);
    if (!unit.empty())
      flags_.physical_units[name] = unit;
    return first;
  }

  template<int dim>
  void FieldOutput<dim>::write(const std::string &directory, const std::string &name,
                               const std::string &tag)
  {
    // the default takes three times as long for a tenth less
    flags_.compression_level = DataOutBase::VtkFlags::best_speed;
    this->set_flags(flags_);

    const MPI_Comm communicator = body_.communicator();
    const unsigned int rank     = Utilities::MPI::this_mpi_process(communicator);
    const auto piece            = [&](const unsigned int r) {
      return name + tag + "." + Utilities::int_to_string(r, 4) + ".vtu";
    };
    // readers complain of pieces that are empty
    std::vector<std::string> pieces;
    const auto n_patches = Utilities::MPI::all_gather(communicator, patches_.size());
    for (unsigned int r = 0; r < n_patches.size(); ++r)
      if (n_patches[r] > 0)
        pieces.push_back(piece(r));
    throw_on_all_ranks(communicator, [&]() {
      if (n_patches[rank] > 0)
        write_file(directory + "/" + piece(rank),
                   [&](std::ostream &file) { this->write_vtu(file); });
      if (rank != 0)
        return;

      write_file(directory + "/" + name + tag + ".pvtu",
                 [&](std::ostream &file) { this->write_pvtu_record(file, pieces); });
      if (tag.empty())
        write_file(directory + "/" + name + ".pvd", [&](std::ostream &file) {
          DataOutBase::write_pvd_record(file, {{0., name + ".pvtu"}});
        });
    });
  }

  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace stiction
