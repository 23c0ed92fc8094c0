#include <stiction/contact/contact_boundary.h>
#include <stiction/contact/contact_surface.h>
#include <stiction/contact/error_estimator.h>
#include <stiction/elasticity/body.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/elasticity/loads.h>
#include <stiction/elasticity/materials.h>
#include <stiction/elasticity/prescribed_displacement.h>
#include <stiction/errors.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Cell      = DoFHandler<3>::active_cell_iterator;
    using Tractions = std::vector<Tensor<1, 3>>;

    // Of the own cells and their neighbours.
    LA::Vector
    with_ghosts(const Body &body, const LA::Vector &u)
    {
      LA::Vector ghosted(body.locally_owned_dofs(),
                         body.locally_relevant_dofs(),
                         body.communicator());
      ghosted.copy_locally_owned_data_from(u);
      ghosted.update_ghost_values();
      return ghosted;
    }



    // The contact tractions on the body, interpolated between the nodes.
    class ContactTraction
    {
    public:
      ContactTraction(const LinearElasticity &elasticity,
                      const ContactSurface &surface,
                      const Eigen::VectorXd &lambda)
        : elasticity_(elasticity)
        , surface_(surface)
        , force_(surface.force_to_cartesian(lambda))
        , fe_(elasticity.body().dof_handler().get_fe())
        , dofs_(fe_.n_dofs_per_cell())
      {
      }

      // At the quadrature points of a face of a contact boundary; nothing if it
      // is known at none of its nodes.
      Tractions
      at_points(const FEFaceValues<3> &values, const Cell &cell)
      {
        cell->get_dof_indices(dofs_);
        const unsigned int f = values.get_face_number();
        const auto id        = cell->face(f)->boundary_id();
        std::vector<std::optional<Tensor<1, 3>>> at_nodes(
          fe_.n_dofs_per_face(f) / 3);
        Tensor<1, 3> mean;
        double n_known = 0.;
        for (unsigned int a = 0; a < at_nodes.size(); ++a)
          {
            at_nodes[a] = at_node(dofs_[fe_.face_to_cell_index(3 * a, f)], id);
            if (at_nodes[a])
              {
                mean += *at_nodes[a];
                n_known += 1.;
              }
          }
        if (n_known == 0.)
          return {};
        mean /= n_known;

        Tractions tractions(values.n_quadrature_points);
        for (unsigned int a = 0; a < at_nodes.size(); ++a)
          for (unsigned int q = 0; q < tractions.size(); ++q)
            tractions[q] +=
              values.shape_value(fe_.face_to_cell_index(3 * a, f), q) *
              at_nodes[a].value_or(mean);
        return tractions;
      }

    private:
      // Zero at a free node that faces away from the obstacle; nothing where a
      // support may carry the load, or another contact boundary.
      std::optional<Tensor<1, 3>>
      at_node(const types::global_dof_index first_dof,
              const types::boundary_id id) const
      {
        Tensor<1, 3> traction;
        if (elasticity_.is_hanging(first_dof))
          {
            for (const auto &master :
                 *elasticity_.body().hanging_nodes().get_constraint_entries(
                   first_dof))
              {
                const auto at_master = at_node(master.first, id);
                if (!at_master)
                  return std::nullopt;
                traction += master.second * *at_master;
              }
            return traction;
          }

        const Eigen::Index m = surface_.n_nodes();
        const Eigen::Index i = surface_.node_of(first_dof);
        if (i >= 0)
          {
            const ContactNode &node = surface_.nodes()[i];
            if (surface_.boundaries()[node.boundary].id() != id)
              return std::nullopt;
            for (unsigned int c = 0; c < 3; ++c)
              traction[c] = -force_(i + c * m) / node.area;
            return traction;
          }
        for (unsigned int c = 0; c < 3; ++c)
          if (elasticity_.is_prescribed(first_dof + c))
            return std::nullopt;
        return traction;
      }

      const LinearElasticity &elasticity_;
      const ContactSurface &surface_;
      const Eigen::VectorXd force_; // on the obstacle, by blocks (x; y; z)
      const FiniteElement<3> &fe_;
      std::vector<types::global_dof_index> dofs_;
    };



    class Estimator
    {
    public:
      Estimator(const LinearElasticity &elasticity,
                const ContactSurface &surface,
                const LA::Vector &u,
                const Eigen::VectorXd &lambda)
        : body_(elasticity.body())
        , elasticity_(elasticity)
        , surface_(surface)
        , contact_(elasticity, surface, lambda)
        , u_(with_ghosts(body_, u))
        , face_quadrature_(body_.dof_handler().get_fe().degree + 1)
        , inside_(body_.mapping(),
                  body_.dof_handler().get_fe(),
                  QGauss<3>(body_.dof_handler().get_fe().degree + 1),
                  update_gradients | update_hessians |
                    update_quadrature_points | update_JxW_values)
        , face_(body_.mapping(),
                body_.dof_handler().get_fe(),
                face_quadrature_,
                update_values | update_gradients | update_normal_vectors |
                  update_quadrature_points | update_JxW_values)
        , part_(body_.mapping(),
                body_.dof_handler().get_fe(),
                face_quadrature_,
                update_gradients | update_normal_vectors | update_JxW_values)
        , neighbor_face_(body_.mapping(),
                         body_.dof_handler().get_fe(),
                         face_quadrature_,
                         update_gradients)
        , neighbor_part_(body_.mapping(),
                         body_.dof_handler().get_fe(),
                         face_quadrature_,
                         update_gradients)
      {
      }

      // η_K²
      double
      operator()(const Cell &cell)
      {
        double sum = residual(cell);
        for (const unsigned int f : cell->face_indices())
          sum += cell->face(f)->at_boundary() ? at_boundary(cell, f)
                                              : between_cells(cell, f);
        return sum;
      }

    private:
      const Material &
      material_of(const Cell &cell) const
      {
        return elasticity_.materials().of(cell->material_id());
      }

      // of ∇·u over the cell
      double
      mean_dilatation(const Cell &cell)
      {
        inside_.reinit(cell);
        std::vector<double> divergence(inside_.n_quadrature_points);
        inside_[displacement_].get_function_divergences(u_, divergence);
        double sum = 0., volume = 0.;
        for (const unsigned int q : inside_.quadrature_point_indices())
          {
            sum += divergence[q] * inside_.JxW(q);
            volume += inside_.JxW(q);
          }
        return sum / volume;
      }

      // h²/E ‖b + div σ‖²
      double
      residual(const Cell &cell)
      {
        const Material &material = material_of(cell);
        inside_.reinit(cell);
        std::vector<Tensor<3, 3>> second(inside_.n_quadrature_points);
        inside_[displacement_].get_function_hessians(u_, second);
        double sum = 0.;
        for (const unsigned int q : inside_.quadrature_point_indices())
          {
            Tensor<1, 3> r = elasticity_.loads().inside(
              material.density, inside_.quadrature_point(q));
            for (unsigned int j = 0; j < 3; ++j)
              {
                SymmetricTensor<2, 3> strain; // its derivative along x_j
                for (unsigned int k = 0; k < 3; ++k)
                  for (unsigned int l = k; l < 3; ++l)
                    strain[k][l] =
                      (second[q][k][l][j] + second[q][l][k][j]) / 2.;
                if (elasticity_.materials().have_mean_dilatation())
                  strain = deviator(strain);
                const auto stress = material.stress(strain);
                for (unsigned int i = 0; i < 3; ++i)
                  r[i] += stress[i][j];
              }
            sum += r.norm_square() * inside_.JxW(q);
          }
        const double h = cell->diameter();
        return h * h / material.youngs_modulus * sum;
      }

      // σn at the quadrature points of a face
      Tractions
      tractions(const FEFaceValuesBase<3> &values,
                const Cell &cell,
                const FEFaceValuesBase<3> &with_normals)
      {
        std::vector<SymmetricTensor<2, 3>> strains(values.n_quadrature_points);
        values[displacement_].get_function_symmetric_gradients(u_, strains);
        if (elasticity_.materials().have_mean_dilatation())
          {
            const double dilatation = mean_dilatation(cell);
            for (auto &strain : strains)
              strain = deviator(strain) +
                       dilatation / 3. * unit_symmetric_tensor<3, double>();
          }
        Tractions t(strains.size());
        for (unsigned int q = 0; q < t.size(); ++q)
          t[q] = material_of(cell).stress(strains[q]) *
                 with_normals.normal_vector(q);
        return t;
      }

      // h_F/E ‖J_F‖² with half of the jump
      double
      jump(const FEFaceValuesBase<3> &own,
           const Cell &cell,
           const FEFaceValuesBase<3> &other,
           const Cell &neighbor,
           const double diameter)
      {
        const Tractions t         = tractions(own, cell, own);
        const Tractions on_others = tractions(other, neighbor, own);
        double sum                = 0.;
        for (unsigned int q = 0; q < t.size(); ++q)
          sum += (t[q] - on_others[q]).norm_square() / 4. * own.JxW(q);
        return diameter / material_of(cell).youngs_modulus * sum;
      }

      double
      between_cells(const Cell &cell, const unsigned int f)
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
                sum += jump(part_,
                            cell,
                            neighbor_face_,
                            neighbor,
                            neighbor->face(of_neighbor)->diameter());
              }
            return sum;
          }

        const Cell neighbor = cell->neighbor(f);
        face_.reinit(cell, f);
        if (cell->neighbor_is_coarser(f))
          {
            const auto place = cell->neighbor_of_coarser_neighbor(f);
            neighbor_part_.reinit(neighbor, place.first, place.second);
            return jump(
              face_, cell, neighbor_part_, neighbor, face->diameter());
          }
        neighbor_face_.reinit(neighbor, cell->neighbor_of_neighbor(f));
        return jump(face_, cell, neighbor_face_, neighbor, face->diameter());
      }

      // h_F/E ‖t − σn‖², and on the contact boundary E/h_F ‖g⁻‖² + ∫ p g⁺
      double
      at_boundary(const Cell &cell, const unsigned int f)
      {
        const auto face       = cell->face(f);
        const auto id         = face->boundary_id();
        const bool is_contact = surface_.is_contact_boundary(id);
        face_.reinit(cell, f);
        Tractions contact(face_.n_quadrature_points);
        if (is_contact)
          contact = contact_.at_points(face_, cell);
        if (contact.empty()) // held at all nodes
          return 0.;

        const Tractions t = tractions(face_, cell, face_);
        const double stiffness =
          material_of(cell).youngs_modulus / face->diameter();
        const std::string held =
          elasticity_.prescribed_displacement().components(id);
        double sum = 0.;
        for (unsigned int q = 0; q < t.size(); ++q)
          {
            Tensor<1, 3> r =
              elasticity_.loads().traction(
                id, face_.quadrature_point(q), face_.normal_vector(q)) +
              contact[q] - t[q];
            for (const char component : held)
              r[component - 'x'] = 0.;
            sum += r.norm_square() / stiffness * face_.JxW(q);
          }
        return is_contact ? sum + between_contact_nodes(id, contact, stiffness)
                          : sum;
      }

      // the face is that of face_
      double
      between_contact_nodes(const types::boundary_id id,
                            const Tractions &contact,
                            const double stiffness) const
      {
        const ContactBoundary &boundary = surface_.boundary(id);
        const Tensor<1, 3> moved        = surface_.obstacle_displacement(id);
        std::vector<Tensor<1, 3>> u(face_.n_quadrature_points);
        face_[displacement_].get_function_values(u_, u);
        double sum = 0.;
        for (unsigned int q = 0; q < u.size(); ++q)
          {
            ContactNode place;
            place.position = face_.quadrature_point(q);
            place.normal   = face_.normal_vector(q);
            if (!boundary.place(place))
              continue;
            const double gap      = place.gap + place.normal * (moved - u[q]);
            const double pressure = -contact[q] * place.normal;
            sum += (gap < 0. ? stiffness * gap * gap
                             : std::max(pressure, 0.) * gap) *
                   face_.JxW(q);
          }
        return sum;
      }

      const Body &body_;
      const LinearElasticity &elasticity_;
      const ContactSurface &surface_;
      ContactTraction contact_;
      const LA::Vector u_;
      const QGauss<2> face_quadrature_;
      const FEValuesExtractors::Vector displacement_{0};
      FEValues<3> inside_;
      FEFaceValues<3> face_;
      FESubfaceValues<3> part_;
      FEFaceValues<3> neighbor_face_;
      FESubfaceValues<3> neighbor_part_;
    };
  } // namespace



  Vector<double>
  estimate_error(const LinearElasticity &elasticity,
                 const ContactSurface &surface,
                 const LA::Vector &u,
                 const Eigen::VectorXd &lambda)
  {
    const Body &body = elasticity.body();
    Vector<double> squares(body.triangulation().n_active_cells());
    Estimator estimator(elasticity, surface, u, lambda);
    together(body.communicator(), [&]() {
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          squares[cell->active_cell_index()] = estimator(cell);
    });
    return squares;
  }
} // namespace stiction
