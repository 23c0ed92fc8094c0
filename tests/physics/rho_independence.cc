// The number ρ of the Newton method in displacements and what it falls back to
// are no part of the answer: over four decades of ρ, and by the interior
// point method alone, the contact forces are the same to 1e-6. The extremes need
// the globalisation, which is seen to work.

#include "tests.h"

#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/primal/newton_multigrid.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

using namespace stiction;

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  bool has_changed_rho = false, has_fallen_back = false;
  for (const std::string law : {"coulomb", "given"})
    {
      Parameters parameters;
      parameters.read(shipped("brick.prm"),
                      {"Geometry/Table 1 level=2", "Friction/Law=" + law,
                       "Friction/Slip stress=1.5e7",
                       "Contact solver/Method=newton multigrid"});
      const Body body(parameters.geometry, MPI_COMM_WORLD);
      const LinearElasticity elasticity(body, parameters.of_body());
      const ContactSurface surface(elasticity, parameters.of_contact());

      Eigen::VectorXd reference;
      const auto run = [&](const std::string &name, const LevelNewton::Options &options) {
        NewtonMultigrid newton(elasticity, surface, true, options);
        State state;
        const auto status = newton.solve(state, 1e-9, 1000, [](const ContactStep &) {});
        const Certificate certificate(elasticity, surface, state);
        if (reference.size() == 0)
          reference = state.lambda;
        for (const LevelNewton::Statistics &level : newton.statistics())
          {
            has_changed_rho = has_changed_rho || level.rho_changes > 0;
            has_fallen_back = has_fallen_back || level.fallbacks > 0;
          }
        out() << law << ", " << name << ": certified "
              << yes(status.converged && certificate.converged(1e-9))
              << ", same forces to 1e-6 "
              << yes((state.lambda - reference).norm() < 1e-6 * reference.norm())
              << std::endl;
      };

      for (const double c : {0.1, 1e-3, 1e-2, 1., 10.})
        {
          LevelNewton::Options options;
          options.first_c = c;
          run("rho = " + std::to_string(c) + " of the stiffness", options);
        }
      LevelNewton::Options options;
      options.only_fallback = true;
      run("interior point method alone", options);
    }
  out() << "rho was changed on the way: " << yes(has_changed_rho)
        << ", the interior point method called: " << yes(has_fallen_back) << std::endl;
}
