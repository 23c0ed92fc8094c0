#include <stiction/base/log.h>
#include <stiction/contact/dual/slid_off.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace stiction
{
  namespace
  {
    // Of a slide: what the rigid motions of a body do at least of it where it is free.
    constexpr double least_of_slide = 0.5;

    // In distances of nodes: after a slide by more the gaps, normals and what lies
    // opposite, which are those of the undeformed bodies, are those of other places.
    constexpr double far = 1.;

    // Of the strain energy of both bodies.
    constexpr double much_from_facets = 0.1;

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
                           const ShareOfFacets &share_of_facets, const Units &units)
  {
    const Eigen::VectorXd moved = surface.B().relative_displacement(state.u);
    const auto slide_of         = [&](const Eigen::Index i) {
      const Eigen::Vector3d normal = surface.B().frames()[i].axes().row(0);
      return (at_node(moved, i) - normal.dot(at_node(moved, i)) * normal).eval();
    };
    for (const ContactBoundary &pair : surface.boundaries())
      {
        if (!pair.is_pair() || pair.is_tied())
          continue;
        Eigen::Index farthest = -1;
        for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
          if (&surface.boundary_of(surface.nodes()[i]) == &pair && state.lambda(i) > 0. &&
              (farthest < 0 || slide_of(i).norm() > slide_of(farthest).norm()))
            farthest = i;
        if (farthest < 0)
          continue;
        const ContactNode &node     = surface.nodes()[farthest];
        const Eigen::Vector3d slide = slide_of(farthest);
        const auto pieces           = pair.pieces(elasticity.body());
        if (slide.norm() <= far * std::sqrt(node.area) ||
            std::none_of(pieces.begin(), pieces.end(), [&](const unsigned int piece) {
              return is_free(elasticity.free_motions(), piece, node.position, slide);
            }))
          continue;
        const bool is_off  = slide.norm() > pair.body_size();
        const double share = is_off ? 0. : share_of_facets(pair);
        if (is_off || share > much_from_facets)
          return '\'' + pair.name() + "' slid by " +
                 with_unit(format("%.2g", slide.norm()), units.length) + " on '" +
                 pair.partner_name() + "', " +
                 (is_off ? std::string("farther than all bodies together are large")
                         : format("until facets wedged, which have %.2g %% of the strain "
                                  "energy",
                                  100. * share)) +
                 ": nothing else held it where it touched, change the loads, press parts "
                 "together with more, or hold them with 'Boundary conditions/Prescribed "
                 "displacement'";
      }
    return "";
  }
} // namespace stiction
