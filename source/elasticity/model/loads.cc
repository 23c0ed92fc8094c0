#include <stiction/base/errors.h>
#include <stiction/base/text/parameter_file.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/body_parameters.h>
#include <stiction/elasticity/model/boundary_parameters.h>
#include <stiction/elasticity/model/loads.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/model/prescribed_displacement.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <string>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    BoundaryFunctions read_boundary_load(
      const Body &body, const PrescribedDisplacement &prescribed,
      const BodyParameters &parameters, const std::string &name,
      const std::string &load_name, const std::string &text,
      const unsigned int n_components, const double time)
    {
      const std::string location =
        parameters.source.locate("Boundary conditions/" + name);
      BoundaryFunctions functions = parse_boundary_functions(
        text, location, body.boundary_names(), n_components, false, time);
      for (const auto &load : functions)
        if (prescribed.holds_completely(load.first))
          throw InputError(location + ": boundary " +
                           body.boundary_names().describe(load.first) +
                           " already has a prescribed displacement, a " + load_name +
                           " there is carried by the support alone; "
                           "allowed is one of the two.");
      return functions;
    }

    std::unique_ptr<ParsedFunction> read_volume_load(const BodyParameters &parameters,
                                                     const std::string &entry,
                                                     const std::string &text,
                                                     const double time)
    {
      if (Utilities::trim(text).empty())
        return nullptr;
      return std::make_unique<ParsedFunction>(text, 3, parameters.source.locate(entry),
                                              time);
    }

    // Calls back with the values on each face of the boundary whose cell this
    // rank owns.
    template<typename IsWanted, typename Callback>
    void for_each_boundary_face(const Body &body, const IsWanted &is_wanted,
                                const Callback &callback)
    {
      const FiniteElement<3> &fe = body.dof_handler().get_fe();
      const QGauss<2> quadrature(fe.degree + 1);
      FEFaceValues<3> values(body.mapping(), fe, quadrature,
                             update_values | update_quadrature_points |
                               update_JxW_values | update_normal_vectors);
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && is_wanted(face->boundary_id()))
              {
                values.reinit(cell, face);
                callback(cell, face->boundary_id(), values);
              }
    }

    // Adds the integrals of a force, given at quadrature points, with the functions of a
    // cell; an unknown that hangs passes its own on.
    template<typename Cell, typename Values, typename Force>
    void integrate(const Body &body, const Cell &cell, const Values &values,
                   const Force &force_at, LA::Vector &load)
    {
      const FiniteElement<3> &fe = values.get_fe();
      std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
      cell->get_dof_indices(indices);
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const Tensor<1, 3> force = force_at(q);
          for (const unsigned int i : values.dof_indices())
            {
              const double f = force[fe.system_to_component_index(i).first] *
                               values.shape_value(i, q) * values.JxW(q);
              for (const auto &[followed, weight] : body.followed_by(indices[i]))
                load(followed) += weight * f;
            }
        }
    }
  } // namespace

  Loads::Loads(const Body &body, const PrescribedDisplacement &prescribed,
               const BodyParameters &parameters, const double time)
    : body_(body)
    , traction_(read_boundary_load(body, prescribed, parameters, "Traction", "traction",
                                   parameters.boundary.traction, 3, time))
    , pressure_(read_boundary_load(body, prescribed, parameters, "Pressure", "pressure",
                                   parameters.boundary.pressure, 1, time))
    , body_force_(read_volume_load(parameters, "Boundary conditions/Body force",
                                   parameters.boundary.body_force, time))
    , gravity_(read_volume_load(parameters, "Boundary conditions/Gravity",
                                parameters.boundary.gravity, time))
  {
  }

  Loads::~Loads() = default;

  void Loads::assemble(const Materials &materials, LA::Vector &load) const
  {
    throw_on_all_ranks(body_.communicator(), [&]() {
      add_boundary_loads(load);
      if (body_force_ || gravity_)
        add_volume_loads(materials, load);
    });
    load.compress(VectorOperation::add);
  }

  Tensor<1, 3> Loads::traction(const types::boundary_id boundary, const Point<3> &x,
                               const Tensor<1, 3> &normal) const
  {
    Tensor<1, 3> sum;
    const auto pull = traction_.find(boundary);
    for (unsigned int c = 0; c < 3 && pull != traction_.end(); ++c)
      sum[c] = pull->second.function->value(x, c);
    const auto pressure = pressure_.find(boundary);
    if (pressure != pressure_.end())
      sum -= pressure->second.function->value(x) * normal;
    return sum;
  }

  std::string Loads::description(const types::boundary_id boundary) const
  {
    std::string text;
    const auto add = [&](const char *name, const BoundaryFunctions &functions) {
      const auto function = functions.find(boundary);
      if (function != functions.end())
        text += (text.empty() ? "" : ", ") + std::string(name) +
                function->second.function->expression();
    };
    add("traction ", traction_);
    add("pressure ", pressure_);
    return text;
  }

  std::string Loads::description_inside() const
  {
    std::string text;
    if (body_force_)
      text = "body force " + body_force_->expression();
    if (gravity_)
      text += (text.empty() ? "" : ", ") + ("gravity " + gravity_->expression());
    return text;
  }

  Tensor<1, 3> Loads::inside(const double density, const Point<3> &x) const
  {
    Tensor<1, 3> force;
    for (unsigned int c = 0; c < 3; ++c)
      force[c] = (body_force_ ? body_force_->value(x, c) : 0.) +
                 (gravity_ ? density * gravity_->value(x, c) : 0.);
    return force;
  }

  std::map<types::boundary_id, Loads::OnBoundary> Loads::on_boundaries() const
  {
    std::map<types::boundary_id, OnBoundary> sums;
    for (const auto id : body_.boundary_names().ids())
      sums[id] = {};
    for_each_boundary_face(
      body_, [](types::boundary_id) { return true; },
      [&](const auto &, const types::boundary_id id, const auto &values) {
        OnBoundary &sum = sums[id];
        for (const unsigned int q : values.quadrature_point_indices())
          {
            sum.area += values.JxW(q);
            sum.force += values.JxW(q) * traction(id, values.quadrature_point(q),
                                                  values.normal_vector(q));
          }
      });
    for (auto &boundary : sums)
      {
        OnBoundary &sum = boundary.second;
        sum.area        = Utilities::MPI::sum(sum.area, body_.communicator());
        sum.force       = Utilities::MPI::sum(sum.force, body_.communicator());
      }
    return sums;
  }

  void Loads::add_boundary_loads(LA::Vector &load) const
  {
    for_each_boundary_face(
      body_,
      [&](const types::boundary_id id) {
        return traction_.count(id) > 0 || pressure_.count(id) > 0;
      },
      [&](const auto &cell, const types::boundary_id id, const auto &values) {
        const auto force = [&](const unsigned int q) {
          return traction(id, values.quadrature_point(q), values.normal_vector(q));
        };
        integrate(body_, cell, values, force, load);
      });
  }

  void Loads::add_volume_loads(const Materials &materials, LA::Vector &load) const
  {
    const FiniteElement<3> &fe = body_.dof_handler().get_fe();
    const QGauss<3> quadrature(fe.degree + 1);
    FEValues<3> values(body_.mapping(), fe, quadrature,
                       update_values | update_quadrature_points | update_JxW_values);
    for (const auto &cell : body_.locally_owned_cells())
      {
        values.reinit(cell);
        const auto force = [&](const unsigned int q) {
          return inside(materials.of(cell->material_id()).density,
                        values.quadrature_point(q));
        };
        integrate(body_, cell, values, force, load);
      }
  }
} // namespace stiction
