#include <stiction/contact/certificate/certificate.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/output/history/step_result.h>
#include <stiction/qp/operators/nodal_blocks.h>

namespace stiction
{
  namespace
  {
    void add_node(BoundaryStep &boundary, const ContactNode &node,
                  const NodeStatus status, const Eigen::Vector3d &lambda,
                  const Eigen::Vector3d &gradient)
    {
      const dealii::Tensor<1, 3> force = -to_tensor(node.force_to_cartesian(lambda));
      boundary.force += force;
      boundary.moment += cross_product_3d(node.center, force);
      boundary.torque -=
        node.arm * to_tensor(node.force_to_cartesian({0., lambda(1), lambda(2)}));
      boundary.normal_force += lambda(0);
      boundary.center += lambda(0) * node.center;
      boundary.open_area += status.normal == NormalStatus::open ? node.area : 0.;
      boundary.slip_area += status.tangential == TangentialStatus::slip ? node.area : 0.;
      boundary.stick_area +=
        status.tangential == TangentialStatus::stick ? node.area : 0.;
      // the gradient is minus the slip
      boundary.dissipated -= lambda.tail<2>().dot(gradient.tail<2>());
    }
  } // namespace

  dealii::Tensor<1, 3> StepResult::force() const
  {
    dealii::Tensor<1, 3> sum;
    for (const BoundaryStep &boundary : boundaries)
      if (boundary.opposite.empty())
        sum += boundary.force;
    return sum;
  }

  std::vector<BoundaryStep> boundary_steps(const ContactSurface &surface,
                                           const State &state,
                                           const Certificate &certificate,
                                           const std::vector<NodeStatus> &statuses)
  {
    std::vector<BoundaryStep> steps(surface.boundaries().size());
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      add_node(steps[surface.nodes()[i].boundary], surface.nodes()[i], statuses[i],
               at_node(certificate.lambda(), i), at_node(certificate.gradient(), i));
    for (std::size_t b = 0; b < steps.size(); ++b)
      {
        const ContactBoundary &boundary = surface.boundaries()[b];
        steps[b].name                   = boundary.name();
        steps[b].section_name           = boundary.section_name();
        steps[b].opposite               = boundary.partner_name();
        steps[b].obstacle_displacement =
          surface.obstacle_displacement(boundary.id(), state.distances);
        steps[b].obstacle_angle = boundary.angle();
        steps[b].is_tied        = boundary.is_tied();
        if (steps[b].is_tied)
          steps[b].center = dealii::Tensor<1, 3>();
        else if (steps[b].normal_force > 0.)
          steps[b].center /= steps[b].normal_force;
        steps[b].dissipated_total = steps[b].dissipated;
      }
    return steps;
  }
} // namespace stiction
