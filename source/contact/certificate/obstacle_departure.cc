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
    // @param nodes of which forces and displacements count.
    Eigen::Vector3d fitted_rotation(const ContactSurface &surface,
                                    const std::vector<Eigen::Index> &nodes,
                                    const Eigen::VectorXd &forces,
                                    const Eigen::VectorXd &u)
    {
      Eigen::MatrixX3d places(forces.size(), 3), displacements(forces.size(), 3);
      for (Eigen::Index k = 0; k < forces.size(); ++k)
        {
          displacements.row(k) = at_node(u, nodes[k]);
          for (unsigned int c = 0; c < 3; ++c)
            places(k, c) = surface.nodes()[nodes[k]].position[c];
        }
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
    const Eigen::VectorXd moved = surface.relative_displacement(state);
    std::vector<Eigen::Index> pressed;
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      if (state.lambda(i) > 0. &&
          surface.boundary_of(surface.nodes()[i]).id() == boundary.id())
        pressed.push_back(i);
    if (pressed.empty())
      return departure;
    const Eigen::VectorXd forces = state.lambda(pressed);
    const Tensor<1, 3> rotation  = to_tensor(
       fitted_rotation(surface, pressed, forces, surface.B().dofs().restriction(state.u)));
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
        const Tensor<1, 3> turned = cross_product_3d(rotation, undeformed.normal);
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
