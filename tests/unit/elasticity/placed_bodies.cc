// Bodies that are turned and moved keep the shape that they have alone, refined or
// not, in cells of either degree: shapes that know their curves, and cells of second
// order of a file, beside a brick. Volumes are compared; the body has to be elsewhere.

#include "physics/second_order_file.h"
#include "tests.h"

#include <stiction/elasticity/mesh/body.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <fstream>

using namespace stiction;

namespace
{
  struct Piece
  {
    double volume = 0.;
    dealii::Point<3> centre;
  };

  // Refined once more when they are placed.
  Piece first_piece(const std::string &sections, const unsigned int degree)
  {
    std::ofstream("bodies.prm")
      << sections << "subsection Geometry\n"
      << "set Element degree = " << degree << "\nset Global refinement = 1\nend\n"
      << "subsection Material\nset Young's modulus = 1\n"
      << "set Poisson ratio = 0\nend\n"
      << "subsection Friction\nset Law = frictionless\nend\n"
      << "subsection Boundary conditions\n"
      << "set Prescribed displacement = brick.left : 0; 0; 0\n"
      << "set Traction = brick.right : 1; 0; 0\n"
      << "set Contact boundary = brick.bottom\nend\n";
    Parameters parameters;
    parameters.read("bodies.prm", {});
    const Body body(parameters.geometry, MPI_COMM_WORLD);
    dealii::FEValues<3> values(
      body.mapping(), body.dof_handler().get_fe(), dealii::QGauss<3>(4),
      dealii::update_JxW_values | dealii::update_quadrature_points);
    Piece piece;
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      if (body.piece_of(cell) == 0)
        {
          values.reinit(cell);
          for (const unsigned int q : values.quadrature_point_indices())
            {
              piece.volume += values.JxW(q);
              piece.centre += values.JxW(q) * values.quadrature_point(q);
            }
        }
    piece.centre /= piece.volume;
    return piece;
  }

  // @param exact the volume without a mesh; @param allowed how far off it is, relative.
  void compare(const std::string &name, const std::string &shape, const double exact,
               const double allowed)
  {
    const std::string brick = "subsection Body brick\nset Type = brick\n"
                              "set Lengths = 1, 1, 1\nset Subdivisions = 1, 1, 1\n"
                              "set Translation = 20; 0; 0\nend\n";
    for (const unsigned int degree : {1, 2})
      for (const unsigned int refinement : {0, 1})
        {
          const std::string body = "subsection Body a\n" + shape +
                                   "set Refinement = " + std::to_string(refinement) +
                                   "\n";
          const Piece alone  = first_piece(body + "end\n" + brick, degree);
          const Piece placed = first_piece(
            body +
              "set Rotation = 1; 2; 3; 1; 1; 0; 40\nset Translation = 5; 6; 7\nend\n" +
              brick,
            degree);
          out() << name << ", degree " << degree << ", refined " << refinement
                << ": the same volume "
                << yes(std::abs(placed.volume / alone.volume - 1.) < 1e-12)
                << ", elsewhere " << yes(placed.centre.distance(alone.centre) > 1.);
          if (degree == 2 && refinement == 1)
            out() << ", that of the curved shape "
                  << yes(std::abs(placed.volume / exact - 1.) < allowed);
          out() << std::endl;
        }
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  constexpr double pi = dealii::numbers::PI;
  compare("cylinder", "set Type = cylinder\nset Radius = 1\nset Length = 2\n", 2. * pi,
          1e-2);
  compare("tube",
          "set Type = cylinder\nset Radius = 1\nset Inner radius = 0.5\n"
          "set Length = 2\n",
          1.5 * pi, 1e-3);
  compare("half ball", "set Type = half ball\nset Radius = 1\n", 2. / 3. * pi, 1e-2);
  dealii::Triangulation<3> shell;
  dealii::GridGenerator::hyper_shell(shell, dealii::Point<3>(), 1., 2., 6);
  SecondOrderFile(shell, {}, dealii::MappingQ<3>(2)).write("shell.msh", 27);
  compare("shell of second order", "set Type = file\nset Mesh file = shell.msh\n",
          28. / 3. * pi, 2e-1);
}
