// The product with K cell by cell is that with a matrix that is integrated and
// assembled in the plain way, for every kind of cell, number type and
// instruction set that this machine has.

#include <stiction/elasticity/kernels/cell_stiffness.h>

#include "unit/qp/qp_tests.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace stiction;
using namespace qp_tests;

namespace
{
  using Point = std::array<double, 3>;
  using Map   = std::function<Point(const Point &)>;

  struct Mesh
  {
    std::string name;
    std::vector<Point> nodes;
    std::vector<HexahedralCell> cells;
    std::size_t n_general, n_patched;
  };

  Point identity(const Point &x) { return x; }

  Point stretched(const Point &x)
  {
    return {{.5 * x[0], .7 * x[1] - 3., 1.25 * x[2] + 2.}};
  }

  Point sheared(const Point &x)
  {
    return {{x[0] + .3 * x[1] - .2 * x[2], .1 * x[0] + .8 * x[1] + .25 * x[2],
             -.15 * x[0] + .4 * x[1] + 1.1 * x[2]}};
  }

  Point far_away(const Point &x)
  {
    return {{1e3 + 1e-2 * x[0], 1e-2 * x[1] - 1e3, 1e-2 * x[2]}};
  }

  Point curved(const Point &x)
  {
    return {{x[0] + .06 * std::sin(2. * x[1] + x[2]),
             x[1] + .05 * std::cos(3. * x[0]) * x[2],
             x[2] - .07 * std::sin(x[0] * x[1] + .3)}};
  }

  // Cells of different length, so that each layer is a class.
  Point graded(const Point &x) { return {{x[0] + .002 * x[0] * x[0], x[1], x[2]}}; }

  enum class Order
  {
    lexicographic,
    families,
    random
  };

  // The image of the cells with edges 1 in (0, n_1) × (0, n_2) × (0, n_3).
  Mesh make_mesh(const std::string &name, const std::array<unsigned int, 3> &n,
                 const Order order, const Map &map, const std::size_t n_general,
                 const std::size_t n_patched)
  {
    Mesh mesh{name, {}, {}, n_general, n_patched};
    for (unsigned int k = 0; k <= n[2]; ++k)
      for (unsigned int j = 0; j <= n[1]; ++j)
        for (unsigned int i = 0; i <= n[0]; ++i)
          mesh.nodes.push_back(map({{1. * i, 1. * j, 1. * k}}));

    const auto add_cell = [&](unsigned int i, unsigned int j, unsigned int k) {
      HexahedralCell cell;
      for (unsigned int v = 0; v < 8; ++v)
        cell.nodes[v] =
          i + (v & 1) + (n[0] + 1) * (j + (v >> 1 & 1) + (n[1] + 1) * (k + (v >> 2 & 1)));
      cell.lame_lambda   = 1.3;
      cell.shear_modulus = .8;
      mesh.cells.push_back(cell);
    };
    const unsigned int step = order == Order::families ? 2 : 1;
    for (unsigned int k = 0; k < n[2]; k += step)
      for (unsigned int j = 0; j < n[1]; j += step)
        for (unsigned int i = 0; i < n[0]; i += step)
          for (unsigned int child = 0; child < step * step * step; ++child)
            add_cell(i + (child & 1), j + (child >> 1 & 1), k + (child >> 2 & 1));
    if (order == Order::random)
      {
        Random random(7);
        for (std::size_t i = mesh.cells.size(); i > 1; --i)
          std::swap(mesh.cells[i - 1], mesh.cells[random.integer(i)]);
      }
    return mesh;
  }

  void place_vertices(Mesh &mesh)
  {
    for (HexahedralCell &cell : mesh.cells)
      for (unsigned int v = 0; v < 8; ++v)
        cell.vertices[v] = mesh.nodes[cell.nodes[v]];
  }

  std::vector<Mesh> all_meshes()
  {
    std::vector<Mesh> meshes;
    const auto add = [&](const std::string &name, const std::array<unsigned int, 3> &n,
                         const Order order, const Map &map, const std::size_t n_general,
                         const std::size_t n_patched) {
      meshes.push_back(make_mesh(name, n, order, map, n_general, n_patched));
    };
    using O = Order;
    add("one cube", {{1, 1, 1}}, O::lexicographic, identity, 0, 0);
    add("a patch of boxes", {{2, 2, 2}}, O::lexicographic, stretched, 0, 8);
    add("a row of boxes", {{19, 1, 1}}, O::lexicographic, stretched, 0, 0);
    add("boxes", {{5, 7, 3}}, O::lexicographic, stretched, 0, 48);
    add("families of boxes", {{6, 4, 6}}, O::families, stretched, 0, 144);
    add("a row of parallelepipeds", {{1, 1, 21}}, O::random, sheared, 0, 0);
    add("parallelepipeds", {{3, 6, 7}}, O::lexicographic, sheared, 0, 72);
    add("families of parallelepipeds", {{4, 2, 6}}, O::families, sheared, 0, 48);
    add("small boxes far away", {{4, 4, 4}}, O::families, far_away, 0, 64);
    add("one hexahedron", {{1, 1, 1}}, O::lexicographic, curved, 1, 0);
    add("hexahedra", {{3, 5, 3}}, O::random, curved, 45, 0);
    add("more shapes than classes", {{70, 2, 1}}, O::lexicographic, graded, 12, 0);

    // moves one node, makes two materials
    add("two materials, eight hexahedra", {{6, 4, 4}}, O::families, sheared, 8, 80);
    Mesh &mixed = meshes.back();
    mixed.nodes[2 + 7 * (3 + 5 * 3)][1] += .2;
    for (std::size_t i = 48; i < mixed.cells.size(); ++i)
      mixed.cells[i].shear_modulus = 5.;

    for (Mesh &mesh : meshes)
      place_vertices(mesh);
    return meshes;
  }

