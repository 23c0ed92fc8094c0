// Friction does not know the axes, polygons do: a plate that slips as a whole
// is pushed in directions all around. With discs the friction force is as
// large in every direction and turns with it. With 2 and 4 squares its size
// is off by up to 8.2 and 2.0 per cent, its angle by up to 22.5 and 11.25
// degrees, as the corners of the polygon are.

#include "tests.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  constexpr double degree = dealii::numbers::PI / 180.;

  for (const std::string method : {"newton", "squares 2", "squares 4"})
    {
      double largest = 0., smallest = 1e300, worst_angle = 0.;
      unsigned int all_slip = 0, directions = 0;
      for (double angle = 0.1; angle < 90.; angle += 3.75)
        {
          ++directions;
          const double slip = 0.1; // far beyond the elastic shear
          const Run run(
            shipped("brick_given_friction.prm"),
            {"Geometry/Table 1 level=0", "Geometry/Lengths=1,1,0.5",
             "Geometry/Subdivisions=2,2,1", "Geometry/Global refinement=0",
             "Boundary conditions/Traction=",
             "Boundary conditions/Prescribed displacement=5 : " +
               exact(slip * std::cos(angle * degree)) + ";" +
               exact(slip * std::sin(angle * degree)) + "; -1e-4",
             "Contact solver/Method=" + method.substr(0, method.find(' ')),
             "Contact solver/Squares=" + (method == "newton" ? "2" : method.substr(8)),
             "Contact solver/Tolerance=1e-9"});
          const auto &lambda   = run.problem->state().lambda;
          const Eigen::Index m = run.problem->contact_surface().n_nodes();
          const double t1 = lambda.segment(m, m).sum(), t2 = lambda.tail(m).sum();
          const double bound = 1.5e7 * run.problem->contact_surface().areas().sum();
          largest            = std::max(largest, std::hypot(t1, t2) / bound);
          smallest           = std::min(smallest, std::hypot(t1, t2) / bound);
          worst_angle =
            std::max(worst_angle, std::abs(std::atan2(t2, t1) / degree - angle));
          all_slip +=
            run.summary()["contact"]["slip"] == run.problem->contact_surface().n_nodes()
              ? 1
              : 0;
        }
      out() << method << ": slips as a whole " << yes(all_slip == directions)
            << ", largest force " << std::round(1e3 * largest) / 1e3
            << ", smallest at least 1 " << yes(smallest > 0.999) << ", angle off by "
            << (worst_angle < 1e-6    ? "nothing"
                : worst_angle < 11.   ? "too little"
                : worst_angle < 11.25 ? "11 to 11.25 degrees"
                : worst_angle < 22.   ? "something else"
                : worst_angle < 22.5  ? "22 to 22.5 degrees"
                                      : "too much")
            << std::endl;
    }
}
