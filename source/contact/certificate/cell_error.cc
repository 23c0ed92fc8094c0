#include "cell_error.h"
#include "contact_traction.h"
#include "trilinear_cell.h"

#include <stiction/contact/certificate/smooth_boundary.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/loads.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/model/prescribed_displacement.h>
#include <stiction/elasticity/stiffness/cell_dilatation.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Cell = DoFHandler<3>::active_cell_iterator;

    // A as in (n·C·n) a = A a: what a jump of ∂u/∂n is as a jump of σn.
    // @return t·A⁻¹t
    double compliance(const Material &material, const Tensor<1, 3> &n,
                      const Tensor<1, 3> &t)
    {
      if (material.is_isotropic)
        {
          const double along_n = (t * n) * (t * n);
          return along_n / (material.lame_lambda + 2. * material.shear_modulus) +
                 (t.norm_square() - along_n) / material.shear_modulus;
        }
      Tensor<2, 3> A;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int l = 0; l < 3; ++l)
              A[i][k] += n[j] * material.stiffness[i][j][k][l] * n[l];
      return t * (invert(A) * t);
    }

    class Estimator
    {
    public:
      Estimator(const LinearElasticity &elasticity, const ContactSurface &surface,
                const State &state)
        : body_(elasticity.body())
        , elasticity_(elasticity)
        , surface_(surface)
        , degree_(body_.dof_handler().get_fe().degree)
        , has_mean_dilatation_(elasticity.materials().have_mean_dilatation())
        , contact_(elasticity, surface, state.lambda)
        , smooth_(body_, surface.boundary_ids())
        , u_(body_.with_ghosts(state.u))
        , distances_(state.distances)
        , face_quadrature_(degree_ + 1)
        , inside_(body_.mapping(), body_.dof_handler().get_fe(), QGauss<3>(degree_ + 1),
                  update_gradients | update_hessians | update_quadrature_points |
                    update_JxW_values | update_inverse_jacobians)
        , face_(body_.mapping(), body_.dof_handler().get_fe(), face_quadrature_,
                update_values | update_gradients | update_normal_vectors |
                  update_quadrature_points | update_JxW_values | update_inverse_jacobians)
        , part_(body_.mapping(), body_.dof_handler().get_fe(), face_quadrature_,
                update_gradients | update_normal_vectors | update_quadrature_points |
                  update_JxW_values | update_inverse_jacobians)
        , neighbor_face_(body_.mapping(), body_.dof_handler().get_fe(), face_quadrature_,
                         update_gradients | update_quadrature_points |
                           update_inverse_jacobians)
        , neighbor_part_(body_.mapping(), body_.dof_handler().get_fe(), face_quadrature_,
                         update_gradients | update_quadrature_points |
                           update_inverse_jacobians)
      {
        for (const auto id : body_.triangulation().get_boundary_ids())
          held_[id] = elasticity.prescribed_displacement().components(id);
      }

      // η_K²
      double square(const Cell &cell)
      {
        std::optional<TrilinearCell> own;
        if (degree_ == 1 && !has_mean_dilatation_)
          own.emplace(cell, u_);
        double sum = degree_ == 1 ? 0. : residual(cell);
        for (const unsigned int f : cell->face_indices())
          sum += cell->at_boundary(f) ? at_boundary(cell, f)
                 : !own || cell->face(f)->has_children() || cell->neighbor_is_coarser(f)
                   ? between_cells(cell, f)
                   : between_alike(*own, cell, f);
        return sum;
      }

    private:
      const Material &material_of(const Cell &cell) const
      {
        return elasticity_.materials().of(cell->material_id());
      }

      // b + div σ at the quadrature points inside, where inside_ is
      std::vector<Tensor<1, 3>> out_of_balance(const Material &material) const
      {
        std::vector<Tensor<3, 3>> second(inside_.n_quadrature_points);
        inside_[displacement_].get_function_hessians(u_, second);
        std::vector<Tensor<1, 3>> r(second.size());
        Tensor<1, 3> volume; // ∇ of the volume strain
        if (has_mean_dilatation_)
          volume = CellDilatation(inside_, u_).gradient();
        for (unsigned int q = 0; q < r.size(); ++q)
          {
            r[q] =
              elasticity_.loads().inside(material.density, inside_.quadrature_point(q));
            for (unsigned int j = 0; j < 3; ++j)
              {
                SymmetricTensor<2, 3> strain; // its derivative along x_j
                for (unsigned int k = 0; k < 3; ++k)
                  for (unsigned int l = k; l < 3; ++l)
                    strain[k][l] = (second[q][k][l][j] + second[q][l][k][j]) / 2.;
                if (has_mean_dilatation_)
                  strain = deviator(strain) +
                           volume[j] / 3. * unit_symmetric_tensor<3, double>();
                const auto stress = material.stress(strain);
                for (unsigned int i = 0; i < 3; ++i)
                  r[q][i] += stress[i][j];
              }
          }
        return r;
      }

      // Σ_d h_d²/60 ∫ r_d·A_d⁻¹ r_d with r_d the part of the residual that is
      // linear across the cell in its direction d, and what is left of it
      double residual(const Cell &cell)
      {
        const Material &material = material_of(cell);
        inside_.reinit(cell);
        const auto r = out_of_balance(material);

        std::array<Tensor<1, 3>, 3> moment, row;
        double volume = 0., square = 0.;
        for (const unsigned int q : inside_.quadrature_point_indices())
          {
            const double JxW = inside_.JxW(q);
            volume += JxW;
            square += r[q].norm_square() * JxW;
            for (unsigned int d = 0; d < 3; ++d)
              {
                const double xi = inside_.get_quadrature().point(q)[d] - 0.5;
                moment[d] += std::sqrt(12.) * xi * JxW * r[q];
                row[d] += inside_.inverse_jacobian(q)[d] * JxW;
              }
          }

        double sum = 0., rest = square;
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double height  = volume / row[d].norm();
            const Tensor<1, 3> n = row[d] / row[d].norm();
            sum += height * height * compliance(material, n, moment[d]) / volume;
            rest -= moment[d].norm_square() / volume;
          }
        return (sum + std::pow(volume, 2. / 3.) / material.youngs_modulus *
                        std::max(rest, 0.)) /
               60.;
      }

      struct StressAt
      {
        SymmetricTensor<2, 3> stress;
        double height; // of the cell above the face
      };

      // at the quadrature points of a face
      std::vector<StressAt> stresses(const FEFaceValuesBase<3> &values, const Cell &cell)
      {
        std::vector<SymmetricTensor<2, 3>> strains(values.n_quadrature_points);
        values[displacement_].get_function_symmetric_gradients(u_, strains);
        if (has_mean_dilatation_)
          {
            inside_.reinit(cell);
            const CellDilatation dilatation(inside_, u_);
            for (const unsigned int q : values.quadrature_point_indices())
              strains[q] =
                deviator(strains[q]) + dilatation.at(values.quadrature_point(q)) / 3. *
                                         unit_symmetric_tensor<3, double>();
          }
        const Material &material = material_of(cell);
        const unsigned int d     = values.get_face_number() / 2;
        std::vector<StressAt> all(strains.size());
        for (unsigned int q = 0; q < all.size(); ++q)
          all[q] = {material.stress(strains[q]),
                    1. / Tensor<1, 3>(values.inverse_jacobian(q)[d]).norm()};
        return all;
      }

      // of a residual of σn on a face
      double of_residual(const Material &material, const Tensor<1, 3> &n,
                         const double height, const Tensor<1, 3> &residual) const
      {
        return height / (6. * degree_) * compliance(material, n, residual);
      }

      // of this cell's part of a jump of σn
      double jump(const Material &material, const Tensor<1, 3> &n, const StressAt &own,
                  const StressAt &other) const
      {
        const double part = own.height / (own.height + other.height);
        return of_residual(material, n, own.height,
                           part * ((own.stress - other.stress) * n));
      }

      double jump(const FEFaceValuesBase<3> &own, const Cell &cell,
                  const FEFaceValuesBase<3> &other, const Cell &neighbor)
      {
        const auto here = stresses(own, cell), there = stresses(other, neighbor);
        double sum = 0.;
        for (unsigned int q = 0; q < here.size(); ++q)
          sum +=
            jump(material_of(cell), own.normal_vector(q), here[q], there[q]) * own.JxW(q);
        return sum;
      }

      double between_cells(const Cell &cell, const unsigned int f)
      {
        const auto face = cell->face(f);
        if (face->has_children()) // small cells on the other side
          {
            const unsigned int of_neighbor = cell->neighbor_of_neighbor(f);
            double sum                     = 0.;
            for (unsigned int s = 0; s < face->n_children(); ++s)
              {
                const Cell neighbor = cell->neighbor_child_on_subface(f, s);
                part_.reinit(cell, f, s);
                neighbor_face_.reinit(neighbor, of_neighbor);
                sum += jump(part_, cell, neighbor_face_, neighbor);
              }
            return sum;
          }

        const Cell neighbor = cell->neighbor(f);
        face_.reinit(cell, f);
        if (cell->neighbor_is_coarser(f))
          {
            const auto place = cell->neighbor_of_coarser_neighbor(f);
            neighbor_part_.reinit(neighbor, place.first, place.second);
            return jump(face_, cell, neighbor_part_, neighbor);
          }
        neighbor_face_.reinit(neighbor, cell->neighbor_of_neighbor(f));
        return jump(face_, cell, neighbor_face_, neighbor);
      }

      // the same for trilinear cells that share the whole face
      double between_alike(const TrilinearCell &own, const Cell &cell,
                           const unsigned int f) const
      {
        const Cell neighbor            = cell->neighbor(f);
        const unsigned int of_neighbor = cell->neighbor_of_neighbor(f);
        const TrilinearCell other(neighbor, u_);
        const Material &material          = material_of(cell);
        const Material &neighbor_material = material_of(neighbor);
        const auto vertex                 = [](const Cell &of, const unsigned int face,
                               const unsigned int a) {
          return of->vertex_index(GeometryInfo<3>::face_to_cell_vertices(face, a));
        };

        double sum = 0.;
        for (unsigned int a = 0; a < 4; ++a)
          {
            unsigned int b = 0;
            while (b < 3 && vertex(neighbor, of_neighbor, b) != vertex(cell, f, a))
              ++b;
            const auto here = own.at(f, a), there = other.at(of_neighbor, b);
            sum +=
              jump(material, here.normal, {material.stress(here.strain), here.height},
                   {neighbor_material.stress(there.strain), there.height}) *
              here.JxW;
          }
        return sum;
      }

      // of t − σn, and on the contact boundary E/h ‖g⁻‖² + ∫ p g⁺
      double at_boundary(const Cell &cell, const unsigned int f)
      {
        const auto id = cell->face(f)->boundary_id();
        const bool is_contact =
          surface_.is_contact_boundary(id) || surface_.is_other_side(id);
        const std::string &held = held_[id];
        if (!is_contact && held == "xyz")
          return 0.;
        face_.reinit(cell, f);
        std::vector<Tensor<1, 3>> contact(face_.n_quadrature_points);
        if (is_contact)
          contact = contact_.at_points(face_, cell);
        if (contact.empty()) // held at all nodes
          return 0.;

        const Material &material = material_of(cell);
        const auto at            = stresses(face_, cell);
        double sum               = 0.;
        for (unsigned int q = 0; q < at.size(); ++q)
          {
            const Tensor<1, 3> n = face_.normal_vector(q);
            Tensor<1, 3> r =
              elasticity_.loads().traction(id, face_.quadrature_point(q), n) +
              contact[q] - at[q].stress * n;
            for (const char component : held)
              r[component - 'x'] = 0.;
            sum += of_residual(material, n, at[q].height, r) * face_.JxW(q);
          }
        if (surface_.is_contact_boundary(id) && !surface_.boundary(id).is_pair())
          sum +=
            between_contact_nodes(cell, contact, material.youngs_modulus / at[0].height);
        return sum;
      }

      // the face is that of face_
      double between_contact_nodes(const Cell &cell,
                                   const std::vector<Tensor<1, 3>> &contact,
                                   const double stiffness) const
      {
        const auto id            = cell->face(face_.get_face_number())->boundary_id();
        const auto &boundary     = surface_.boundary(id);
        const Tensor<1, 3> moved = surface_.obstacle_displacement(id, distances_);
        std::vector<Tensor<1, 3>> u(face_.n_quadrature_points);
        face_[displacement_].get_function_values(u_, u);
        const auto on_surface = smooth_.at_points(face_, cell);
        double sum            = 0.;
        for (unsigned int q = 0; q < u.size(); ++q)
          {
            ContactNode place;
            place.position = on_surface[q].position;
            place.normal   = on_surface[q].normal;
            if (boundary.slides_far())
              place.moved = u[q] - moved;
            if (!boundary.place(place))
              continue;
            const double gap      = place.gap + place.normal * (moved - u[q]);
            const double pressure = -contact[q] * place.normal;
            sum += (gap < 0. ? stiffness * gap * gap : std::max(pressure, 0.) * gap) *
                   face_.JxW(q);
          }
        return sum;
      }

      const Body &body_;
      const LinearElasticity &elasticity_;
      const ContactSurface &surface_;
      const unsigned int degree_;
      const bool has_mean_dilatation_;
      std::map<types::boundary_id, std::string> held_; // components
      ContactTraction contact_;
      SmoothBoundary smooth_;
      const LA::Vector u_;
      const Eigen::VectorXd distances_; // of pressed obstacles
      const QGauss<2> face_quadrature_;
      const FEValuesExtractors::Vector displacement_{0};
      FEValues<3> inside_;
      FEFaceValues<3> face_;
      FESubfaceValues<3> part_;
      FEFaceValues<3> neighbor_face_;
      FESubfaceValues<3> neighbor_part_;
    };
  } // namespace

  std::function<double(const Cell &)> cell_error(const LinearElasticity &elasticity,
                                                 const ContactSurface &surface,
                                                 const State &state)
  {
    const auto estimator = std::make_shared<Estimator>(elasticity, surface, state);
    return [estimator](const Cell &cell) { return estimator->square(cell); };
  }
} // namespace stiction