  // The derivative of a shape function on the cell (−1, 1)³.
  Eigen::Vector3d shape_gradient(const unsigned int v, const Eigen::Vector3d &at)
  {
    Eigen::Vector3d sign, gradient;
    for (unsigned int d = 0; d < 3; ++d)
      sign(d) = v >> d & 1 ? 1. : -1.;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;

        gradient(d) = sign(d) * (1. + sign(e) * at(e)) * (1. + sign(f) * at(f)) / 8.;
      }
    return gradient;
  }

  // Strain, in Voigt's notation, as a matrix times displacements.
  MatrixXd stiffness(const Mesh &mesh)
  {
    const Index n = 3 * mesh.nodes.size();
    MatrixXd K    = MatrixXd::Zero(n, n);
    for (const HexahedralCell &cell : mesh.cells)
      {
        MatrixXd C = MatrixXd::Zero(6, 6);
        C.topLeftCorner(3, 3).setConstant(cell.lame_lambda);
        for (Index i = 0; i < 6; ++i)
          C(i, i) += (i < 3 ? 2. : 1.) * cell.shear_modulus;
        for (unsigned int q = 0; q < 8; ++q)
          {
            const Eigen::Vector3d point =
              Eigen::Vector3d(q & 1 ? 1. : -1., q & 2 ? 1. : -1., q & 4 ? 1. : -1.) /
              std::sqrt(3.);
            Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
            for (unsigned int v = 0; v < 8; ++v)
              J += Eigen::Vector3d(cell.vertices[v].data()) *
                   shape_gradient(v, point).transpose();
            MatrixXd B(6, 24);
            for (unsigned int v = 0; v < 8; ++v)
              {
                const Eigen::Vector3d g =
                  J.inverse().transpose() * shape_gradient(v, point);
                B.middleCols(3 * v, 3) << g(0), 0., 0., 0., g(1), 0., 0., 0., g(2), 0.,
                  g(2), g(1), g(2), 0., g(0), g(1), g(0), 0.;
              }
            const MatrixXd stress  = J.determinant() * (C * B);
            const MatrixXd of_cell = B.transpose() * stress;
            for (unsigned int v = 0; v < 8; ++v)
              for (unsigned int w = 0; w < 8; ++w)
                K.block(3 * cell.nodes[v], 3 * cell.nodes[w], 3, 3) +=
                  of_cell.block(3 * v, 3 * w, 3, 3);
          }
      }
    return K;
  }

  struct Errors
  {
    Largest product, symmetry, rigid_motion, diagonal;
    unsigned int outside = 0, miscounted = 0;
  };

  template<typename Number> using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

  // K times a vector, added to ones, in the middle of arrays of NaN.
  template<typename Number>
  VectorXd product(const CellStiffness<Number> &K, const VectorXd &u, Errors &errors)
  {
    const Index n = u.size(), margin = 16;
    const Number nan = std::numeric_limits<Number>::quiet_NaN();

    Vector<Number> src     = Vector<Number>::Constant(n + 2 * margin, nan);
    Vector<Number> dst     = src;
    src.segment(margin, n) = u.cast<Number>();
    dst.segment(margin, n).setOnes();
    K.add_product(dst.data() + margin, src.data() + margin);
    errors.outside += (dst.head(margin).array() == dst.head(margin).array()).any();
    errors.outside += (dst.tail(margin).array() == dst.tail(margin).array()).any();
    return dst.segment(margin, n).template cast<double>().array() - 1.;
  }

  template<typename Number>
  void examine(const Mesh &mesh, const MatrixXd &expected,
               const InstructionSet instruction_set, Errors &errors)
  {
    CellStiffness<Number> K(instruction_set);
    for (const HexahedralCell &cell : mesh.cells)
      K.add_cell(cell);
    K.finish();
    errors.miscounted += K.n_cells() != mesh.cells.size();
    errors.miscounted += K.n_general_cells() != mesh.n_general;
    errors.miscounted += K.n_patched_cells() != mesh.n_patched;

    Random random(3);
    const Index n     = expected.rows();
    const double norm = expected.cwiseAbs().rowwise().sum().maxCoeff();
    const VectorXd u  = random.vector(n).cast<Number>().template cast<double>();
    const VectorXd v  = random.vector(n).cast<Number>().template cast<double>();
    const VectorXd Ku = product(K, u, errors);
    errors.product.add((Ku - expected * u).cwiseAbs().maxCoeff() / norm);
    errors.symmetry.add(std::abs(v.dot(Ku) - u.dot(product(K, v, errors))) /
                        (norm * u.norm() * v.norm()));

    // small translations and rotations about a node
    for (unsigned int motion = 0; motion < 6; ++motion)
      {
        VectorXd rigid(n);
        for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
          {
            const Eigen::Vector3d axis = Eigen::Vector3d::Unit(motion % 3);
            const Eigen::Vector3d arm(
              Eigen::Map<const Eigen::Vector3d>(mesh.nodes[node].data()) -
              Eigen::Map<const Eigen::Vector3d>(mesh.nodes[0].data()));
            rigid.segment(3 * node, 3) =
              motion < 3 ? axis : Eigen::Vector3d(axis.cross(arm));
          }
        rigid /= rigid.cwiseAbs().maxCoeff();
        errors.rigid_motion.add(product(K, rigid, errors).cwiseAbs().maxCoeff() / norm);
      }

    Vector<Number> blocks = Vector<Number>::Zero(3 * n);
    K.add_diagonal_blocks(blocks.data());
    for (Index node = 0; node < n / 3; ++node)
      for (Index i = 0; i < 3; ++i)
        for (Index j = 0; j < 3; ++j)
          errors.diagonal.add(std::abs(blocks(9 * node + 3 * i + j) -
                                       expected(3 * node + i, 3 * node + j)) /
                              norm);
  }

  template<typename Number> void print_errors(const std::string &number)
  {
    const double bound = 50. * std::numeric_limits<Number>::epsilon();
    for (const Mesh &mesh : all_meshes())
      {
        const MatrixXd expected = stiffness(mesh);
        Errors errors;
        for (const InstructionSet instruction_set : all_instruction_sets)
          if (is_supported(instruction_set))
            examine<Number>(mesh, expected, instruction_set, errors);
        // what coordinates of 1e3 leave of edges of 1e-2
        const double inexact = mesh.nodes[0][0] == 1e3 ? 1e-9 : 0.;
        std::cout << number << ", " << mesh.name << std::endl;
        const auto say = [&](const std::string &what, const Largest &error) {
          print("  " + what, error.value() < bound + inexact);
          if (!(error.value() < bound + inexact))
            std::cout << "    error " << error.value() << std::endl;
        };
        say("product right", errors.product);
        say("symmetric", errors.symmetry);
        say("no force from rigid motions", errors.rigid_motion);
        say("diagonal blocks right", errors.diagonal);
        if (errors.outside + errors.miscounted > 0)
          std::cout << "  written outside: " << errors.outside
                    << ", cells miscounted: " << errors.miscounted << std::endl;
      }
  }

  template<typename Function> bool throws(const Function &function)
  {
    try
      {
        function();
      }
    catch (const std::invalid_argument &)
      {
        return true;
      }
    return false;
  }
} // namespace

