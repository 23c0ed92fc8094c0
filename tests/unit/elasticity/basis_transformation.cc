// Displacements that count from other nodes: T⁻¹T = 1, Tᵀ does the same work, K̂ = TᵀKT
// is symmetric, slaves that are masters of others are followed in any order, circles are
// refused, a coarse slave sees what it sees on the finer level, and K̂ with any supports
// is factorised exactly, of elements of degree 2 and with hanging nodes as well, and so
// is K̂ within the masters on which slaves weigh. Small ones among many weights can be
// left out, the sum staying what it is.

#include "tests.h"

#include <stiction/elasticity/levels/basis_transformation.h>
#include <stiction/elasticity/levels/dof_subset_hierarchy.h>
#include <stiction/elasticity/levels/master_block.h>
#include <stiction/elasticity/levels/mesh_hierarchy.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/multigrid/coarse_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <cmath>

using namespace stiction;

namespace
{
  using Dofs = BasisTransformation::Dofs;

  // The first unknowns of the nodes of a plane, in the order of their places.
  Dofs nodes_at(const Body &body, const unsigned int axis, const double value)
  {
    using Placed = std::pair<std::array<double, 3>, dealii::types::global_dof_index>;
    std::vector<Placed> mine, all;
    for (const Body::Node &node : body.locally_owned_nodes())
      if (std::abs(node.position[axis] - value) < 1e-10 && !body.is_hanging(node.dofs[0]))
        mine.push_back(
          {{{node.position[0], node.position[1], node.position[2]}}, node.dofs[0]});
    for (const auto &theirs : dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, mine))
      all.insert(all.end(), theirs.begin(), theirs.end());
    std::sort(all.begin(), all.end());
    Dofs dofs;
    for (const Placed &node : all)
      dofs.push_back(node.second);
    return dofs;
  }

  // A slave follows two nodes, turned a little.
  BasisTransformation::Matrix relation(const std::size_t n_slaves,
                                       const std::size_t n_masters)
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < n_slaves; ++i)
      for (const std::size_t j : {i % n_masters, (5 * i + 3) % n_masters})
        for (unsigned int a = 0; a < 3; ++a)
          for (unsigned int b = 0; b < 3; ++b)
            entries.emplace_back(3 * i + a, 3 * j + b,
                                 (a == b ? 0.5 : 0.1 * std::sin(double(i + a + 2 * b))));
    BasisTransformation::Matrix N(3 * static_cast<Eigen::Index>(n_slaves),
                                  3 * static_cast<Eigen::Index>(n_masters));
    N.setFromTriplets(entries.begin(), entries.end());
    return N;
  }

  // The same numbers on any number of ranks.
  LA::Vector filled(const MeshLevel &level, const double frequency)
  {
    LA::Vector v         = level.zero_vector<double>();
    const auto positions = level.node_positions();
    for (std::size_t i = 0; i < positions.size(); ++i)
      for (unsigned int c = 0; c < 3; ++c)
        v.local_element(3 * i + c) = std::sin(
          frequency * (positions[i][0] + 2. * positions[i][1] + 3. * positions[i][2]) +
          c);
    return v;
  }

  double distance(const LA::Vector &a, const LA::Vector &b)
  {
    LA::Vector difference = a;
    difference -= b;
    return difference.l2_norm() / b.l2_norm();
  }

  // One at prescribed unknowns.
  LA::Vector prescribed(const LinearElasticity &elasticity)
  {
    LA::Vector fixed = elasticity.zero_vector();
    for (const auto dof : fixed.locally_owned_elements())
      if (elasticity.constraints().is_constrained(dof))
        fixed(dof) = 1.;
    return fixed;
  }

  // P K̂ P x = b for slaves held and released: all three take the same solver.
  void check_factors(const std::string &name, const BasisTransformation &T,
                     const LinearElasticity &elasticity)
  {
    const LA::Vector fixed = prescribed(elasticity);
    NodalSupports supports(T.slaves().size());
    CoarseSolver solver(elasticity.materials(), elasticity.mesh(), fixed, T.slaves(), T,
                        supports, true);
    bool is_exact = solver.is_direct();
    for (const std::size_t stride : {1, 2, 5})
      {
        NodalSupports held = supports;
        for (std::size_t i = 0; i < held.size(); i += stride)
          {
            held[i].projection(0, 0) = 0.;
            held[i].spring(1, 1)     = 1e9;
          }
        const auto project = [&](LA::Vector &v) {
          for (const auto dof : v.locally_owned_elements())
            if (fixed(dof) != 0. || elasticity.body().is_hanging(dof))
              v(dof) = 0.;
          for (std::size_t i = 0; i < held.size(); i += stride)
            if (v.in_local_range(T.slaves()[i]))
              v(T.slaves()[i]) = 0.;
        };
        LA::Vector x = filled(elasticity.mesh(), 1.), b = x, found = x;
        project(x);
        T.vmult(elasticity.stiffness(), b, x);
        for (std::size_t i = 0; i < held.size(); i += stride)
          if (const auto dof = T.slaves()[i] + 1; b.in_local_range(dof))
            b(dof) += 1e9 * x(dof);
        project(b);
        solver.set_supports(held);
        solver.vmult(found, b);
        project(found);
        is_exact = is_exact && distance(found, x) < 1e-9;
      }
    out() << name << ": factorised exactly " << yes(is_exact) << std::endl;
  }

  // K̂ x = r where masters are in the block, which no slaves and no prescribed unknowns
  // are. Slaves are relative along x and y, with springs there, which the block leaves
  // out in chains.
  void check_masters(const std::string &name, BasisTransformation T, const double spring,
                     const LinearElasticity &elasticity)
  {
    const MeshLevel &mesh  = elasticity.mesh();
    const LA::Vector fixed = prescribed(elasticity), r = filled(mesh, 2.3);
    MasterBlock block(mesh, elasticity.materials(), 1., fixed, T);
    const std::size_t n = T.slaves().size();
    T.set_relative_directions(
      std::vector<Eigen::Matrix3d>(n, Eigen::Vector3d::UnitZ().asDiagonal()),
      std::vector<Eigen::Matrix3d>(
        n, Eigen::Vector3d(spring, 2. * spring, 0.).asDiagonal()));
    block.set_basis(T);
    auto x = mesh.zero_vector<float>(), right = x;
    right.copy_locally_owned_data_from(r);
    block.add_correction(x, right);

    LA::Vector u = elasticity.zero_vector(), Ku = u;
    u.copy_locally_owned_data_from(x);
    T.vmult(elasticity.stiffness(), Ku, u);
    double deviation = 0., n_solved = 0.;
    bool is_left_out = true;
    for (const auto dof : u.locally_owned_elements())
      if (u(dof) != 0.)
        {
          ++n_solved;
          deviation = std::max(deviation, std::abs(Ku(dof) - r(dof)));
          is_left_out =
            is_left_out && fixed(dof) == 0. &&
            std::count(T.slaves().begin(), T.slaves().end(), dof - dof % 3) == 0;
        }
    out() << name << ": solves for "
          << dealii::Utilities::MPI::sum(n_solved, MPI_COMM_WORLD)
          << " unknowns of masters "
          << yes(dealii::Utilities::MPI::max(deviation, MPI_COMM_WORLD) < 1e-5)
          << ", none prescribed or of a slave "
          << yes(dealii::Utilities::MPI::logical_or(!is_left_out, MPI_COMM_WORLD) ==
                 false)
          << std::endl;
  }

  void check(const std::string &name, const BasisTransformation &T,
             const LinearElasticity &elasticity)
  {
    const MeshLevel &mesh = elasticity.mesh();
    const LA::Vector u = filled(mesh, 1.), r = filled(mesh, 2.3);
    LA::Vector Tu = u, back, Tr = r;
    T.to_absolute(Tu);
    back = Tu;
    T.to_relative(back);
    T.forces_to_relative(Tr);
    const bool same_work = std::abs((Tu * r) / (u * Tr) - 1.) < 1e-12;
    LA::Vector r_back    = Tr;
    T.forces_to_absolute(r_back);

    LA::Vector Ku = u, K_hat_u = u, K_hat_r = u;
    elasticity.stiffness().vmult(Ku, Tu);
    T.forces_to_relative(Ku);
    T.vmult(elasticity.stiffness(), K_hat_u, u);
    T.vmult(elasticity.stiffness(), K_hat_r, r);
    out() << name << ": moves slaves " << yes(distance(Tu, u) > 0.01) << ", inverse "
          << yes(distance(back, u) < 1e-13) << ", forces do the same work "
          << yes(same_work) << ", and back " << yes(distance(r_back, r) < 1e-13)
          << ", stiffness " << yes(distance(K_hat_u, Ku) < 1e-13) << ", symmetric "
          << yes(std::abs((K_hat_u * r) / (u * K_hat_r) - 1.) < 1e-10) << std::endl;
  }

  // Weights that decay over many masters, beside a slave with few and a small one.
  void check_small_weights(const Dofs &slaves, const Dofs &masters)
  {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](const std::size_t i, const std::size_t j, const double weight) {
      for (unsigned int a = 0; a < 3; ++a)
        entries.emplace_back(3 * i + a, 3 * j + a, weight);
    };
    for (std::size_t j = 0; j < masters.size(); ++j)
      add(0, j, std::pow(0.5, double(j)));
    add(1, 0, 1.);
    add(1, 1, 1e-6);
    for (const std::size_t j : {0, 20}) // as of turns
      entries.emplace_back(0, 3 * j + 1, std::pow(0.5, double(j)));
    BasisTransformation::Matrix N(6, 3 * static_cast<Eigen::Index>(masters.size()));
    N.setFromTriplets(entries.begin(), entries.end());
    const BasisTransformation T({slaves[0], slaves[1]}, masters, N);
    const auto large           = T.large_added(1e-3);
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(N.cols());
    out() << "of " << masters.size() << " weights " << large.row(2).nonZeros()
          << " are large, of 2 weights " << large.row(3).nonZeros()
          << ", with the same sums " << yes((large * ones).isApprox(N * ones, 1e-14))
          << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Parameters parameters;
  parameters.read(shipped("brick.prm"),
                  {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                   "Geometry/Subdivisions=3,2,1", "Geometry/Global refinement=2"});
  const Body body(parameters.geometry, MPI_COMM_WORLD);
  const LinearElasticity elasticity(body, parameters.of_body());
  const Dofs bottom = nodes_at(body, 2, 0.), top = nodes_at(body, 2, 1.);

  BasisTransformation T(bottom, top, relation(bottom.size(), top.size()));
  check("T", T, elasticity);

  // the bottom follows the top, and a part of the top a part of the right end
  Dofs right = nodes_at(body, 0, 4.), slaves = bottom, masters = top;
  right.erase(std::remove_if(right.begin(), right.end(),
                             [&](const auto dof) {
                               return std::count(top.begin(), top.end(), dof) +
                                        std::count(bottom.begin(), bottom.end(), dof) >
                                      0;
                             }),
              right.end());
  slaves.push_back(top.front());
  masters.insert(masters.end(), right.begin(), right.end());
  auto N = relation(slaves.size(), masters.size());
  N.prune([&](const Eigen::Index row, const Eigen::Index column, double) {
    const bool of_bottom = row < 3 * static_cast<Eigen::Index>(bottom.size());
    const bool to_top    = column < 3 * static_cast<Eigen::Index>(top.size());
    return of_bottom ? to_top : !to_top;
  });
  for (unsigned int c = 0; c < 3; ++c)
    N.coeffRef(N.rows() - 3 + c, N.cols() - 3 + c) = 0.7;
  const BasisTransformation chain(slaves, masters, N);
  check("a chain", chain, elasticity);
  check_factors("T", T, elasticity);
  check_factors("a chain", chain, elasticity);
  check_masters("T", {bottom, top, 3. * relation(bottom.size(), top.size())}, 1e11,
                elasticity);
  check_masters("a chain", {slaves, masters, 3. * N}, 0., elasticity);
  for (const std::string more : {"Element degree=2", "Contact refinement=1"})
    {
      parameters.read(shipped("brick.prm"),
                      {"Geometry/Table 1 level=0", "Geometry/Lengths=4,3,1",
                       "Geometry/Subdivisions=3,2,1", "Geometry/Global refinement=1",
                       "Geometry/" + more});
      const Body other_body(parameters.geometry, MPI_COMM_WORLD);
      const LinearElasticity other(other_body, parameters.of_body());
      const Dofs first   = nodes_at(other_body, 2, 0.),
                 second  = nodes_at(other_body, 2, 1.);
      const auto weights = relation(first.size(), second.size());
      check_factors(more, {first, second, weights}, other);
      check_masters(more, {first, second, 3. * weights}, 1e11, other);
    }

  check_small_weights(bottom, top);

  try
    {
      BasisTransformation(bottom, bottom, relation(bottom.size(), bottom.size()));
      out() << "a circle is taken" << std::endl;
    }
  catch (const CircleOfSlaves &)
    {
      out() << "a circle is refused" << std::endl;
    }

  // R leaves the slaves where they are in other directions
  std::vector<Eigen::Matrix3d> R(bottom.size(), Eigen::Vector3d::UnitZ().asDiagonal()),
    none(bottom.size(), Eigen::Matrix3d::Zero());
  BasisTransformation normal = T;
  normal.set_relative_directions(R, none);
  check("along z", normal, elasticity);
  LA::Vector u = filled(elasticity.mesh(), 1.), Tu = u;
  normal.to_absolute(Tu);
  bool stays = true, moves = false;
  for (const auto dof : bottom)
    if (u.in_local_range(dof))
      {
        stays = stays && Tu(dof) == u(dof) && Tu(dof + 1) == u(dof + 1);
        moves = moves || Tu(dof + 2) != u(dof + 2);
      }
  stays = dealii::Utilities::MPI::min(stays ? 1 : 0, MPI_COMM_WORLD) == 1;
  moves = dealii::Utilities::MPI::max(moves ? 1 : 0, MPI_COMM_WORLD) == 1;
  out() << "along z: moves along z " << yes(moves) << ", not along x and y " << yes(stays)
        << std::endl;

  const MeshHierarchy hierarchy(body, elasticity.mesh());
  const DofSubsetHierarchy nodes(hierarchy, bottom);
  const unsigned int l = hierarchy.n_levels() - 1;
  const BasisTransformation coarse =
    T.coarser(hierarchy.transfer(l), hierarchy.level(l), hierarchy.level(l - 1),
              nodes.on_finer_level(l - 1), nodes.first_dofs(l - 1));
  const LA::Vector u_coarse = filled(hierarchy.level(l - 1), 1.);
  LA::Vector absolute = u_coarse, fine = hierarchy.level(l).zero_vector<double>(),
             back = u_coarse;
  coarse.to_absolute(absolute);
  hierarchy.transfer(l).prolongate(fine, absolute);
  T.to_relative(fine);
  hierarchy.transfer(l).inject(back, fine);
  out() << "prolonged and back: the same " << yes(distance(back, u_coarse) < 1e-13)
        << ", not without T " << yes(distance(absolute, u_coarse) > 0.01) << std::endl;
}
