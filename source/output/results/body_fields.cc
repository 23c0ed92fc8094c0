// solution.pvtu: the body.

#include "field_output.h"

#include <stiction/base/units.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/cell_dilatation.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/output/output_parameters.h>
#include <stiction/output/results/vtu.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <cmath>
#include <memory>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Cell = DoFHandler<3>::active_cell_iterator;

    double von_mises(const SymmetricTensor<2, 3> &stress)
    {
      return std::sqrt(1.5) * deviator(stress).norm();
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
            update_gradients | update_quadrature_points | update_JxW_values);
      }

      // Of the displacement u: those that the stiffness matrix is made with,
      // their volume part being Π ∇·u if it is there. Points are in
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
            mean_->reinit(cell);
            const CellDilatation dilatation(*mean_, u);
            for (unsigned int p = 0; p < n_points_; ++p)
              strains_[p] += (dilatation.at(places[p]) - trace(strains_[p])) / 3. *
                             unit_symmetric_tensor<3>();
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

      const unsigned int n_, n_points_;
      Table<2, double> derivative_;
      std::vector<SymmetricTensor<2, 3>> strains_;
      std::unique_ptr<FEValues<3>> mean_; // if dilatations are means
    };

    // The body, one patch a cell.
    class BodyOutput : public FieldOutput<3>
    {
    public:
      BodyOutput(const LinearElasticity &elasticity, const LA::Vector &u,
                 const LA::Vector &reaction, const Vector<double> &error_indicators,
                 const OutputParameters &parameters)
        : FieldOutput<3>(elasticity.body())
        , elasticity_(elasticity)
        , units_(Units::named(parameters.units))
        , has_all_(parameters.has_all_fields())
        , first_dof_(make_first_dofs())
      {
        add_more("body_id", 1); // 0, there is one body
        const bool has_error     = error_indicators.size() > 0;
        const unsigned int error = has_error ? add_field("error_indicator", 1) : 0;
        const LA::Vector ghosted = body_.with_ghosts(u);
        add_cells(ghosted);
        if (has_all_)
          {
            add_averaged_stress(ghosted);
            add_reaction(body_.with_ghosts(reaction));
            add_constants(material_,
                          [](const Cell &cell) { return cell->material_id(); });
          }
        if (piece_ > 0)
          add_constants(piece_, [&](const Cell &cell) { return body_.piece_of(cell); });
        if (has_error)
          add_constants(error, [&](const Cell &cell) {
            return error_indicators(cell->active_cell_index());
          });
      }

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

      // With 'Output/Fields = all' only.
      unsigned int add_more(const std::string &name, const unsigned int n_components,
                            const std::string &unit = "")
      {
        return has_all_ ? add_field(name, n_components, unit) : 0;
      }

      // Calls f(cell, first unknowns of its nodes, patch).
      template<typename Function> void for_each_patch(const Function &f)
      {
        std::vector<types::global_dof_index> of_cell(3 * first_dof_.size()),
          of_nodes(first_dof_.size());
        auto patch = patches_.begin();
        for (const auto &cell : body_.locally_owned_cells())
          {
            cell->get_dof_indices(of_cell);
            for (unsigned int p = 0; p < of_nodes.size(); ++p)
              of_nodes[p] = of_cell[first_dof_[p]];
            f(cell, of_nodes, *patch++);
          }
      }

      // With all that the displacement tells at a node of a cell alone.
      void add_cells(const LA::Vector &u);

      void add_averaged_stress(const LA::Vector &u);

      void add_reaction(const LA::Vector &reaction)
      {
        for_each_patch([&](const Cell &, const auto &dofs, Patch &patch) {
          for (unsigned int p = 0; p < dofs.size(); ++p)
            for (unsigned int c = 0; c < 3; ++c)
              set(patch, reaction_ + c, p, reaction(dofs[p] + c));
        });
      }

      // What a cell has at all its nodes.
      template<typename Function>
      void add_constants(const unsigned int row, const Function &value)
      {
        for_each_patch([&](const Cell &cell, const auto &dofs, Patch &patch) {
          for (unsigned int p = 0; p < dofs.size(); ++p)
            set(patch, row, p, value(cell));
        });
      }

      const LinearElasticity &elasticity_;
      const Units units_;
      const bool has_all_;
      const std::vector<unsigned int> first_dof_;

      const unsigned int displacement_ = add_field("displacement", 3, units_.length),
                         stress_       = add_field("stress", 9, units_.stress),
                         von_mises_    = add_field("von_Mises_stress", 1, units_.stress),
                         strain_       = add_more("strain", 9),
                         principal_    = add_more("principal_stresses", 3, units_.stress),
                         averaged_     = add_more("stress_averaged", 9, units_.stress),
                         averaged_von_mises_ = add_more("von_Mises_stress_averaged", 1,
                                                        units_.stress),
                         reaction_           = add_more("reaction", 3, units_.force),
                         material_           = add_more("material_id", 1),
                         piece_ = body_.pieces().size() > 1 ? add_field("body", 1) : 0;
    };

    void BodyOutput::add_cells(const LA::Vector &u)
    {
      const unsigned int degree = body_.dof_handler().get_fe().degree;
      // deal.II puts the points in between where straight edges have them
      const bool has_places = degree > 1;
      for (const auto &cell : body_.locally_owned_cells())
        add_patch(cell, has_places);

      FEValues<3> at_nodes(body_.mapping(), body_.dof_handler().get_fe(),
                           QIterated<3>(QTrapezoid<1>(), degree), // as a table
                           update_quadrature_points);
      NodalStrains nodal_strains(body_, elasticity_.materials().have_mean_dilatation());
      std::vector<Point<3>> places(first_dof_.size());
      std::vector<Tensor<1, 3>> displacements(first_dof_.size());
      for_each_patch([&](const Cell &cell, const auto &dofs, Patch &patch) {
        if (has_places)
          at_nodes.reinit(cell);
        for (unsigned int p = 0; p < dofs.size(); ++p)
          {
            places[p] = has_places ? at_nodes.quadrature_point(p) : cell->vertex(p);
            if (has_places)
              set(patch, row_names_.size(), p, places[p]);
            for (unsigned int c = 0; c < 3; ++c)
              displacements[p][c] = u(dofs[p] + c);
            set(patch, displacement_, p, displacements[p]);
          }

        const Material &material = elasticity_.materials().of(cell->material_id());
        const auto &strains      = nodal_strains(cell, places, displacements, u);
        for (unsigned int p = 0; p < dofs.size(); ++p)
          {
            const SymmetricTensor<2, 3> stress = material.stress(strains[p]);
            set(patch, stress_, p, stress);
            set(patch, von_mises_, p, von_mises(stress));
            if (!has_all_)
              continue;
            set(patch, strain_, p, strains[p]);
            const auto principal = eigenvalues(stress); // the largest first
            for (unsigned int c = 0; c < 3; ++c)
              set(patch, principal_ + c, p, principal[c]);
          }
      });
    }

    // At each node the mean of the stresses that the cells around it have
    // there, weighted by their volumes: of the cells of the same material, for
    // stress jumps where materials meet. Hanging nodes follow the others.
    void BodyOutput::add_averaged_stress(const LA::Vector &u)
    {
      // six components of the stress and the volume
      std::array<LA::Vector, 3> sums;
      for (auto &sum : sums)
        sum.reinit(u);
      const auto mean_at = [&](const types::global_dof_index node, const double weight) {
        SymmetricTensor<2, 3> stress;
        for (unsigned int k = 0; k < 6; ++k)
          stress.access_raw_entry(k) = sums[k / 3](node + k % 3);
        return weight * stress / sums[2](node);
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
                        volume * patch.data(stress_ + 3 * at[0] + at[1], p);
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
                for (const auto &[dof, weight] : body_.followed_by(dofs[p]))
                  stress += mean_at(dof, weight);
                set(patch, averaged_, p, stress);
                set(patch, averaged_von_mises_, p, von_mises(stress));
              }
          });
        }
    }
  } // namespace

  void write_solution(const LinearElasticity &elasticity, const LA::Vector &u,
                      const LA::Vector &reaction, const Vector<double> &error_indicators,
                      const OutputParameters &parameters, const std::string &tag)
  {
    BodyOutput(elasticity, u, reaction, error_indicators, parameters)
      .write(parameters.directory, "solution", tag);
  }
} // namespace stiction
