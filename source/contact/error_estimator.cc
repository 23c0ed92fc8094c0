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

    // A vector of all nodes of the own and the neighbouring cells, hanging
    // ones included.
    LA::Vector
    with_ghosts(const Body &body, const LA::Vector &u)
    {
      LA::Vector owned(body.locally_owned_dofs(), body.communicator());
      owned.copy_locally_owned_data_from(u);
      body.hanging_nodes().distribute(owned);
      LA::Vector ghosted(body.locally_owned_dofs(),
                         body.locally_relevant_dofs(),
                         body.communicator());
      ghosted.copy_locally_owned_data_from(owned);
      ghosted.update_ghost_values();
      return ghosted;
    }



    // The contact tractions on the body at the nodes of the contact boundary,
    // and where they are known.
    class ContactTraction
    {
    public:
      ContactTraction(const Body &body,
                      const ContactSurface &surface,
                      const LinearElasticity &elasticity,
                      const Eigen::VectorXd &lambda)
        : fe_(body.dof_handler().get_fe())
        , dofs_(fe_.n_dofs_per_cell())
      {
        LA::Vector traction = elasticity.zero_vector();
        LA::Vector is_known = elasticity.zero_vector();
        surface.add_transpose_B(-1., lambda, traction);
        for (const Body::Node &node : body.locally_owned_nodes())
          {
            const Eigen::Index i = surface.node_of(node.dofs[0]);
            if (i < 0)
              continue;
            for (const auto dof : node.dofs)
              {
                traction(dof) /= surface.areas()(i);
                is_known(dof) = 1.;
              }
          }
        traction_ = with_ghosts(body, traction);
        is_known_ = with_ghosts(body, is_known);
      }

      // At the quadrature points of a face of the contact boundary; nothing if
      // it is known at none of its nodes.
      Tractions
      at_points(const FEFaceValues<3> &values, const Cell &cell)
      {
        cell->get_dof_indices(dofs_);
        const unsigned int f       = values.get_face_number();
        const unsigned int n_nodes = fe_.n_dofs_per_face(f) / 3;
        std::vector<bool> is_known(n_nodes);
        Tractions at_nodes(n_nodes);
        Tensor<1, 3> sum;
        unsigned int n_known = 0;
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            const unsigned int first = fe_.face_to_cell_index(3 * a, f);
            is_known[a]              = is_known_(dofs_[first]) > 1. - 1e-10;
            if (!is_known[a])
              continue;
            for (unsigned int c = 0; c < 3; ++c)
              at_nodes[a][c] = traction_(dofs_[first + c]);
            sum += at_nodes[a];
            ++n_known;
          }
        if (n_known == 0)
          return {};

        Tractions tractions(values.n_quadrature_points);
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            const Tensor<1, 3> at_node =
              is_known[a] ? at_nodes[a] : sum / static_cast<double>(n_known);
            const unsigned int first = fe_.face_to_cell_index(3 * a, f);
            for (unsigned int q = 0; q < tractions.size(); ++q)
              tractions[q] += values.shape_value(first, q) * at_node;
          }
        return tractions;
      }

    private:
      const FiniteElement<3> &fe_;
      std::vector<types::global_dof_index> dofs_;
      LA::Vector traction_, is_known_;
    };



    // What the user gave, at any point.
    class GivenData
    {
    public:
      GivenData(const LinearElasticity &elasticity,
                const ContactSurface &surface)
        : elasticity_(elasticity)
        , surface_(surface)
      {
      }

      double
      youngs_modulus(const Cell &cell) const
      {
        return elasticity_.materials().of(cell->material_id()).youngs_modulus;
      }

      SymmetricTensor<2, 3>
      stress(const Cell &cell, const SymmetricTensor<2, 3> &strain) const
      {
        return elasticity_.materials().of(cell->material_id()).stress(strain);
      }

      Tensor<1, 3>
      body_force(const Cell &cell, const Point<3> &p) const
      {
        return elasticity_.loads().inside(
          elasticity_.materials().of(cell->material_id()).density, p);
      }

      Tensor<1, 3>
      traction(const types::boundary_id id,
               const Point<3> &p,
               const Tensor<1, 3> &normal) const
      {
        return elasticity_.loads().traction(id, p, normal);
      }

      bool
      is_prescribed(const types::boundary_id id, const unsigned int c) const
      {
        return elasticity_.prescribed_displacement().components(id).find(
                 "xyz"[c]) != std::string::npos;
      }

      bool
      is_contact_boundary(const types::boundary_id id) const
      {
        return surface_.is_contact_boundary(id);
      }

      // The gap at a point of a contact boundary and the normal towards the
      // obstacle there; nothing where it faces away.
      std::optional<ContactNode>
      place(const types::boundary_id id,
            const Point<3> &p,
            const Tensor<1, 3> &normal) const
      {
        ContactNode node;
        node.position = p;
        node.normal   = normal;
        if (!surface_.boundary(id).place(node))
          return {};
        return node;
      }

    private:
      const LinearElasticity &elasticity_;
      const ContactSurface &surface_;
    };



    class Estimator
    {
    public:
      Estimator(const LinearElasticity &elasticity,
                const ContactSurface &surface,
                const LA::Vector &u,
                const Eigen::VectorXd &lambda)
        : body_(elasticity.body())
        , data_(elasticity, surface)
        , contact_(body_, surface, elasticity, lambda)
        , u_(with_ghosts(body_, u))
        , face_quadrature_(body_.dof_handler().get_fe().degree + 1)
        , inside_(body_.mapping(),
                  body_.dof_handler().get_fe(),
                  QGauss<3>(body_.dof_handler().get_fe().degree + 1),
                  update_hessians | update_quadrature_points |
                    update_JxW_values)
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
      // h²/E ‖b + div σ‖²
      double
      residual(const Cell &cell)
      {
        inside_.reinit(cell);
        std::vector<Tensor<3, 3>> second(inside_.n_quadrature_points);
        inside_[displacement_].get_function_hessians(u_, second);
        double sum = 0.;
        for (const unsigned int q : inside_.quadrature_point_indices())
          {
            Tensor<1, 3> r =
              data_.body_force(cell, inside_.quadrature_point(q));
            for (unsigned int j = 0; j < 3; ++j)
              {
                SymmetricTensor<2, 3> strain; // its derivative along x_j
                for (unsigned int k = 0; k < 3; ++k)
                  for (unsigned int l = k; l < 3; ++l)
                    strain[k][l] =
                      (second[q][k][l][j] + second[q][l][k][j]) / 2.;
                const auto stress = data_.stress(cell, strain);
                for (unsigned int i = 0; i < 3; ++i)
                  r[i] += stress[i][j];
              }
            sum += r.norm_square() * inside_.JxW(q);
          }
        const double h = cell->diameter();
        return h * h / data_.youngs_modulus(cell) * sum;
      }

      // σn at the quadrature points of a face
      Tractions
      tractions(const FEFaceValuesBase<3> &values,
                const Cell &cell,
                const FEFaceValuesBase<3> &with_normals) const
      {
        std::vector<SymmetricTensor<2, 3>> strains(values.n_quadrature_points);
        values[displacement_].get_function_symmetric_gradients(u_, strains);
        Tractions t(strains.size());
        for (unsigned int q = 0; q < t.size(); ++q)
          t[q] = data_.stress(cell, strains[q]) * with_normals.normal_vector(q);
        return t;
      }

      // h_F/E ‖J_F‖² with half of the jump
      double
      jump(const FEFaceValuesBase<3> &own,
           const Cell &cell,
           const FEFaceValuesBase<3> &other,
           const Cell &neighbor,
           const double diameter) const
      {
        const Tractions t         = tractions(own, cell, own);
        const Tractions on_others = tractions(other, neighbor, own);
        double sum                = 0.;
        for (unsigned int q = 0; q < t.size(); ++q)
          sum += (t[q] - on_others[q]).norm_square() / 4. * own.JxW(q);
        return diameter / data_.youngs_modulus(cell) * sum;
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
        const bool is_contact = data_.is_contact_boundary(id);
        face_.reinit(cell, f);
        Tractions contact(face_.n_quadrature_points);
        if (is_contact)
          contact = contact_.at_points(face_, cell);
        if (contact.empty()) // held at all nodes
          return 0.;

        const Tractions t      = tractions(face_, cell, face_);
        const double stiffness = data_.youngs_modulus(cell) / face->diameter();
        double sum             = 0.;
        for (unsigned int q = 0; q < t.size(); ++q)
          {
            const Point<3> &p = face_.quadrature_point(q);
            Tensor<1, 3> r =
              data_.traction(id, p, face_.normal_vector(q)) + contact[q] - t[q];
            for (unsigned int c = 0; c < 3; ++c)
              if (data_.is_prescribed(id, c))
                r[c] = 0.;
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
        std::vector<Tensor<1, 3>> u(face_.n_quadrature_points);
        face_[displacement_].get_function_values(u_, u);
        double sum = 0.;
        for (unsigned int q = 0; q < u.size(); ++q)
          {
            const auto place = data_.place(
              id, face_.quadrature_point(q), face_.normal_vector(q));
            if (!place)
              continue;
            const double gap      = place->gap - place->normal * u[q];
            const double pressure = -contact[q] * place->normal;
            sum += (gap < 0. ? stiffness * gap * gap
                             : std::max(pressure, 0.) * gap) *
                   face_.JxW(q);
          }
        return sum;
      }

      const Body &body_;
      const GivenData data_;
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
