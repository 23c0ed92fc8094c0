#include "field_output.h"

#include <stiction/base/errors.h>
#include <stiction/base/files.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <utility>

namespace stiction
{
  using namespace dealii;

  template<int dim>
  FieldOutput<dim>::FieldOutput(std::vector<Field> fields)
    : fields_(std::move(fields))
  {
  }

  template<int dim>
  unsigned int FieldOutput<dim>::n_rows() const
  {
    unsigned int n = 0;
    for (const Field &field : fields_)
      n += field.n_components;
    return n;
  }

  template<int dim>
  std::vector<std::string> FieldOutput<dim>::get_dataset_names() const
  {
    std::vector<std::string> names;
    for (const Field &field : fields_)
      names.insert(names.end(), field.n_components, field.name);
    return names;
  }

  template<int dim>
  std::vector<std::tuple<unsigned int, unsigned int, std::string,
                         DataComponentInterpretation::DataComponentInterpretation>>
  FieldOutput<dim>::get_nonscalar_data_ranges() const
  {
    std::vector<std::tuple<unsigned int, unsigned int, std::string,
                           DataComponentInterpretation::DataComponentInterpretation>>
      ranges;
    unsigned int row = 0;
    for (const Field &field : fields_)
      {
        if (field.n_components > 1)
          ranges.emplace_back(
            row, row + field.n_components - 1, field.name,
            field.n_components == 3
              ? DataComponentInterpretation::component_is_part_of_vector
              : DataComponentInterpretation::component_is_part_of_tensor);
        row += field.n_components;
      }
    return ranges;
  }

  template<int dim>
  void FieldOutput<dim>::write(const std::string &directory, const std::string &name,
                               MPI_Comm communicator)
  {
    DataOutBase::VtkFlags flags;
    // the default takes three times as long for a tenth less
    flags.compression_level = DataOutBase::VtkFlags::best_speed;
    for (const Field &field : fields_)
      if (!field.unit.empty())
        flags.physical_units[field.name] = field.unit;
    this->set_flags(flags);

    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const auto piece        = [&](const unsigned int r) {
      return name + "." + Utilities::int_to_string(r, 4) + ".vtu";
    };
    // readers complain of pieces that are empty
    std::vector<std::string> pieces;
    const auto n_patches =
      Utilities::MPI::all_gather(communicator, this->get_patches().size());
    for (unsigned int r = 0; r < n_patches.size(); ++r)
      if (n_patches[r] > 0)
        pieces.push_back(piece(r));
    throw_on_all_ranks(communicator, [&]() {
      if (n_patches[rank] > 0)
        write_file(directory + "/" + piece(rank),
                   [&](std::ostream &file) { this->write_vtu(file); });
      if (rank != 0)
        return;

      write_file(directory + "/" + name + ".pvtu",
                 [&](std::ostream &file) { this->write_pvtu_record(file, pieces); });
      write_file(directory + "/" + name + ".pvd", [&](std::ostream &file) {
        DataOutBase::write_pvd_record(file, {{0., name + ".pvtu"}});
      });
    });
  }

  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace stiction
