// The GRECO plate (Code_Aster SSNV128) against numbers that were recomputed
// with plane elements of the same size by another program: displacements along
// the contact line, zones of open, slipping and sticking nodes, forces.

#include "tests.h"

#include <algorithm>
#include <cmath>

using namespace stiction;

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Run run(shipped("greco_plate.prm"), {});
  const ContactSurface &surface = run.problem->contact_surface();
  const Eigen::Index m          = surface.n_nodes();
  const double h = 0.04 / 128, thickness = h;

  out() << "certified: " << yes(run.converged) << '\n';

  // u_x along the contact line, in 1e-5 m
  const std::pair<double, double> points[] = {{0., 2.8602},
                                              {1.25e-3, 2.7225},
                                              {5e-3, 2.2867},
                                              {7.5e-3, 1.9807},
                                              {11.25e-3, 1.5413}};
  const Eigen::VectorXd u = surface.B().dofs().restriction(run.problem->state().u);
  for (const auto &point : points)
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const auto &x = surface.nodes()[i].position;
        if (std::abs(x[0] - point.first) < 1e-9 && x[1] < 1e-9)
          out() << "x = " << 1e3 * point.first << " mm: within 0.5 %: "
                << yes(std::abs(1e5 * u(i) - point.second) < 0.005 * point.second)
                << '\n';
      }

  // open nodes end, slipping nodes end
  const auto statuses = run.problem->node_statuses();
  double open = 0., slip = 0.;
  for (Eigen::Index i = 0; i < m; ++i)
    {
      const double x = surface.nodes()[i].position[0];
      if (statuses[i].normal == NormalStatus::open)
        open = std::max(open, x);
      if (statuses[i].tangential == TangentialStatus::slip)
        slip = std::max(slip, x);
    }
  out() << "open to 3.3 mm: " << yes(std::abs(open - 3.3e-3) < 1.01 * h) << '\n'
        << "slip to 30 mm: " << yes(std::abs(slip - 30e-3) < 1.01 * h) << '\n';

  const double pull = run.summary()["contact"]["force_on_body"][0].get<double>();
  out() << "tangential force on the plate within 0.5 %: "
        << yes(std::abs(pull / thickness + 1.4054e6) < 0.005 * 1.4054e6) << '\n';
}
