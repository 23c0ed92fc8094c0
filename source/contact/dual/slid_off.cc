#include <stiction/base/log.h>
#include <stiction/contact/dual/slid_off.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <Eigen/QR>

#include <algorithm>

namespace stiction
{
  namespace
  {
    // Of a slide: what the rigid motions of a body do at least of it where it is free.
    constexpr double least_of_slide = 0.5;

    // Whether a body is free to move along a direction at a point, turning or not.
    bool is_free(const FreeMotions &motions, const unsigned int piece,
                 const dealii::Point<3> &x, const Eigen::Vector3d &direction)
    {
      const auto [first, n] = motions.of(piece);
      if (n == 0)
        return false;
      const Eigen::MatrixXd moves = motions.at(x, piece).middleCols(first, n);
      const Eigen::Vector3d along = moves * moves.colPivHouseholderQr().solve(direction);
      return along.norm() > least_of_slide * direction.norm();
    }
  } // namespace

  std::string why_slid_off(const LinearElasticity &elasticity,
                           const ContactSurface &surface, const State &state,
                           const Units &units)
  {
    const Eigen::VectorXd moved = surface.B().relative_displacement(state.u);
    for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
      {
        const ContactNode &node         = surface.nodes()[i];
        const ContactBoundary &boundary = surface.boundary_of(node);
        if (!boundary.is_pair() || boundary.is_tied() || !(state.lambda(i) > 0.))
          continue;
        const Eigen::Vector3d normal = surface.B().frames()[i].axes().row(0);
        const Eigen::Vector3d slide =
          at_node(moved, i) - normal.dot(at_node(moved, i)) * normal;
        if (slide.norm() <= boundary.body_size())
          continue;
        const auto pieces = boundary.pieces(elasticity.body());
        if (std::any_of(pieces.begin(), pieces.end(), [&](const unsigned int piece) {
              return is_free(elasticity.free_motions(), piece, node.position, slide);
            }))
          return '\'' + boundary.name() + "' slid by " +
                 with_unit(format("%.2g", slide.norm()), units.length) + " on '" +
                 boundary.partner_name() +
                 "', farther than all bodies together are large: nothing held it where "
                 "it touched, change the loads, press parts together with more, or hold "
                 "them with 'Boundary conditions/Prescribed displacement'";
      }
    return "";
  }
} // namespace stiction
