#include <stiction/contact/dual/hardly_resisted.h>
#include <stiction/contact/dual/rigid_balance.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/unbalanced_load.h>

#include <Eigen/Eigenvalues>

#include <map>
#include <utility>

namespace stiction
{
  namespace
  {
    // Of the squares of how nodes move against what is opposite, what presses or rubs:
    // with less, normals within half a degree of being across, a motion is hardly
    // resisted.
    constexpr double hardly = 1e-4;

    // A smaller coefficient of friction resists as little.
    constexpr double no_friction = 0.01;

    // Of all motions together: one that moves no contact node is not divided by nothing.
    constexpr double not_nothing = 1e-12;

    // The weights of nodes: smooth parts of boundaries count alike, so that a small stop
    // resists no less than the plane along which it stops.
    Eigen::VectorXd weights_of(const ContactSurface &surface)
    {
      std::map<std::pair<unsigned int, unsigned int>, double> areas;
      for (const ContactNode &node : surface.nodes())
        areas[{node.boundary, node.part}] += node.area;
      Eigen::VectorXd weights = surface.areas();
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        weights(i) /= areas.at({surface.nodes()[i].boundary, surface.nodes()[i].part});
      return weights;
    }

    // Along an axis of the frame of a node, 1 or 2.
    bool rubs(const ContactSurface &surface, const Eigen::Index node, const int axis)
    {
      const qp::SlipBound &bound = surface.slip_bound();
      return bound.constant()(node) != 0. ||
             (bound.is_coulomb() &&
              bound.coefficient()(node) * surface.nodes()[node].scale[axis - 1] >
                no_friction);
    }
  } // namespace

  Eigen::MatrixXd hardly_resisted_motions(const LinearElasticity &elasticity,
                                          const ContactSurface &surface)
  {
    const Eigen::Index n = elasticity.free_motions().n(), m = surface.n_nodes();
    if (n == 0 || m == 0 || surface.has_friction_of_state())
      return Eigen::MatrixXd::Zero(n, 0);
    const Eigen::MatrixXd G = rigid_balance(elasticity, surface).G.rightCols(n);
    const Eigen::MatrixXd resisted =
      qp::resisted_and_others(G, surface.slip_bound()).first;
    if (resisted.cols() == 0)
      return resisted;
    const Eigen::MatrixXd moved =
      weights_of(surface).replicate(3, 1).cwiseSqrt().asDiagonal() * (G * resisted);
    Eigen::MatrixXd felt = moved, all = moved.transpose() * moved;
    all.diagonal().array() += not_nothing * all.trace();
    for (Eigen::Index i = 0; i < m; ++i)
      for (const int axis : {1, 2})
        if (!rubs(surface, i, axis))
          felt.row(i + axis * m).setZero();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      felt.transpose() * felt, all);
    return resisted *
           eigen.eigenvectors().leftCols((eigen.eigenvalues().array() < hardly).count());
  }
} // namespace stiction
