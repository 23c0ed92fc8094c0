// Grids of cubes behind a mesh: constants and linear functions of the place are
// interpolated exactly by every grid to the one before, also where cells differ much in
// size; the arms of a fork share functions below its handle alone, though they are
// closer to each other than a cube is wide; the last grid is small.

#include "tests.h"

#include <stiction/elasticity/multigrid/background_grids.h>

#include <Eigen/QR>

#include <cmath>
#include <random>
#include <set>

using namespace stiction;

namespace
{
  using Interpolation = Eigen::SparseMatrix<float, Eigen::RowMajor>;

  struct Mesh
  {
    std::vector<std::array<double, 3>> nodes;
    std::vector<std::array<unsigned int, 8>> cells;

    // n[0] × n[1] × n[2] cells at the places that place(i, j, k) says.
    template<typename Place>
    void add_block(const std::array<unsigned int, 3> &n, const Place &place)
    {
      const auto first = static_cast<unsigned int>(nodes.size());
      for (unsigned int k = 0; k <= n[2]; ++k)
        for (unsigned int j = 0; j <= n[1]; ++j)
          for (unsigned int i = 0; i <= n[0]; ++i)
            nodes.push_back(place(i, j, k));
      for (unsigned int k = 0; k < n[2]; ++k)
        for (unsigned int j = 0; j < n[1]; ++j)
          for (unsigned int i = 0; i < n[0]; ++i)
            {
              cells.emplace_back();
              for (unsigned int v = 0; v < 8; ++v)
                cells.back()[v] =
                  first + (i + (v & 1)) +
                  (n[0] + 1) * ((j + (v >> 1 & 1)) + (n[1] + 1) * (k + (v >> 2)));
            }
    }
  };

  // How far the functions of the last grid are from reproducing 1, x, y and z at the
  // nodes, relative to the largest.
  double error_of_linears(const Mesh &mesh, const std::vector<Interpolation> &grids)
  {
    Eigen::MatrixXd functions = Eigen::MatrixXd(grids.back().cast<double>());
    for (std::size_t g = grids.size() - 1; g > 0; --g)
      functions = grids[g - 1].cast<double>() * functions;
    Eigen::MatrixXd linears(mesh.nodes.size(), 4);
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      linears.row(i) << 1., mesh.nodes[i][0], mesh.nodes[i][1], mesh.nodes[i][2];
    const Eigen::MatrixXd nearest =
      functions * functions.completeOrthogonalDecomposition().solve(linears);
    return (nearest - linears).cwiseAbs().maxCoeff() / linears.cwiseAbs().maxCoeff();
  }

  double error_of_sums(const std::vector<Interpolation> &grids)
  {
    double error = 0.;
    for (const Interpolation &grid : grids)
      error = std::max(
        error,
        static_cast<double>(
          ((grid * Eigen::VectorXf::Ones(grid.cols())).array() - 1.f).abs().maxCoeff()));
    return error;
  }

  void check(const std::string &name, const Mesh &mesh)
  {
    const auto grids = background_grids(mesh.nodes, mesh.cells);
    out() << name << ": nodes " << mesh.nodes.size() << ", vertices";
    for (const Interpolation &grid : grids)
      out() << ' ' << grid.cols();
    out() << ", sums of weights are 1 " << yes(error_of_sums(grids) < 1e-6)
          << ", linear functions exact " << yes(error_of_linears(mesh, grids) < 1e-5)
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.2, 0.2);
  Mesh perturbed;
  perturbed.add_block({{16, 12, 6}}, [&](auto i, auto j, auto k) {
    return std::array<double, 3>{
      {i + noise(random), j + noise(random), k + noise(random)}};
  });
  check("perturbed", perturbed);

  Mesh graded; // edges from 1 to 20
  graded.add_block({{24, 8, 8}}, [](auto i, auto j, auto k) {
    const double x = 20. * (std::exp(0.125 * i) - 1.), size = 2.5 * std::exp(0.125 * i);
    return std::array<double, 3>{{0.4 * x, 0.4 * size * j, 0.4 * size * k}};
  });
  check("graded", graded);

  // a handle of 4 × 4 × 4 cells and two arms of 12 × 4 × 4, 0.6 of a cube apart
  Mesh fork;
  const unsigned int length = 12;
  for (const double low : {0., 5.2})
    fork.add_block({{length, 4, 4}}, [&](auto i, auto j, auto k) {
      return std::array<double, 3>{{double(i), low + j, double(k)}};
    });
  const std::size_t n_of_arms = fork.nodes.size();
  fork.add_block({{4, 9, 4}}, [](auto i, auto j, auto k) {
    return std::array<double, 3>{
      {-4. + i, j < 5 ? double(j) : 5.2 + (j - 5.), double(k)}};
  });
  // the nodes at x = 0 are the same
  for (auto &cell : fork.cells)
    for (unsigned int &node : cell)
      if (node >= n_of_arms)
        for (unsigned int other = 0; other < n_of_arms; ++other)
          if (fork.nodes[other] == fork.nodes[node])
            {
              node = other;
              break;
            }
  check("fork", fork);
  const auto first = background_grids(fork.nodes, fork.cells).front();
  std::array<std::set<Eigen::Index>, 2> functions;
  for (unsigned int node = 0; node < n_of_arms; ++node)
    if (fork.nodes[node][0] > 4.)
      for (Interpolation::InnerIterator entry(first, node); entry; ++entry)
        functions[fork.nodes[node][1] > 5. ? 1 : 0].insert(entry.col());
  std::size_t n_shared = 0;
  for (const auto function : functions[0])
    n_shared += functions[1].count(function);
  out() << "functions of an arm " << functions[0].size() << ", shared by both "
        << n_shared << std::endl;
}
