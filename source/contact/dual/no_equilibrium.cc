#include <stiction/base/log.h>
#include <stiction/base/text/in_words.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/friction_data.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/dual/no_equilibrium.h>
#include <stiction/contact/dual/rigid_balance.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/contact_conditions.h>
#include <stiction/qp/operators/nodal_blocks.h>
#include <stiction/qp/unbalanced_load.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of a motion: nodes that move by less against what is opposite go along with it.
    constexpr double no_motion = 1e-3;

    // Of the pressing forces: a direction with less of them is along the surfaces.
    constexpr double least_of_normals = 1e-3;

    // Of a motion that friction of the largest coefficient lifts, what is along the
    // surface: with less it is no slide.
    constexpr double least_slide = 0.5;

    // Of the loads: that much less, and there may be an equilibrium.
    constexpr double at_the_limit = 1e-6;

    // Of what the loads push with: less is none.
    constexpr double no_force = 1e-12;

    // Of what a motion out of contact moves: rounding, and normals that are not quite
    // those of the surface.
    constexpr double still_pressed = 1e-3;

    const char *const what_stops_it =
      "; change the loads, press parts together with more, or hold them with "
      "'Boundary conditions/Prescribed displacement'";

    // A motion turns the body if this part of it or more is rotation, at the ends of the
    // body.
    constexpr double least_turn = 0.05;

    // Of the body that moves the most: another one moves if it does so much of it.
    constexpr double moves_along = 0.1;

    // A motion is known to so many digits only.
    std::string vector(Tensor<1, 3> v, const double size)
    {
      for (unsigned int c = 0; c < 3; ++c)
        if (std::abs(v[c]) < 1e-3 * size)
          v[c] = 0.;
      return '(' + format_vector("%.3g", v) + ')';
    }

    // The projection on what is along all surfaces that bear forces where something
    // moves, or may bear some if none does; zero where nothing moves.
    Eigen::Matrix3d along_surfaces(const ContactSurface &surface,
                                   const Eigen::VectorXd &lambda,
                                   const Eigen::VectorXd &moved, const double motion)
    {
      Eigen::Matrix3d of_forces = Eigen::Matrix3d::Zero(), of_all = of_forces;
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        if (at_node(moved, i).norm() > no_motion * motion)
          {
            const Eigen::Vector3d normal = to_vector(surface.nodes()[i].free_normal);
            of_forces += lambda(i) * normal * normal.transpose();
            of_all += normal * normal.transpose();
          }
      const Eigen::Matrix3d &normals = of_forces.isZero(0.) ? of_all : of_forces;
      if (normals.isZero(0.))
        return normals;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(normals);
      Eigen::Matrix3d along = Eigen::Matrix3d::Identity();
      for (Eigen::Index k = 0; k < 3; ++k)
        if (eigen.eigenvalues()(k) > least_of_normals * normals.trace())
          along -= eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).transpose();
      return along;
    }

    // A motion of all bodies that no contact forces can stop.
    struct Runaway
    {
      std::string who;      // "the body", "body 'lid'", "bodies 'lid' and 'box'"
      RigidMotion motion;   // of the one that moves the most
      Tensor<1, 3> slide;   // of it without rotation, if it is one
      double size;          // of this one
      Tensor<1, 3> load;    // on those that move
      double work;          // that contact leaves over
      bool is_alone = true; // no other body moves in another way
    };

    Runaway find_runaway(const LinearElasticity &elasticity,
                         const Eigen::VectorXd &amounts, const double work,
                         const Eigen::Matrix3d &along_surfaces, const double coefficient)
    {
      const Body &body    = elasticity.body();
      const auto motions  = elasticity.free_motions().motions(amounts);
      const std::size_t n = motions.size();
      std::vector<double> extents(n);
      for (std::size_t p = 0; p < n; ++p)
        extents[p] = motions[p].translation.norm() +
                     motions[p].rotation.norm() * body.pieces()[p].radius();
      const auto largest = std::max_element(extents.begin(), extents.end());
      std::vector<double> loads(3 * n);
      for (const Body::Node &node : body.locally_owned_nodes())
        for (unsigned int c = 0; c < 3; ++c)
          loads[3 * node.piece + c] += elasticity.load()(node.dofs[c]);
      Utilities::MPI::sum(loads, body.communicator(), loads);

      const auto p = static_cast<std::size_t>(largest - extents.begin());
      Runaway runaway{"the body", motions[p], {}, body.pieces()[p].radius(), {}, work};
      // on a rough face a motion that friction cannot stop lifts the body as well: that
      // is the cone's, not the motion's
      const Tensor<1, 3> &way  = motions[p].translation;
      const Tensor<1, 3> slide = to_tensor(along_surfaces * to_vector(way));
      if (std::hypot(1., coefficient) * slide.norm() > least_slide * way.norm() &&
          elasticity.free_motions().can_move(p, slide / slide.norm()))
        runaway.slide = slide;
      // of a mechanism each body has its own motion
      const auto moves_alike = [&](const std::size_t q) {
        const RigidMotion &other = motions[q];
        return (other.at(other.centre) - motions[p].at(other.centre)).norm() +
                 (other.rotation - motions[p].rotation).norm() *
                   body.pieces()[q].radius() <
               moves_along * *largest;
      };
      std::vector<std::string> names;
      for (std::size_t q = 0; q < n; ++q)
        if (extents[q] >= moves_along * *largest)
          {
            if (moves_alike(q))
              names.push_back('\'' + body.pieces()[q].name + '\'');
            else
              runaway.is_alone = false;
            for (unsigned int c = 0; c < 3; ++c)
              runaway.load[c] += loads[3 * q + c];
          }
      if (n > 1)
        runaway.who = (names.size() > 1 ? "bodies " : "body ") + listed(names) +
                      (runaway.is_alone ? "" : ", with others in their own ways,");
      return runaway;
    }

    std::string in_words(const Runaway &runaway, const Units &units)
    {
      const auto &[who, motion, slide, size, load, work, is_alone] = runaway;
      const std::string s     = who.rfind("bodies", 0) == 0 ? " " : "s ";
      const double turn       = motion.rotation.norm() * size;
      const Tensor<1, 3> axis = motion.rotation / (turn > 0. ? turn / size : 1.);
      // a screw is what it does more
      if (turn > std::max(least_turn * motion.translation.norm(),
                          std::abs(motion.translation * axis)))
        {
          const Tensor<1, 3> to_axis =
            cross_product_3d(motion.rotation, motion.translation) /
            motion.rotation.norm_square();
          return who + " turn" + s + "about the axis along " + vector(axis, 1.) +
                 " through " + vector(motion.centre + to_axis, size) +
                 ", where the loads turn it with " +
                 with_unit(format("%.3g", work / motion.rotation.norm()), units.moment) +
                 " more than contact bears";
        }
      const bool slides            = slide.norm() > 0.;
      const Tensor<1, 3> &way      = slides ? slide : motion.translation;
      const double length          = way.norm();
      const Tensor<1, 3> direction = way / length;
      const double pushing         = load * direction;
      const double lacking         = work / length;
      const std::string moves = who + (slides ? " slide" + s : " move" + s + "away ") +
                                "along " + vector(direction, 1.) + ", where the loads ";
      const std::string bears = slides ? "friction bears" : "contact bears";
      // of bodies that move each in its own direction the work alone is known
      if (!is_alone || pushing < (1. - no_force) * lacking)
        return moves + "push with " + with_unit(format("%.3g", lacking), units.force) +
               " more than " + bears;
      const double borne =
        pushing - lacking > no_force * pushing ? pushing - lacking : 0.;
      // so many digits that they differ
      std::string push, bear;
      for (unsigned int digits = 4; digits <= 12 && push == bear; ++digits)
        {
          const std::string form = "%." + std::to_string(digits) + "g";
          push                   = format(form.c_str(), pushing);
          bear                   = format(form.c_str(), borne);
        }
      return moves + "push with " + with_unit(push, units.force) + " and " + bears + " " +
             with_unit(bear, units.force);
    }

    // A motion that no forces within a slip bound stop, in words, none if it is empty;
    // the part of the loads that they lack; and what is left of them, −ρ being the
    // motion.
    struct Unstopped
    {
      std::string motion;
      double part         = 0.;
      Eigen::VectorXd rho = {};
    };

    // @param reached contact forces with the normals where something moves; those that
    //   come nearest if there are none.
    Unstopped unstopped_motion(const LinearElasticity &elasticity,
                               const ContactSurface &surface,
                               const EqualityConstraint &balance,
                               const qp::SlipBound &slip_bound,
                               const Eigen::VectorXd *const reached, const Units &units)
    {
      const FreeMotions &motions = elasticity.free_motions();
      if (motions.n() == 0)
        return {};
      const auto [rho, lambda, part] = qp::unbalanced_load(balance, slip_bound);
      if (rho.isZero(0.))
        return {};

      const Eigen::VectorXd of_body = -rho.tail(motions.n());
      // what the loads do along −ρ beyond what given friction can
      const Eigen::VectorXd moved = balance.G * rho;
      double work                 = balance.e.dot(rho);
      for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
        if (slip_bound.is_given(i))
          work -= slip_bound.constant()(i) * at_node(moved, i).tail<2>().norm();
      if (of_body.norm() < 0.5 * rho.norm())
        return {"the obstacle that is pressed on finds nothing that bears " +
                  with_unit(format("%.4g", work / rho.norm()), units.force),
                part, rho};
      const Eigen::Matrix3d along = along_surfaces(
        surface, reached != nullptr ? *reached : lambda, moved, rho.norm());
      return {in_words(find_runaway(elasticity, of_body, work, along,
                                    surface.largest_coefficient()),
                       units),
              part, rho};
    }
  } // namespace

  std::string why_loose(const LinearElasticity &elasticity, const ContactSurface &surface)
  {
    const auto &pieces = elasticity.body().pieces();
    if (pieces.size() == 1 || elasticity.free_motions().n() == 0)
      return "";
    const Eigen::MatrixXd G =
      rigid_balance(elasticity, surface).G.rightCols(elasticity.free_motions().n());
    std::vector<std::string> loose;
    for (unsigned int p = 0; p < pieces.size(); ++p)
      if (const auto [first, n] = elasticity.free_motions().of(p);
          n == 6 && G.middleCols(first, n).isZero(0.))
        loose.push_back('\'' + pieces[p].name + '\'');
    if (loose.empty())
      return "";
    return "the mesh is of " + std::to_string(pieces.size()) + " bodies, of which " +
           listed(loose) + (loose.size() > 1 ? " have" : " has") +
           " neither a support nor a contact boundary; pair a boundary with that of "
           "another body, or, where they are one body, merge the nodes at the same place "
           "(Gmsh: 'Coherence Mesh')";
  }

  std::string why_no_equilibrium(const LinearElasticity &elasticity,
                                 const ContactSurface &surface, const Units &units)
  {
    if (surface.has_friction_of_state())
      return "";
    const Unstopped unstopped =
      unstopped_motion(elasticity, surface, rigid_balance(elasticity, surface),
                       surface.slip_bound(), nullptr, units);
    if (unstopped.motion.empty())
      return "";
    return (unstopped.part <= at_the_limit ? "no equilibrium exists, by a hair: "
                                           : "no equilibrium exists: ") +
           unstopped.motion;
  }

  std::string why_it_slides(const LinearElasticity &elasticity,
                            const ContactSurface &surface,
                            const ContactConditions &reached, const Units &units)
  {
    const Eigen::VectorXd &lambda = reached.lambda();
    const Unstopped unstopped =
      unstopped_motion(elasticity, surface, rigid_balance(elasticity, surface),
                       qp::SlipBound::given(reached.slip_bound()), &lambda, units);
    if (unstopped.part <= qp::safe_beside_pressures * reached.normal_residual())
      return "";
    return "at the pressures that were reached " + unstopped.motion + what_stops_it;
  }

  std::string why_it_comes_out(const LinearElasticity &elasticity,
                               const ContactSurface &surface,
                               const Eigen::VectorXd &lambda, const Units &units)
  {
    const Eigen::Index m = surface.n_nodes();
    if (surface.has_friction_of_state() || !(lambda.head(m).maxCoeff() > 0.))
      return "";
    const EqualityConstraint balance = rigid_balance(elasticity, surface);
    EqualityConstraint of_friction   = balance;
    for (Eigen::Index i = 0; i < m; ++i)
      if (!surface.slip_bound().is_tied(i))
        {
          of_friction.e -= lambda(i) * balance.G.row(i).transpose();
          of_friction.G.row(i).setZero();
        }
    const Eigen::VectorXd bound = surface.slip_bound().at(lambda);
    const Unstopped unstopped   = unstopped_motion(
        elasticity, surface, of_friction, qp::SlipBound::given(bound), &lambda, units);
    if (unstopped.part <= at_the_limit)
      return "";

    // Nothing may be pressed more along the motion, nor do pressures that fall to
    // nothing, as those of loads taken away, push.
    const Eigen::VectorXd moved = balance.G * unstopped.rho;
    double resisted = 0., largest = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        largest = std::max(largest, at_node(moved, i).norm());
        if (!surface.slip_bound().is_tied(i))
          resisted += std::max(0., bound(i) * at_node(moved, i).tail<2>().norm() +
                                     lambda(i) * moved(i));
      }
    if (moved.head(m).maxCoeff() > still_pressed * largest ||
        balance.e.dot(unstopped.rho) <= (1. + at_the_limit) * resisted)
      return "";
    return "at the pressures of the step before " + unstopped.motion + what_stops_it;
  }
} // namespace stiction
