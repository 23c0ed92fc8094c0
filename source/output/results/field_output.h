#pragma once

#include <stiction/elasticity/mesh/body.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/utilities.h>

#include <string>
#include <tuple>
#include <vector>

namespace stiction
{
  /// Fields at the points of patches, which are cells of the body (dim = 3) or
  /// faces of it (2). Who derives from it adds first the fields, then the
  /// patches, whose data have a row for each component of each field.
  template<int dim> class FieldOutput : public dealii::DataOutInterface<dim, 3>
  {
  public:
    /// Writes NAMETAG.pvtu on rank 0 over one NAMETAG.RRRR.vtu a rank, and without a
    /// tag NAME.pvd over the one step. Collective.
    void write(const std::string &directory, const std::string &name,
               const std::string &tag);

  protected:
    using Patch = dealii::DataOutBase::Patch<dim, 3>;

    explicit FieldOutput(const Body &body)
      : body_(body)
    {
    }

    /// A scalar (1 component), a vector (3) or a tensor (9, row by row).
    ///
    /// @param unit empty: none is written.
    /// @return its first row.
    unsigned int add_field(const std::string &name, unsigned int n_components,
                           const std::string &unit = "");

    /// Of a cell or face; the data are zero.
    ///
    /// @param has_places whether the last three rows are to be the places of its
    ///   points; deal.II finds those of a cell with straight edges.
    template<typename Object>
    Patch &add_patch(const Object &object, const bool has_places)
    {
      patches_.emplace_back();
      Patch &patch               = patches_.back();
      patch.n_subdivisions       = body_.dof_handler().get_fe().degree;
      patch.reference_cell       = object->reference_cell();
      patch.patch_index          = patches_.size() - 1;
      patch.points_are_available = has_places;
      patch.data.reinit(row_names_.size() + (has_places ? 3 : 0),
                        dealii::Utilities::fixed_power<dim>(patch.n_subdivisions + 1));
      for (const unsigned int v : object->vertex_indices())
        patch.vertices[v] = object->vertex(v);
      return patch;
    }

    /// What a field has at a point.
    static void set(Patch &patch, const unsigned int row, const unsigned int p,
                    const double value)
    {
      patch.data(row, p) = static_cast<float>(value);
    }

    static void set(Patch &patch, const unsigned int row, const unsigned int p,
                    const dealii::Tensor<1, 3> &v)
    {
      for (unsigned int c = 0; c < 3; ++c)
        set(patch, row + c, p, v[c]);
    }

    static void set(Patch &patch, const unsigned int row, const unsigned int p,
                    const dealii::SymmetricTensor<2, 3> &t)
    {
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          set(patch, row + 3 * a + b, p, t[a][b]);
    }

    const std::vector<Patch> &get_patches() const override { return patches_; }

    std::vector<std::string> get_dataset_names() const override { return row_names_; }

    using Range =
      std::tuple<unsigned int, unsigned int, std::string,
                 dealii::DataComponentInterpretation::DataComponentInterpretation>;
    std::vector<Range> get_nonscalar_data_ranges() const override { return ranges_; }

    const Body &body_;
    std::vector<Patch> patches_;
    std::vector<std::string> row_names_; ///< of the field that each row is of

  private:
    std::vector<Range> ranges_; ///< of vectors and tensors
    dealii::DataOutBase::VtkFlags flags_;
  };
} // namespace stiction