int main()
{
  print_errors<double>("double");
  print_errors<float>("float");

  Mesh mesh = make_mesh("", {{1, 1, 1}}, Order::lexicographic, identity, 0, 0);
  place_vertices(mesh);
  print("No cells, no force", [] {
    const CellStiffness<double> K(std::vector<HexahedralCell>{});
    double force   = 1.;
    const double u = 1.;
    K.add_product(&force, &u);
    return force == 1. && K.n_cells() == 0;
  }());
  print("An instruction set that does not exist is refused", throws([&] {
          CellStiffness<double> K(mesh.cells, static_cast<InstructionSet>(9));
        }));
  print("A cell that is fine is taken",
        !throws([&] { CellStiffness<float> K(mesh.cells); }));
  print("A node with too large a number is refused", throws([&] {
          std::vector<HexahedralCell> cells = mesh.cells;
          cells[0].nodes[3]                 = 1500000000;
          CellStiffness<double> K(cells);
        }));
  print("An inverted cell is refused", throws([&] {
          std::vector<HexahedralCell> cells = mesh.cells;
          std::swap(cells[0].vertices[0], cells[0].vertices[1]);
          CellStiffness<double> K(cells);
        }));
  print("A flat cell is refused", throws([&] {
          std::vector<HexahedralCell> cells = mesh.cells;
          for (auto &vertex : cells[0].vertices)
            vertex[2] = 0.;
          CellStiffness<double> K(cells);
        }));
}
