#include <stiction/contact/certificate.h>
#include <stiction/contact/contact_surface.h>
#include <stiction/contact/nodal_blocks.h>
#include <stiction/elasticity/body.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/materials.h>
#include <stiction/errors.h>
#include <stiction/output/files.h>
#include <stiction/output/vtu.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // The stress tensor, all nine components for ParaView.
    class Stress : public DataPostprocessorTensor<3>
    {
    public:
      explicit Stress(const Materials &materials)
        : DataPostprocessorTensor<3>("stress", update_gradients)
        , materials_(materials)
      {
      }

      // At a point of the cell.
      SymmetricTensor<2, 3>
      stress(const DataPostprocessorInputs::Vector<3> &inputs,
             const unsigned int point) const
      {
        const auto &gradients = inputs.solution_gradients[point];
        SymmetricTensor<2, 3> strain;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = a; b < 3; ++b)
            strain[a][b] = (gradients[a][b] + gradients[b][a]) / 2.;
        const auto cell = inputs.template get_cell<3>();
        return materials_.of(cell->material_id()).stress(strain);
      }

      void
      evaluate_vector_field(
        const DataPostprocessorInputs::Vector<3> &inputs,
        std::vector<Vector<double>> &quantities) const override
      {
        for (unsigned int p = 0; p < quantities.size(); ++p)
          {
            const auto sigma = stress(inputs, p);
            for (unsigned int a = 0; a < 3; ++a)
              for (unsigned int b = 0; b < 3; ++b)
                quantities[p](Tensor<2, 3>::component_to_unrolled_index(
                  {a, b})) = sigma[a][b];
          }
      }

    private:
      const Materials &materials_;
    };



    class VonMisesStress : public DataPostprocessorScalar<3>
    {
    public:
      explicit VonMisesStress(const Stress &stress)
        : DataPostprocessorScalar<3>("von_Mises_stress", update_gradients)
        , stress_(stress)
      {
      }

      void
      evaluate_vector_field(
        const DataPostprocessorInputs::Vector<3> &inputs,
        std::vector<Vector<double>> &quantities) const override
      {
        for (unsigned int p = 0; p < quantities.size(); ++p)
          quantities[p](0) =
            std::sqrt(1.5) * deviator(stress_.stress(inputs, p)).norm();
      }

    private:
      const Stress &stress_;
    };



    // The contact boundary as an output of its own: one patch a face.
    class ContactOutput : public DataOutInterface<2, 3>
    {
    public:
      ContactOutput(const LinearElasticity &elasticity,
                    const ContactSurface &surface,
                    const Certificate &certificate)
        : body_(elasticity.body())
        , surface_(surface)
        , certificate_(certificate)
      {
        const FiniteElement<3> &fe = body_.dof_handler().get_fe();
        // points of a patch are in the order of a table, unknowns first those
        // of the vertices, then those of the edges
        const auto order =
          FETools::lexicographic_to_hierarchic_numbering<2>(fe.degree);
        std::vector<types::global_dof_index> dofs(fe.n_dofs_per_face());
        for (const auto &cell : body_.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() &&
                  surface.is_contact_boundary(face->boundary_id()))
                {
                  face->get_dof_indices(dofs);
                  DataOutBase::Patch<2, 3> patch;
                  patch.n_subdivisions = fe.degree;
                  patch.reference_cell = ReferenceCells::Quadrilateral;
                  patch.patch_index    = patches_.size();
                  patch.data.reinit(n_fields, order.size());
                  for (const unsigned int v : face->vertex_indices())
                    patch.vertices[v] = face->vertex(v);
                  for (unsigned int p = 0; p < order.size(); ++p)
                    {
                      const Values values = values_at(dofs[3 * order[p]]);
                      for (unsigned int k = 0; k < n_fields; ++k)
                        patch.data(k, p) = static_cast<float>(values[k]);
                      patch.data(boundary, p) =
                        static_cast<float>(face->boundary_id());
                    }
                  patches_.push_back(patch);
                }
      }

    protected:
      const std::vector<DataOutBase::Patch<2, 3>> &
      get_patches() const override
      {
        return patches_;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        return {"pressure",
                "traction",
                "traction",
                "traction",
                "slip",
                "slip",
                "slip",
                "gap",
                "status",
                "area",
                "slip_bound",
                "boundary"};
      }

      std::vector<
        std::tuple<unsigned int,
                   unsigned int,
                   std::string,
                   DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        return {std::make_tuple(
                  traction,
                  traction + 2,
                  "traction",
                  DataComponentInterpretation::component_is_part_of_vector),
                std::make_tuple(
                  slip,
                  slip + 2,
                  "slip",
                  DataComponentInterpretation::component_is_part_of_vector)};
      }

    private:
      enum Field : unsigned int
      {
        pressure,
        traction,
        slip     = traction + 3,
        gap      = slip + 3,
        status   = gap + 1,
        area     = status + 1,
        bound    = area + 1,
        boundary = bound + 1,
        n_fields = boundary + 1
      };

      using Values = std::array<double, n_fields>;

      // At a node of the boundary, interpolated if it hangs; its status is
      // then that of the first node it follows.
      Values
      values_at(const types::global_dof_index first_dof) const
      {
        if (!body_.is_hanging(first_dof))
          return values_at_node(surface_.node_of(first_dof));
        Values sum{};
        const auto &masters =
          *body_.hanging_nodes().get_constraint_entries(first_dof);
        for (auto master = masters.rbegin(); master != masters.rend(); ++master)
          {
            const Values values =
              values_at_node(surface_.node_of(master->first));
            for (unsigned int k = 0; k < n_fields; ++k)
              sum[k] += master->second * values[k];
            sum[status] = values[status];
          }
        sum[area] = 0.; // it has none of its own
        return sum;
      }

      Values
      values_at_node(const Eigen::Index i) const
      {
        Values values{};
        if (i < 0) // clamped or facing away: not a contact node
          {
            values[status] = -1.;
            return values;
          }
        const Eigen::Index m    = surface_.n_nodes();
        const ContactNode &node = surface_.nodes()[i];
        const auto &lambda      = certificate_.lambda();
        const auto &r           = certificate_.gradient();

        const Eigen::Vector3d force =
          node.force_to_cartesian(at_node(lambda, i));
        const Eigen::Vector3d slip_vector =
          node.displacement_to_cartesian({0., -r(i + m), -r(i + 2 * m)});

        values[pressure] = lambda(i) / node.area;
        values[gap]      = r(i);
        values[area]     = node.area;
        values[bound]    = certificate_.slip_bound()(i) / node.area;
        values[status]   = static_cast<double>(certificate_.status(i));
        for (unsigned int c = 0; c < 3; ++c)
          {
            values[traction + c] = -force[c] / node.area;
            values[slip + c]     = slip_vector[c];
          }
        return values;
      }

      const Body &body_;
      const ContactSurface &surface_;
      const Certificate &certificate_;
      std::vector<DataOutBase::Patch<2, 3>> patches_;
    };



    // NAME.pvtu on rank 0 over one NAME.RRRR.vtu a rank, and NAME.pvd over
    // the (one) load step.
    template<int dim>
    void
    write_pieces(DataOutInterface<dim, 3> &out,
                 const std::string &directory,
                 const std::string &name,
                 MPI_Comm communicator)
    {
      // the default takes three times as long for a tenth less
      DataOutBase::VtkFlags flags;
      flags.compression_level = DataOutBase::VtkFlags::best_speed;
      out.set_flags(flags);

      const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
      const auto piece        = [&](const unsigned int r) {
        return name + "." + Utilities::int_to_string(r, 4) + ".vtu";
      };
      together(communicator, [&]() {
        write_file(directory + "/" + piece(rank),
                   [&](std::ostream &file) { out.write_vtu(file); });
        if (rank != 0)
          return;

        std::vector<std::string> pieces;
        for (unsigned int r = 0;
             r < Utilities::MPI::n_mpi_processes(communicator);
             ++r)
          pieces.push_back(piece(r));
        write_file(directory + "/" + name + ".pvtu", [&](std::ostream &file) {
          out.write_pvtu_record(file, pieces);
        });
        write_file(directory + "/" + name + ".pvd", [&](std::ostream &file) {
          DataOutBase::write_pvd_record(file, {{0., name + ".pvtu"}});
        });
      });
    }
  } // namespace



  void
  write_solution(const std::string &directory,
                 const LinearElasticity &elasticity,
                 const LA::Vector &u,
                 const Vector<double> &error_indicators)
  {
    const Body &body = elasticity.body();
    LA::Vector with_ghosts(body.locally_owned_dofs(),
                           body.locally_relevant_dofs(),
                           body.communicator());
    with_ghosts = u;
    with_ghosts.update_ghost_values();

    const Stress stress(elasticity.materials());
    const VonMisesStress von_mises(stress);
    DataOut<3> out;
    out.attach_dof_handler(body.dof_handler());
    out.add_data_vector(
      with_ghosts,
      std::vector<std::string>(3, "displacement"),
      DataOut<3>::type_dof_data,
      std::vector<DataComponentInterpretation::DataComponentInterpretation>(
        3, DataComponentInterpretation::component_is_part_of_vector));
    out.add_data_vector(with_ghosts, stress);
    out.add_data_vector(with_ghosts, von_mises);
    if (error_indicators.size() > 0)
      out.add_data_vector(
        error_indicators, "error_indicator", DataOut<3>::type_cell_data);
    out.build_patches(body.dof_handler().get_fe().degree);
    write_pieces(out, directory, "solution", body.communicator());
  }



  void
  remove_solution(const std::string &directory, MPI_Comm communicator)
  {
    std::error_code error; // there may be none
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      for (const char *ending : {".pvtu", ".pvd"})
        std::filesystem::remove(directory + "/solution" + ending, error);
  }



  void
  write_contact(const std::string &directory,
                const LinearElasticity &elasticity,
                const ContactSurface &surface,
                const Certificate &certificate)
  {
    ContactOutput out(elasticity, surface, certificate);
    write_pieces(out, directory, "contact", elasticity.body().communicator());
  }
} // namespace stiction
