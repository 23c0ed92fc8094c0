// Bodies that are not simple, with their assembled stiffness: hanging nodes,
// also on the contact face, and elements of degree 2. Element matrices; the
// patch tests; and the reference brick.

#include "patch_test.h"

#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Eigenvalues>

#include <array>

using namespace stiction;

namespace
{
  Eigen::MatrixXd to_eigen(const dealii::FullMatrix<double> &matrix)
  {
    Eigen::MatrixXd result(matrix.m(), matrix.n());
    for (unsigned int i = 0; i < matrix.m(); ++i)
      for (unsigned int j = 0; j < matrix.n(); ++j)
        result(i, j) = matrix(i, j);
    return result;
  }

  unsigned int rank(const Eigen::MatrixXd &K)
  {
    const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
    return static_cast<unsigned int>(
      (values.array() > 1e-10 * values(values.size() - 1)).count());
  }

  // A hexahedron without a right angle.
  void element_matrices()
  {
    dealii::Triangulation<3> triangulation;
    dealii::GridGenerator::hyper_cube(triangulation);
    const auto cell       = triangulation.begin_active();
    cell->vertex(7)       = dealii::Point<3>(1.3, 1.1, 0.9);
    cell->vertex(1)       = dealii::Point<3>(0.8, -0.1, 0.2);
    constexpr double lame = 1.5, G = 0.7;

    for (const unsigned int degree : {1, 2})
      {
        const dealii::FESystem<3> fe(dealii::FE_Q<3>(degree), 3);
        dealii::DoFHandler<3> dof_handler(triangulation);
        dof_handler.distribute_dofs(fe);
        const dealii::MappingQ1<3> mapping;
        ElementStiffness stiffness(mapping, fe);
        const auto begin  = dof_handler.begin_active();
        Material material = Material::isotropic(G * (3. * lame + 2. * G) / (lame + G),
                                                lame / (2. * (lame + G)));
        const Eigen::MatrixXd K = to_eigen(stiffness(begin, material));
        out() << "degree " << degree << ": all but six motions strain the cell "
              << yes(rank(K) == K.rows() - 6);
        if (degree == 1)
          {
            HexahedralCell hexahedron{};
            hexahedron.material = &material;
            hexahedron.unit     = 1.;
            for (unsigned int v = 0; v < 8; ++v)
              for (unsigned int d = 0; d < 3; ++d)
                hexahedron.vertices[v][d] = cell->vertex(v)[d];
            ElementStiffness trilinear;
            const Eigen::MatrixXd same = to_eigen(trilinear(hexahedron));
            hexahedron.lame_lambda     = lame;
            hexahedron.shear_modulus   = G;
            for (unsigned int v = 0; v < 8; ++v)
              hexahedron.nodes[v] = v;
            const CellStiffness<double> product({hexahedron});
            Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(24, -1., 2.).array().square(),
                            f = Eigen::VectorXd::Zero(24);
            product.add_product(f.data(), u.data());
            out() << ", same matrix from the vertices "
                  << yes((same - K).norm() < 1e-13 * K.norm())
                  << ", and of the product without one "
                  << yes((K * u - f).norm() < 1e-13 * f.norm());
          }

        // u linear in space: its strain is constant, and so its own projection
        Eigen::VectorXd u(K.rows());
        dealii::Tensor<2, 3> H;
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            H[a][b] = 1. + a - 0.3 * b * b;
        for (unsigned int i = 0; i < K.rows(); ++i)
          u(i) =
            (H *
             dealii::Tensor<1, 3>(mapping.transform_unit_to_real_cell(
               begin, fe.unit_support_point(i))))[fe.system_to_component_index(i).first];
        Material with_mean         = material;
        with_mean.mean_dilatation  = true;
        const Eigen::MatrixXd mean = to_eigen(stiffness(begin, with_mean));
        const auto unit            = dealii::unit_symmetric_tensor<3>();
        Material fluid             = with_mean;
        fluid.stiffness            = lame * dealii::outer_product(unit, unit);
        out() << "; mean dilatation: same force of a constant strain "
              << yes((mean * u - K * u).norm() < 1e-12 * (K * u).norm())
              << ", less stiff "
              << yes(
                   (K - mean).norm() > 1e-3 * K.norm() &&
                   Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K - mean).eigenvalues()(
                     0) > -1e-12 * K.norm())
              << (degree == 1 ? ", one volume a cell " : ", volumes linear in the cell ")
              << yes(rank(to_eigen(stiffness(begin, fluid))) == (degree == 1 ? 1 : 4))
              << std::endl;
      }
  }

  struct Mesh
  {
    std::string name;
    std::vector<std::string> settings;
    bool has_hanging_nodes;
  };

  void patches()
  {
    const std::string part = "Geometry/Contact refinement where=x < 0.7 && y < 0.7";
    const std::vector<Mesh> meshes = {
      {"trilinear, part of the contact face refined",
       {"Geometry/Subdivisions=2,2,2", "Geometry/Global refinement=1",
        "Geometry/Contact refinement=1", part},
       true},
      {"triquadratic",
       {"Geometry/Subdivisions=2,2,2", "Geometry/Global refinement=0",
        "Geometry/Element degree=2"},
       false},
      {"triquadratic, part of the contact face refined",
       {"Geometry/Subdivisions=2,2,2", "Geometry/Global refinement=0",
        "Geometry/Element degree=2", "Geometry/Contact refinement=1", part},
       true}};
    // one that solves for contact forces: the others see the same Q and h
    const std::vector<Method> methods = {
      {"gauss seidel", {"Contact solver/Method=gauss seidel"}},
      {"newton multigrid", {"Contact solver/Method=newton multigrid"}},
      {"newton by solves with amg",
       {"Contact solver/Method=newton", "Dual operator/Form=by solves",
        "Stiffness solver/Type=amg"}}};
    for (const Mesh &mesh : meshes)
      for (const Method &method : methods)
        for (const std::string law : {"given", "coulomb"})
          for (const std::string ending : {"stick", "slip"})
            {
              std::vector<std::string> settings = mesh.settings;
              settings.insert(settings.end(), method.settings.begin(),
                              method.settings.end());
              settings.emplace_back("Contact solver/Tolerance=1e-10");
              settings.emplace_back("Output/Write solution=false");
              const Patch patch =
                solve_patch(settings, law, ending, ending == "stick" ? 3e-5 : 2e-4, 30.);
              out() << mesh.name << ", " << method.name << ", " << law << ", " << ending
                    << ": certified " << yes(patch.certified) << ", all nodes "
                    << yes(patch.ends_as_expected) << ", displacement exact to 1e-8 "
                    << yes(patch.displacement_error < 1e-8)
                    << ", contact forces exact to 1e-8 " << yes(patch.force_error < 1e-8)
                    << ", energy balance " << yes(patch.energy_error < 1e-8)
                    << ", areas sum to that of the face "
                    << yes(patch.area_error < 1e-12 &&
                           patch.has_hanging_nodes == mesh.has_hanging_nodes)
                    << std::endl;
            }
  }

  std::array<double, 3> force_on_brick(const std::vector<std::string> &mesh)
  {
    std::vector<std::string> settings = {
      "Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
      "Contact solver/Method=newton", "Contact solver/Tolerance=1e-7",
      "Output/Write solution=false"};
    settings.insert(settings.end(), mesh.begin(), mesh.end());
    const Run run(shipped("brick.prm"), settings);
    return run.summary()["contact"]["force_on_body"].get<std::array<double, 3>>();
  }

  double distance(const std::array<double, 3> &a, const std::array<double, 3> &b)
  {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) /
           std::hypot(b[0], b[1], b[2]);
  }

  // The force on the reference brick, against a mesh of about four times as
  // many trilinear cells along each edge.
  void brick()
  {
    const auto fine =
      force_on_brick({"Geometry/Subdivisions=20,15,5", "Geometry/Global refinement=0"});
    const auto coarse =
      force_on_brick({"Geometry/Subdivisions=5,4,1", "Geometry/Global refinement=0"});
    const auto refined =
      force_on_brick({"Geometry/Subdivisions=5,4,1", "Geometry/Global refinement=0",
                      "Geometry/Contact refinement=2"});
    const auto quadratic =
      force_on_brick({"Geometry/Subdivisions=5,4,1", "Geometry/Global refinement=0",
                      "Geometry/Element degree=2"});
    out() << "reference brick: degree 2 nearer to a fine mesh than degree 1 "
          << yes(distance(quadratic, fine) < 0.5 * distance(coarse, fine))
          << ", within 0.5 per cent " << yes(distance(quadratic, fine) < 5e-3)
          << ", contact refinement nearer "
          << yes(distance(refined, fine) < 0.5 * distance(coarse, fine)) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  element_matrices();
  patches();
  brick();
}
