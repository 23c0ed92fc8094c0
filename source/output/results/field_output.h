#ifndef stiction_source_output_results_field_output_h
#define stiction_source_output_results_field_output_h

#include <deal.II/base/data_out_base.h>

#include <mpi.h>

#include <string>
#include <tuple>
#include <vector>

namespace stiction
{
  /// A field of a file for ParaView: a scalar (1 component), a vector (3) or a
  /// tensor (9, row by row).
  struct Field
  {
    std::string name;
    unsigned int n_components;
    std::string unit; ///< empty: none is written
  };

  /// Fields at the points of patches, which are cells of the body (dim = 3) or
  /// faces of it (2). Who derives from it fills patches_, whose data have a row
  /// for each component of each field, in their order.
  template<int dim>
  class FieldOutput : public dealii::DataOutInterface<dim, 3>
  {
  public:
    explicit FieldOutput(std::vector<Field> fields);

    /// The rows of all fields.
    unsigned int n_rows() const;

    /// Writes NAME.pvtu on rank 0 over one NAME.RRRR.vtu a rank, and NAME.pvd
    /// over the (one) load step. Collective.
    void write(const std::string &directory, const std::string &name,
               MPI_Comm communicator);

  protected:
    using Patch = dealii::DataOutBase::Patch<dim, 3>;

    const std::vector<Patch> &get_patches() const override { return patches_; }

    std::vector<std::string> get_dataset_names() const override;

    std::vector<
      std::tuple<unsigned int, unsigned int, std::string,
                 dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override;

    std::vector<Patch> patches_;

  private:
    std::vector<Field> fields_;
  };
} // namespace stiction

#endif
