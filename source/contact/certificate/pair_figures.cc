#include <stiction/contact/certificate/pair_figures.h>
#include <stiction/contact/interface/contact_boundary.h>
#include <stiction/contact/interface/contact_surface.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/pairs/climbed_facets.h>
#include <stiction/contact/pairs/surface_face.h>
#include <stiction/contact/pairs/wavering.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // A node with less is beyond the edge of what lies opposite, but for rounding.
    constexpr double covered = 0.499;

    // Of the distance of nodes: facets that are less deep are flat.
    constexpr double rounding = 1e-3;

    // Of the largest force at a node: those with less are left open by rounding.
    constexpr double least_share = 1e-3;

    // Nodes: what fewer of them bear tells nothing of pressures anyway.
    constexpr Eigen::Index enough_for_pressures = 5;

    // Of the depth of facets: those of meshes that match keep apart by less.
    constexpr double matching = 0.1;

    // Of how much the distances of the meshes differ: gaps that leave out less are
    // theirs.
    constexpr double much_left_out = 0.5;

    // Nodes: of fewer that bear, as of a ball on coarse cells, the pressures differ from
    // their means; a stiffer side that wavers leaves every other node open.
    constexpr Eigen::Index enough_to_waver = 30, enough_on_stiff_side = 9;

    // Of the pressing force: less friction is rounding.
    constexpr double no_friction = 1e-6;

    // Of what is opposite to a node: a body with less hardly moves it.
    constexpr double much_opposite = 0.1;

    // Of the product of a force and its arm: nodes along an axis have no moment about it.
    constexpr double least_moment = 0.01;

    // Nodes: forces at fewer of them have no moment to compare with.
    constexpr Eigen::Index least_with_arms = 3;

    // Of the largest force of the problem: a pair with less bears what a tolerance left.
    constexpr double least_force = 1e-6;

    // The nodes of a pair that are pressed, by rows.
    struct PressedNodes
    {
      Eigen::MatrixX3d positions, normals, opposite, slip;
      std::vector<Eigen::Index> nodes;
      Eigen::VectorXd pressing; // λ_ν
      Eigen::MatrixX3d friction;
      Eigen::VectorXd areas, covers, gaps, left_out; // of the distances of the meshes
      double facets = 0.;                            // m

      PressedNodes(const ContactSurface &surface, const ContactBoundary &pair,
                   const State &state)
      {
        for (Eigen::Index i = 0; i < surface.n_nodes(); ++i)
          if (surface.boundary_of(surface.nodes()[i]).id() == pair.id() &&
              state.lambda(i) > 0.)
            nodes.push_back(i);
        pressing     = state.lambda(nodes);
        areas        = surface.areas()(nodes);
        const auto n = pressing.size();
        for (Eigen::MatrixX3d *const rows :
             {&positions, &normals, &opposite, &slip, &friction})
          rows->resize(n, 3);
        for (Eigen::VectorXd *const values : {&covers, &gaps, &left_out})
          values->resize(n);
        const Eigen::VectorXd moved  = surface.relative_displacement(state);
        const Eigen::VectorXd forces = surface.forces(state.lambda);
        for (Eigen::Index k = 0; k < n; ++k)
          {
            const ContactNode &node = surface.nodes()[nodes[k]];
            for (unsigned int c = 0; c < 3; ++c)
              {
                positions(k, c) = node.center[c];
                normals(k, c)   = node.normal[c];
                opposite(k, c)  = node.opposite_normal[c];
              }
            slip.row(k)     = -at_node(moved, nodes[k]);
            friction.row(k) = at_node(forces, nodes[k]);
            covers(k)       = node.cover;
            gaps(k)         = node.mesh_gap;
            left_out(k)     = node.mesh_gap - node.gap;
            facets          = node.facets;
          }
        friction = along_surface(friction);
      }

      // Those that are not left open but for rounding.
      Eigen::Array<bool, Eigen::Dynamic, 1> bear() const
      {
        return pressing.array() > least_share * pressing.maxCoeff();
      }

      // Without what vectors have along the normals.
      Eigen::MatrixX3d along_surface(const Eigen::MatrixX3d &vectors) const
      {
        return vectors -
               vectors.cwiseProduct(normals).rowwise().sum().asDiagonal() * normals;
      }
    };

    void add_edge(const PressedNodes &pressed, PairFigures &figures)
    {
      struct
      {
        double force = 0., pressure = 0.;
      } beyond, opposite;
      for (Eigen::Index k = 0; k < pressed.pressing.size(); ++k)
        {
          auto &there        = pressed.covers(k) < covered ? beyond : opposite;
          const double force = pressed.pressing(k);
          there.force += force;
          there.pressure = std::max(there.pressure, force / pressed.areas(k));
        }
      figures.share_beyond_edge = beyond.force / (beyond.force + opposite.force);
      if (opposite.pressure > 0.)
        figures.peak_beyond_edge = std::max(1., beyond.pressure / opposite.pressure);
    }

    void add_gap(const PressedNodes &pressed, PairFigures &figures)
    {
      const Eigen::RowVector3d centre =
        pressed.pressing.transpose() * pressed.positions / pressed.pressing.sum();
      Eigen::RowVector3d across = Eigen::RowVector3d::Zero();
      for (Eigen::Index k = 0; k < pressed.gaps.size(); ++k)
        across += pressed.gaps(k) * pressed.normals.row(k).cross(pressed.friction.row(k));
      if (pressed.friction.norm() <= no_friction * pressed.pressing.norm() ||
          across.norm() == 0. || pressed.bear().count() < least_with_arms)
        return;
      double moment = 0.;
      for (Eigen::Index k = 0; k < pressed.gaps.size(); ++k)
        {
          const Eigen::RowVector3d arm   = pressed.positions.row(k) - centre,
                                   force = pressed.pressing(k) * pressed.normals.row(k) +
                                           pressed.friction.row(k);
          moment += std::max(std::abs(across.normalized().dot(arm.cross(force))),
                             least_moment * arm.norm() * force.norm());
        }
      const Eigen::VectorXd sizes = pressed.friction.rowwise().norm();
      figures.gap                 = sizes.dot(pressed.gaps.cwiseAbs()) / sizes.sum();
      figures.moment_across_gap   = moment > 0. ? across.norm() / moment : 0.;
    }

    void add_tilt(const PressedNodes &pressed, PairFigures &figures)
    {
      const Eigen::VectorXd at_rim =
        pressed.pressing.cwiseProduct(pressed.opposite.rowwise().norm());
      figures.tilt = (at_rim.transpose() * pressed.normals +
                      pressed.pressing.transpose() * pressed.opposite)
                       .norm() /
                     pressed.pressing.sum();
    }

    void add_way(const PressedNodes &pressed, PairFigures &figures)
    {
      figures.way     = pressed.along_surface(pressed.slip).rowwise().norm().maxCoeff();
      figures.spacing = std::sqrt(pressed.areas.mean());
    }

    void add_joint(const LinearElasticity &elasticity, const ContactSurface &surface,
                   const ContactBoundary &pair, const PressedNodes &pressed,
                   const State &state, PairFigures &figures)
    {
      std::set<unsigned int> pieces;
      for (const auto id : pair.partners())
        pieces.merge(elasticity.body().pieces_at(id));
      if (pieces.size() < 2)
        return;
      std::map<types::global_dof_index, unsigned int> piece_of;
      for (const SurfaceFace &face : surface_faces(elasticity, pair.partners()))
        for (unsigned int i = 0; i < face.n_nodes(); ++i)
          piece_of.emplace(face.dofs[i], face.piece);
      const ContactOperator::OtherSide &other = surface.B().other_side();
      const Eigen::VectorXd moved             = other.dofs.restriction(state.u);
      const auto bears                        = pressed.bear();
      for (std::size_t k = 0; k < pressed.nodes.size(); ++k)
        {
          if (!bears(k))
            continue;
          // Σ W_ij (1, n_i · u_j), of all and of each body
          Eigen::Vector2d all = Eigen::Vector2d::Zero();
          std::map<unsigned int, Eigen::Vector2d> bodies;
          for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(
                 other.weights, pressed.nodes[k]);
               entry; ++entry)
            if (const auto piece = piece_of.find(other.dofs.dofs()[entry.col()]);
                piece != piece_of.end())
              {
                const Eigen::Vector2d of_node =
                  entry.value() * Eigen::Vector2d(1., pressed.normals.row(k).dot(
                                                        at_node(moved, entry.col())));
                all += of_node;
                bodies.try_emplace(piece->second, Eigen::Vector2d::Zero())
                  .first->second += of_node;
              }
          for (const auto &[piece, sums] : bodies)
            if (sums(0) > much_opposite * all(0))
              figures.joint =
                std::max(figures.joint, all(1) / all(0) - sums(1) / sums(0));
        }
    }

    // The faces with one of some nodes.
    struct BearingFaces
    {
      double mean_edge = 0.; // m
      double softness  = 0.; // 1/E, 1/Pa
      double angle     = 0.; // mean of those to a next face that is inclined

      BearingFaces(const std::vector<SurfaceFace> &faces,
                   const std::set<types::global_dof_index> &nodes)
      {
        const auto kinks_of = kinks(faces);
        unsigned int n = 0, n_of_kink = 0;
        for (std::size_t f = 0; f < faces.size(); ++f)
          if (std::any_of(faces[f].dofs.begin(),
                          faces[f].dofs.begin() + faces[f].n_nodes(),
                          [&](const auto dof) { return nodes.count(dof) > 0; }))
            {
              ++n;
              mean_edge += faces[f].diameter() / std::sqrt(2.);
              softness += 1. / faces[f].youngs_modulus;
              if (const double kink = kinks_of[f][1];
                  faces[f].degree == 1 && kink > flat_kink && kink < sharp_kink)
                {
                  angle += 2. * kink;
                  ++n_of_kink;
                }
            }
        mean_edge /= std::max(1U, n);
        softness /= std::max(1U, n);
        angle /= std::max(1U, n_of_kink);
      }
    };

    // Of the directions along the surface only those count in which one of both surfaces
    // goes on: in a plane model none does across its cells.
    void add_sizes(const LinearElasticity &elasticity, const ContactSurface &surface,
                   const ContactBoundary &pair, const PressedNodes &pressed,
                   PairFigures &figures)
    {
      const ContactOperator::OtherSide &other = surface.B().other_side();
      const auto first_dofs                   = surface.first_dofs();
      Eigen::VectorXd forces                  = Eigen::VectorXd::Zero(surface.n_nodes());
      forces(pressed.nodes)                   = pressed.pressing;
      const Eigen::VectorXd felt = other.weights.transpose().cwiseAbs() * forces;
      std::set<types::global_dof_index> own, opposite;
      for (const Eigen::Index i : pressed.nodes)
        own.insert(first_dofs[i]);
      for (Eigen::Index j = 0; j < felt.size(); ++j)
        if (felt(j) > least_share * felt.maxCoeff())
          opposite.insert(other.dofs.dofs()[j]);
      auto boundaries = pair.partners();
      boundaries.push_back(pair.id());
      const auto faces = surface_faces(elasticity, boundaries);
      const BearingFaces of_own(faces, own), of_other(faces, opposite);
      const double size = std::max(of_own.mean_edge, of_other.mean_edge);
      if (pressed.bear().count() >= enough_for_pressures &&
          pressed.gaps.cwiseAbs().maxCoeff() > matching * pressed.facets)
        figures.facet_pressure =
          M_PI * (of_own.angle + of_other.angle) /
          (16. * (of_own.softness + of_other.softness) *
           pressed.pressing.cwiseQuotient(pressed.areas).maxCoeff());

      const Eigen::MatrixX3d arms =
        pressed.positions.rowwise() -
        pressed.areas.transpose() * pressed.positions / pressed.areas.sum();
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(
        arms.transpose() * pressed.areas.asDiagonal() * arms / pressed.areas.sum());
      for (const Eigen::Index k : {1, 2}) // the first axis is across the surface
        {
          const Eigen::Vector3d axis  = spread.eigenvectors().col(k);
          const Eigen::VectorXd along = pressed.positions * axis;
          double least = along.minCoeff(), most = along.maxCoeff();
          for (const SurfaceFace &face : faces)
            for (unsigned int i = 0; i < face.n_nodes(); ++i)
              {
                const double place = axis.dot(Eigen::Vector3d::Map(face.nodes[i].data()));
                least              = std::min(least, place);
                most               = std::max(most, place);
              }
          if (most - least > along.maxCoeff() - along.minCoeff() + 0.5 * size)
            figures.cells_across =
              std::min(figures.cells_across,
                       std::sqrt(12. * std::max(0., spread.eigenvalues()(k))) / size);
        }
    }

    void add_wavering(const LinearElasticity &elasticity, const ContactSurface &surface,
                      const ContactBoundary &pair, const State &state,
                      const double force_scale, PairFigures &figures)
    {
      const Eigen::VectorXd lambda = surface.forces(state.lambda);
      Eigen::VectorXd areas        = surface.areas();
      Eigen::MatrixX3d forces      = Eigen::MatrixX3d::Zero(areas.size(), 3);
      for (Eigen::Index i = 0; i < areas.size(); ++i)
        if (surface.boundary_of(surface.nodes()[i]).id() == pair.id())
          forces.row(i) = at_node(lambda, i);
        else
          areas(i) = 0.;
      const Eigen::VectorXd sizes = forces.rowwise().norm();
      const auto enough =
        surface.has_wavering_side() ? enough_on_stiff_side : enough_to_waver;
      if (sizes.sum() <= least_force * force_scale ||
          (sizes.array() > least_share * sizes.maxCoeff()).count() < enough)
        return;
      const auto softness = [&](const std::vector<types::boundary_id> &boundaries) {
        const auto faces = surface_faces(elasticity, boundaries);
        double sum       = 0.;
        for (const SurfaceFace &face : faces)
          sum += 1. / face.youngs_modulus;
        return sum / static_cast<double>(faces.size());
      };
      const double own = softness({pair.id()}), other = softness(pair.partners());
      figures.stiffness_in_wavering = std::min(1., 2. * other / (own + other));
      figures.wavering = wavering(surface.B().other_side().weights, forces, areas);
    }
  } // namespace

  PairFigures pair_figures(const LinearElasticity &elasticity,
                           const ContactSurface &surface, const ContactBoundary &pair,
                           const State &state, const double force_scale)
  {
    PairFigures figures;
    add_wavering(elasticity, surface, pair, state, force_scale, figures);
    if (pair.is_tied())
      return figures;
    const PressedNodes pressed(surface, pair, state);
    if (pressed.pressing.sum() <= least_force * force_scale)
      return figures;
    add_edge(pressed, figures);
    add_gap(pressed, figures);
    add_way(pressed, figures);
    add_tilt(pressed, figures);
    add_joint(elasticity, surface, pair, pressed, state, figures);
    add_sizes(elasticity, surface, pair, pressed, figures);
    const auto bears  = pressed.bear();
    const auto spread = [&](const Eigen::VectorXd &values) {
      return bears.select(values.array(), values.minCoeff()).maxCoeff() -
             bears.select(values.array(), values.maxCoeff()).minCoeff();
    };
    // 'Initial gap' may have the gaps of round bodies, but for facets
    if (spread(pressed.left_out) > much_left_out * spread(pressed.gaps))
      figures.misfit = std::min(spread(pressed.left_out), spread(pressed.gaps)) /
                       std::max(pressed.facets, rounding * figures.spacing);
    figures.climbed = climbed_facets(pressed.positions, pressed.normals, pressed.slip,
                                     pressed.areas, pressed.pressing);
    return figures;
  }

  std::vector<dealii::Tensor<1, 3>> forces_of_partners(const LinearElasticity &elasticity,
                                                       const ContactSurface &surface,
                                                       const ContactBoundary &pair,
                                                       const State &state)
  {
    std::map<dealii::types::global_dof_index, std::size_t> partner_of;
    for (std::size_t p = 0; p < pair.partners().size(); ++p)
      for (const SurfaceFace &face : surface_faces(elasticity, {pair.partners()[p]}))
        for (unsigned int i = 0; i < face.n_nodes(); ++i)
          partner_of.emplace(face.dofs[i], p);

    const Eigen::Index m   = surface.n_nodes();
    Eigen::VectorXd forces = surface.forces(state.lambda);
    for (Eigen::Index i = 0; i < m; ++i)
      if (surface.boundary_of(surface.nodes()[i]).id() != pair.id())
        set_at_node(forces, i, Eigen::Vector3d::Zero());
    const ContactOperator::OtherSide &other = surface.B().other_side();
    const Eigen::VectorXd opposite          = other.A.transpose() * forces;
    std::vector<dealii::Tensor<1, 3>> sums(pair.partners().size());
    for (Eigen::Index j = 0; j < other.dofs.size() / 3; ++j)
      if (const auto partner = partner_of.find(other.dofs.dofs()[j]);
          partner != partner_of.end())
        sums[partner->second] -= to_tensor(at_node(opposite, j));
    return sums;
  }
} // namespace stiction
