// solution.pvtu: the body.

#include "field_output.h"

#include <stiction/base/units.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/results/vtu.h>
#include <stiction/parameters/parameters.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Cell = DoFHandler<3>::active_cell_iterator;

    // The rows of the fields in the patches: those of 'basic' first.
    enum BodyRow : unsigned int
    {
      displacement_row       = 0,
      stress_row             = 3,
      von_mises_row          = 12,
      n_basic_rows           = 13,
      strain_row             = 13,
      principal_row          = 22,
      averaged_row           = 25,
      averaged_von_mises_row = 34,
      reaction_row           = 35,
      material_row           = 38,
      body_row               = 39,
      n_all_rows             = 40
    };

    std::vector<Field> body_fields(const OutputParameters &parameters,
                                   const bool has_indicator)
    {
      const Units units         = Units::named(parameters.units);
      std::vector<Field> fields = {{"displacement", 3, units.length},
                                   {"stress", 9, units.stress},
                                   {"von_Mises_stress", 1, units.stress}};
      if (parameters.has_all_fields())
        fields.insert(fields.end(), {{"strain", 9, ""},
                                     {"principal_stresses", 3, units.stress},
                                     {"stress_averaged", 9, units.stress},
                                     {"von_Mises_stress_averaged", 1, units.stress},
                                     {"reaction", 3, units.force},
                                     {"material_id", 1, ""},
                                     {"body_id", 1, ""}});
      if (has_indicator)
        fields.push_back({"error_indicator", 1, ""});
      return fields;
    }

    double von_mises(const SymmetricTensor<2, 3> &stress)
    {
      return std::sqrt(1.5) * deviator(stress).norm();
    }

    LA::Vector with_ghosts(const Body &body)
    {
      return LA::Vector(body.locally_owned_dofs(), body.locally_relevant_dofs(),
                        body.communicator());
    }

    LA::Vector with_ghosts(const Body &body, const LA::Vector &v)
    {
      LA::Vector copy = with_ghosts(body);
      copy            = v;
      copy.update_ghost_values();
      return copy;
    }

    // Strains at the nodes of a cell. Derivatives along the edges of the
    // reference cell need only the nodes on the same line, and those of the
    // places make gradients of them; both are polynomials of the element's
    // degree, so that nothing is approximated.
    class NodalStrains
    {
    public:
      NodalStrains(const Body &body, const bool mean_dilatation)
        : n_(body.dof_handler().get_fe().degree + 1)
        , n_points_(n_ * n_ * n_)
        , derivative_(n_, n_)
        , strains_(n_points_)
      {
        std::vector<double> value_and_derivative(2);
        for (unsigned int k = 0; k < n_; ++k)
          for (unsigned int p = 0; p < n_; ++p)
            {
              Polynomials::LagrangeEquidistant(n_ - 1, k).value(p / (n_ - 1.),
                                                                value_and_derivative);
              derivative_(p, k) = value_and_derivative[1];
            }
        if (mean_dilatation)
          mean_ = std::make_unique<FEValues<3>>(
            body.mapping(), body.dof_handler().get_fe(), QGauss<3>(n_),
            update_gradients | update_JxW_values);
      }

      // Of the displacement u: those that the stiffness matrix is made with,
      // their volume part being the cell's mean if it is there. Points are in
      // the order of a table.
      //
      // @param places, displacements at the nodes, in the same order.
      const std::vector<SymmetricTensor<2, 3>> &operator()(
        const Cell &cell, const std::vector<Point<3>> &places,
        const std::vector<Tensor<1, 3>> &displacements, const LA::Vector &u)
      {
        for (unsigned int p = 0; p < n_points_; ++p)
          {
            const Tensor<2, 3> to_places = derivatives(places, p);
            strains_[p] =
              symmetrize(Tensor<2, 3>(derivatives(displacements, p) * invert(to_places)));
          }
        if (mean_)
          {
            const double mean = mean_dilatation(cell, u);
            for (auto &strain : strains_)
              strain += (mean - trace(strain)) / 3. * unit_symmetric_tensor<3>();
          }
        return strains_;
      }

    private:
      // d f_a/d ξ_b at a node.
      template<typename Values>
      Tensor<2, 3> derivatives(const std::vector<Values> &f, const unsigned int p) const
      {
        Tensor<2, 3> result;
        unsigned int step = 1;
        for (unsigned int b = 0; b < 3; ++b, step *= n_)
          {
            const unsigned int here  = p / step % n_;
            const unsigned int first = p - here * step;
            for (unsigned int k = 0; k < n_; ++k)
              for (unsigned int a = 0; a < 3; ++a)
                result[a][b] += derivative_(here, k) * f[first + k * step][a];
          }
        return result;
      }

      double mean_dilatation(const Cell &cell, const LA::Vector &u)
      {
        mean_->reinit(cell);
        std::vector<double> divergences(mean_->n_quadrature_points);
        (*mean_)[FEValuesExtractors::Vector(0)].get_function_divergences(u, divergences);
        double sum = 0., volume = 0.;
        for (const unsigned int q : mean_->quadrature_point_indices())
          {
            sum += divergences[q] * mean_->JxW(q);
            volume += mean_->JxW(q);
          }
        return sum / volume;
      }

      const unsigned int n_, n_points_;
      Table<2, double> derivative_;
      std::vector<SymmetricTensor<2, 3>> strains_;
      std::unique_ptr<FEValues<3>> mean_; // if dilatations are means
    };

    // The body, one patch a cell.
    class BodyOutput : public FieldOutput<3>
    {
    public:
      BodyOutput(const LinearElasticity &elasticity, const OutputParameters &parameters,
                 const bool has_indicator)
        : FieldOutput<3>(body_fields(parameters, has_indicator))
        , elasticity_(elasticity)
        , body_(elasticity.body())
        , first_dof_(make_first_dofs())
        , at_nodes_(body_.mapping(), body_.dof_handler().get_fe(),
                    QIterated<3>(QTrapezoid<1>(), body_.dof_handler().get_fe().degree),
                    update_quadrature_points)
      {
      }

      void add_cells(const LA::Vector &u, const bool has_all_fields)
      {
        NodalStrains strains(body_, elasticity_.materials().have_mean_dilatation());
        for (const auto &cell : body_.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned())
            add_cell(cell, u, strains, has_all_fields);
      }

      // Of a nodal vector field.
      void add_vector(const unsigned int row, const LA::Vector &v)
      {
        for_each_patch([&](const Cell &, const auto &dofs, Patch &patch) {
          for (unsigned int p = 0; p < dofs.size(); ++p)
            for (unsigned int c = 0; c < 3; ++c)
              patch.data(row + c, p) = static_cast<float>(v(dofs[p] + c));
        });
      }

      void add_ids()
      {
        for_each_patch([&](const Cell &cell, const auto &dofs, Patch &patch) {
          for (unsigned int p = 0; p < dofs.size(); ++p)
            {
              patch.data(material_row, p) = static_cast<float>(cell->material_id());
              patch.data(body_row, p)     = 0.f; // there is one body
            }
        });
      }

      void add_indicators(const Vector<double> &indicators)
      {
        for_each_patch([&](const Cell &cell, const auto &dofs, Patch &patch) {
          for (unsigned int p = 0; p < dofs.size(); ++p)
            patch.data(n_rows() - 1, p) =
              static_cast<float>(indicators(cell->active_cell_index()));
        });
      }

      void add_averaged_stress();

    private:
      // Of the nodes of a cell in the order of a table, their place among the
      // unknowns of the cell: those of vertices come first there, then those
      // of edges, of faces and of the inside.
      std::vector<unsigned int> make_first_dofs() const
      {
        const FiniteElement<3> &fe = body_.dof_handler().get_fe();
        std::vector<unsigned int> first;
        for (const unsigned int node :
             FETools::lexicographic_to_hierarchic_numbering<3>(fe.degree))
          first.push_back(fe.component_to_system_index(0, node));
        return first;
      }

      void get_first_dofs(const Cell &cell, std::vector<types::global_dof_index> &of_cell,
                          std::vector<types::global_dof_index> &of_nodes) const
      {
        of_cell.resize(3 * first_dof_.size());
        of_nodes.resize(first_dof_.size());
        cell->get_dof_indices(of_cell);
        for (unsigned int p = 0; p < first_dof_.size(); ++p)
          of_nodes[p] = of_cell[first_dof_[p]];
      }

      // Calls f(cell, first unknowns of its nodes, patch).
      template<typename Function>
      void for_each_patch(const Function &f)
      {
        std::vector<types::global_dof_index> of_cell, of_nodes;
        auto patch = patches_.begin();
        for (const auto &cell : body_.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned())
            {
              get_first_dofs(cell, of_cell, of_nodes);
              f(cell, of_nodes, *patch++);
            }
      }

      void add_cell(const Cell &cell, const LA::Vector &u, NodalStrains &nodal_strains,
                    bool has_all_fields);

      const LinearElasticity &elasticity_;
      const Body &body_;
      const std::vector<unsigned int> first_dof_;
      FEValues<3> at_nodes_; // in the order of a table
      std::vector<types::global_dof_index> of_cell_, of_nodes_;
      std::vector<Point<3>> places_;
      std::vector<Tensor<1, 3>> displacements_;
    };

    void set_tensor(Table<2, float> &data, const unsigned int row, const unsigned int p,
                    const SymmetricTensor<2, 3> &t)
    {
      for (unsigned int a = 0; a < 3; ++a)
        for (unsigned int b = 0; b < 3; ++b)
          data(row + 3 * a + b, p) = static_cast<float>(t[a][b]);
    }

    void BodyOutput::add_cell(const Cell &cell, const LA::Vector &u,
                              NodalStrains &nodal_strains, const bool has_all_fields)
    {
      const FiniteElement<3> &fe  = body_.dof_handler().get_fe();
      const unsigned int n_points = first_dof_.size();
      // deal.II puts the points in between where straight edges have them
      const bool has_places = fe.degree > 1;

      patches_.emplace_back();
      Patch &patch               = patches_.back();
      patch.n_subdivisions       = fe.degree;
      patch.reference_cell       = ReferenceCells::Hexahedron;
      patch.patch_index          = patches_.size() - 1;
      patch.points_are_available = has_places;
      patch.data.reinit(n_rows() + (has_places ? 3 : 0), n_points);
      for (const unsigned int v : cell->vertex_indices())
        patch.vertices[v] = cell->vertex(v);

      if (has_places)
        at_nodes_.reinit(cell);
      get_first_dofs(cell, of_cell_, of_nodes_);
      places_.resize(n_points);
      displacements_.resize(n_points);
      for (unsigned int p = 0; p < n_points; ++p)
        {
          places_[p] = has_places ? at_nodes_.quadrature_point(p) : cell->vertex(p);
          for (unsigned int c = 0; c < 3; ++c)
            {
              displacements_[p][c] = u(of_nodes_[p] + c);
              patch.data(displacement_row + c, p) =
                static_cast<float>(displacements_[p][c]);
              if (has_places)
                patch.data(n_rows() + c, p) = static_cast<float>(places_[p][c]);
            }
        }

      const Material &material = elasticity_.materials().of(cell->material_id());
      const auto &strains      = nodal_strains(cell, places_, displacements_, u);
      for (unsigned int p = 0; p < n_points; ++p)
        {
          const SymmetricTensor<2, 3> stress = material.stress(strains[p]);
          set_tensor(patch.data, stress_row, p, stress);
          patch.data(von_mises_row, p) = static_cast<float>(von_mises(stress));
          if (!has_all_fields)
            continue;
          set_tensor(patch.data, strain_row, p, strains[p]);
          const auto principal = eigenvalues(stress); // the largest first
          for (unsigned int c = 0; c < 3; ++c)
            patch.data(principal_row + c, p) = static_cast<float>(principal[c]);
        }
    }

    // At each node the mean of the stresses that the cells around it have
    // there, weighted by their volumes: of the cells of the same material, for
    // stress jumps where materials meet. Hanging nodes follow the others.
    void BodyOutput::add_averaged_stress()
    {
      // six components of the stress and the volume
      std::array<LA::Vector, 3> sums;
      for (auto &sum : sums)
        sum = with_ghosts(body_);
      const auto stress_at = [&](const types::global_dof_index node) {
        SymmetricTensor<2, 3> stress;
        for (unsigned int k = 0; k < 6; ++k)
          stress.access_raw_entry(k) = sums[k / 3](node + k % 3);
        return stress;
      };

      for (const auto material : body_.material_names().ids())
        {
          for (auto &sum : sums)
            {
              sum.zero_out_ghost_values();
              sum = 0.;
            }
          for_each_patch([&](const Cell &cell, const auto &dofs, Patch &patch) {
            if (cell->material_id() != material)
              return;
            const double volume = cell->measure();
            for (unsigned int p = 0; p < dofs.size(); ++p)
              if (!body_.is_hanging(dofs[p]))
                {
                  for (unsigned int k = 0; k < 6; ++k)
                    {
                      const auto at =
                        SymmetricTensor<2, 3>::unrolled_to_component_indices(k);
                      sums[k / 3](dofs[p] + k % 3) +=
                        volume * patch.data(stress_row + 3 * at[0] + at[1], p);
                    }
                  sums[2](dofs[p]) += volume;
                }
          });
          for (auto &sum : sums)
            {
              sum.compress(VectorOperation::add);
              sum.update_ghost_values();
            }
          for_each_patch([&](const Cell &cell, const auto &dofs, Patch &patch) {
            if (cell->material_id() != material)
              return;
            for (unsigned int p = 0; p < dofs.size(); ++p)
              {
                SymmetricTensor<2, 3> stress;
                if (!body_.is_hanging(dofs[p]))
                  stress = stress_at(dofs[p]) / sums[2](dofs[p]);
                else
                  for (const auto &master :
                       *body_.hanging_nodes().get_constraint_entries(dofs[p]))
                    stress +=
                      master.second * stress_at(master.first) / sums[2](master.first);
                set_tensor(patch.data, averaged_row, p, stress);
                patch.data(averaged_von_mises_row, p) =
                  static_cast<float>(von_mises(stress));
              }
          });
        }
    }
  } // namespace

  void write_solution(const LinearElasticity &elasticity, const LA::Vector &u,
                      const LA::Vector &reaction, const Vector<double> &error_indicators,
                      const OutputParameters &parameters)
  {
    const Body &body     = elasticity.body();
    const bool has_error = error_indicators.size() > 0;
    const bool has_all   = parameters.has_all_fields();
    BodyOutput out(elasticity, parameters, has_error);
    out.add_cells(with_ghosts(body, u), has_all);
    if (has_all)
      {
        out.add_averaged_stress();
        out.add_vector(reaction_row, with_ghosts(body, reaction));
        out.add_ids();
      }
    if (has_error)
      out.add_indicators(error_indicators);
    out.write(parameters.directory, "solution", body.communicator());
  }

} // namespace stiction
