#pragma once

#include <stiction/elasticity/stiffness/nodal_constraint.h>

#include <Eigen/Core>

#include <vector>

namespace stiction
{
  namespace qp
  {
    class SlipBound;
  }

  /// The contact and friction conditions linearised in displacements
  /// (P. Alart and A. Curnier, A mixed formulation for frictional contact
  /// problems prone to Newton like solution methods, 1991), node by node in the
  /// frame (n, t1, t2).
  ///
  /// With R = f − Ku, the force on the obstacle, and w = Bu − (d; 0; 0), a node
  /// is sorted by a = λ + ρw. The step is w⁺ = w + shift + δ, δ in the range of
  /// the projection P, and R⁺ has to satisfy W R⁺ = S w⁺ + c:
  ///
  /// - open (a_ν ≤ 0): R_ν = 0; closed: w_ν = 0
  /// - stick (‖a_t‖ ≤ b): w_t = 0, the slip bound b being g or F max(a_ν, 0)
  /// - slip along t = a_t/‖a_t‖: across t a spring, R_t = σ w_t with
  ///   σ = κρ/(1 − κ), κ = b/‖a_t‖; along t the bound itself, R_t·t = g or
  ///   R_t·t = F R_ν, the unsymmetric row.
  struct PrimalActiveSet
  {
    /// What is linear at a node.
    struct Node
    {
      /// P
      Eigen::Matrix3d projection = Eigen::Matrix3d::Identity();
      /// W: P but for the unsymmetric row
      Eigen::Matrix3d test = Eigen::Matrix3d::Identity();
      /// S, N/m
      Eigen::Matrix3d spring = Eigen::Matrix3d::Zero();
      /// c, N
      Eigen::Vector3d load = Eigen::Vector3d::Zero();
      /// m
      Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    };

    /// Nodes that nothing holds.
    explicit PrimalActiveSet(Eigen::Index n_nodes)
      : nodes(n_nodes)
    {
    }

    /// @param lambda, w length 3m by blocks; N, m.
    /// @param rho length m, > 0, N/m. The solution does not depend on it.
    PrimalActiveSet(const Eigen::VectorXd &lambda, const Eigen::VectorXd &w,
                    const Eigen::VectorXd &rho, const qp::SlipBound &slip_bound);

    /// How motions are resisted by nodes that are held or have springs.
    struct Resistance
    {
      Eigen::VectorXd part;    ///< of that of the foundation, ascending
      Eigen::MatrixXd motions; ///< in those that were given, 1 in the foundation
    };

    /// @param motions of the nodes, 3m × n. @param foundation N/m, length m.
    Resistance resistance(const Eigen::MatrixXd &motions,
                          const Eigen::VectorXd &foundation) const;

    /// Where nodes that are held or have springs leave one of these motions free, all
    /// get a soft spring that draws them to where they are, so that the step is bounded.
    void tether(const Eigen::MatrixXd &motions, const Eigen::VectorXd &foundation,
                const Eigen::VectorXd &w);

    std::vector<Node> nodes;
  };
} // namespace stiction
