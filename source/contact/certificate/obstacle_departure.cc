#include <stiction/contact/certificate/obstacle_departure.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the largest: nodes on a line tell nothing of turns about it.
    constexpr double no_arm = 1e-6;

    // The rotation about the centre of the forces that fits displacements best, in the
    // sense of least squares weighted with the forces.
    //
    // @param places, displacements a row for each node.
    Eigen::Vector3d fitted_rotation(const Eigen::VectorXd &forces,
                                    Eigen::MatrixX3d places,
                                    Eigen::MatrixX3d displacements)
    {
      const double all = forces.sum();
      places.rowwise() -= (forces.transpose() * places / all).eval();
      displacements.rowwise() -= (forces.transpose() * displacements / all).eval();
      Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
      Eigen::Vector3d moment  = Eigen::Vector3d::Zero();
      for (Eigen::Index i = 0; i < forces.size(); ++i)
        {
          const Eigen::Vector3d arm = places.row(i), u = displacements.row(i);
          inertia += forces(i) * (arm.squaredNorm() * Eigen::Matrix3d::Identity() -
                                  arm * arm.transpose());
          moment += forces(i) * arm.cross(u);
        }
      Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> decomposition;
      decomposition.setThreshold(no_arm);
      return decomposition.compute(inertia).solve(moment);
    }
  } // namespace

  ObstacleDeparture obstacle_departure(const ContactSurface &surface,
                                       const ContactBoundary &boundary,
                                       const State &state)
  {
    ObstacleDeparture departure;
    if (boundary.obstacle() == nullptr)
      return departure;
    const Eigen::VectorXd moved = surface.relative_displacement(state),
                          u     = surface.B().dofs().restriction(state.u);
    std::vector<Eigen::Index> pressed;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      if (state.lambda(i) > 0. &&
          surface.boundary_of(surface.nodes()[i]).id() == boundary.id())
        pressed.push_back(i);
    if (pressed.empty())
      return departure;
    const Eigen::VectorXd forces = state.lambda(pressed);
    Eigen::MatrixX3d places(forces.size(), 3), displacements(forces.size(), 3);
    for (Eigen::Index k = 0; k < forces.size(); ++k)
      for (unsigned int c = 0; c < 3; ++c)
        {
          places(k, c)        = surface.nodes()[pressed[k]].position[c];
          displacements(k, c) = u(pressed[k] + c * surface.n_nodes());
        }
    const Eigen::Vector3d rotation = fitted_rotation(forces, places, displacements);
    for (const Eigen::Index i : pressed)
      {
        const ContactNode &node = surface.nodes()[i];
        const double force      = state.lambda(i);
        ContactNode undeformed = node, there = node;
        undeformed.moved = Tensor<1, 3>();
        boundary.place_if_possible(undeformed);
        there.moved = -to_tensor(at_node(moved, i));
        boundary.place_if_possible(there);
        const double distance = there.gap - there.normal * there.moved,
                     linear   = node.gap - node.normal * there.moved;
        departure.distance += force * std::abs(distance - linear);
        const Tensor<1, 3> turned =
          cross_product_3d(to_tensor(rotation), undeformed.normal);
        departure.turn += force * (there.normal - node.normal).norm();
        departure.with_body +=
          force * ((there.normal - undeformed.normal).norm() -
                   (there.normal - undeformed.normal - turned).norm());
        departure.coefficient = std::max(departure.coefficient, node.coefficient);
        departure.slip += force * (there.moved - node.moved).norm();
        departure.spacing += force * std::sqrt(node.area);
      }
    const double all = forces.sum();
    return {departure.distance / all,
            departure.turn / all,
            departure.slip / all,
            departure.spacing / all,
            std::max(departure.with_body / all, 0.),
            departure.coefficient};
  }
} // namespace stiction
