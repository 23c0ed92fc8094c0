// The estimated error of the mesh where a curved boundary lies in an obstacle of the
// same shape: a thick spherical shell in a rigid cavity, blown up from inside. The exact
// displacement is radial, A r + B/r², so the error in the energy norm is known. Then the
// bracket, whose hole is pressed by a pin almost as large.

#include "tests.h"

#include <stiction/contact/certificate/error_estimator.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>
#include <vector>

using namespace stiction;

namespace
{
  constexpr double inner = 0.5, outer = 1., growth = 2e-2;
  // A outer + B/outer² = 0, A inner + B/inner² = growth inner
  const double B = growth / (std::pow(inner, -3.) - std::pow(outer, -3.));
  const double A = -B / std::pow(outer, 3.);

  using Strain = dealii::SymmetricTensor<2, 3>;

  Strain exact_strain(const dealii::Point<3> &p)
  {
    const double r = p.norm();
    return A * dealii::unit_symmetric_tensor<3>() +
           B / std::pow(r, 3.) *
             (dealii::unit_symmetric_tensor<3>() -
              3. / (r * r) *
                dealii::symmetrize(dealii::outer_product(dealii::Tensor<1, 3>(p),
                                                         dealii::Tensor<1, 3>(p))));
  }

  // ‖u − u_h‖ in the energy norm.
  double error(const Run &run)
  {
    const LinearElasticity &elasticity = run.problem->elasticity();
    const Body &body                   = elasticity.body();
    const LA::Vector u                 = body.with_ghosts(run.problem->state().u);
    dealii::FEValues<3> values(
      body.mapping(), body.dof_handler().get_fe(), dealii::QGauss<3>(3),
      dealii::update_gradients | dealii::update_quadrature_points |
        dealii::update_JxW_values);
    std::vector<Strain> strains(values.n_quadrature_points);
    double sum = 0.;
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          values.reinit(cell);
          values[dealii::FEValuesExtractors::Vector(0)].get_function_symmetric_gradients(
            u, strains);
          const Material &material = elasticity.materials().of(cell->material_id());
          for (const unsigned int q : values.quadrature_point_indices())
            {
              const Strain e = strains[q] - exact_strain(values.quadrature_point(q));
              sum += e * material.stress(e) * values.JxW(q);
            }
        }
    return std::sqrt(dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD));
  }

  double estimate(const Run &run)
  {
    const ContactProblem &problem = *run.problem;
    double sum                    = 0.;
    for (const double square :
         estimate_error(problem.elasticity(), problem.contact_surface(), problem.state()))
      sum += square;
    return std::sqrt(dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD));
  }

  Run shell(const Settings &mesh)
  {
    const std::string blown = exact(growth);
    return Run(
      shipped("half_ball.prm"),
      Settings{"Geometry/Type=generator", "Geometry/Generator=hyper_shell",
               "Geometry/Generator arguments=0, 0, 0 : " + exact(inner) + " : " +
                 exact(outer) + " : 12 : true",
               "Boundary conditions/Prescribed displacement=0 : " + blown + "*x; " +
                 blown + "*y; " + blown + "*z",
               "Boundary conditions/Contact boundary=1",
               "Boundary conditions/Obstacle=formula : 1 - sqrt(x^2 + y^2 + z^2)",
               "Boundary conditions/Initial gap=0", "Friction/Law=frictionless",
               "Output/Write solution=false"} +
        mesh);
  }

  // @param order the estimate falls by 2^order with the cells halved
  void compare(const std::string &name, const std::vector<Settings> &meshes,
               const unsigned int order)
  {
    const double falls = std::pow(0.5, order);
    double last        = 0.;
    for (const Settings &mesh : meshes)
      {
        const Run run    = shell(mesh);
        const double eta = estimate(run), e = error(run);
        out() << name << ", " << mesh.back() << ": certified " << yes(run.converged)
              << ", estimate between 0.7 and 1.5 of the error "
              << yes(eta > 0.7 * e && eta < 1.5 * e);
        if (last > 0.)
          out() << ", falls to " << falls << " of the last "
                << yes(eta > 0.8 * falls * last && eta < 1.2 * falls * last);
        out() << std::endl;
        last = eta;
      }
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  compare("shell", {{"Geometry/Global refinement=2"}, {"Geometry/Global refinement=3"}},
          1);
  compare("shell of degree 2",
          {{"Geometry/Element degree=2", "Geometry/Global refinement=1"},
           {"Geometry/Element degree=2", "Geometry/Global refinement=2"}},
          2);
  compare("with hanging nodes",
          {{"Geometry/Contact refinement where=z", "Geometry/Contact refinement=1",
            "Geometry/Global refinement=2"},
           {"Geometry/Contact refinement where=z", "Geometry/Contact refinement=1",
            "Geometry/Global refinement=3"}},
          1);

  double last = 1.;
  for (const unsigned int steps : {0, 1, 2})
    {
      const Run run(shipped("bracket.prm"),
                    {"Refinement/Adaptive steps=" + std::to_string(steps),
                     "Output/Write solution=false"});
      const double relative =
        estimate(run) / std::sqrt(2. * run.problem->certificate().strain_energy());
      out() << "bracket, " << steps << " adaptive steps: certified " << yes(run.converged)
            << ", estimate below 0.3 " << yes(relative < 0.3) << ", falls "
            << yes(relative < last) << std::endl;
      last = relative;
    }
}
