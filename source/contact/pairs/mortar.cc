#include "face_share.h"
#include "sheets.h"

#include <stiction/base/all_gather.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/contact/pairs/smooth_parts.h>
#include <stiction/elasticity/linear_algebra/sorted_list.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/numerics/rtree.h>

#include <Eigen/SparseLU>

#include <algorithm>
#include <map>
#include <set>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Dof          = types::global_dof_index;
    using SparseMatrix = Eigen::SparseMatrix<double>;

    // Of the diameter of a face: the gap varies by less along it.
    constexpr double steepest = 10.;

    // Entries of the weights that come of long chains of hanging nodes: less is rounding.
    constexpr double no_weight = 1e-15;

    // What the face can see along its normal.
    BoundingBox<3> box_of_sight(const SurfaceFace &face, const double reach)
    {
      std::vector<Point<3>> points;
      for (unsigned int i = 0; i < face.n_nodes(); ++i)
        for (const double way : {-reach, reach})
          points.push_back(face.node(i) + way * face.normal());
      return {points};
    }

    // The master faces, found by where they are.
    class MasterSurface
    {
    public:
      explicit MasterSurface(const std::vector<SurfaceFace> &faces)
        : faces_(faces)
        , boxes_(boxes_of(faces))
        , tree_(pack_rtree_of_indices(boxes_))
      {
      }

      MasterSurface(const MasterSurface &) = delete; // the tree refers to the boxes

      // The points of a face with the nearest sheets of this surface opposite, along its
      // normal within the reach; overlaps that are deeper are left out.
      std::vector<CoveredPoint> opposite(const SurfaceFace &slave, const double reach,
                                         const double deepest, double &left_out) const
      {
        const FaceOverlap overlap(slave);
        const double steep = steepest * slave.diameter();
        double sight = std::min(reach, 2. * steep), farthest = reach;
        std::vector<CoveredPoint> points;
        while (true) // what is far is looked for only where nothing is near
          {
            points.clear();
            double nearest = reach;
            for (const SurfaceFace *const master : within(box_of_sight(slave, sight)))
              for (const OverlapPoint &point : overlap.with(*master))
                {
                  if (-point.gap >= deepest)
                    {
                      left_out = std::max(left_out, -point.gap);
                      continue;
                    }
                  points.push_back({point, master});
                  nearest = std::min(nearest, std::abs(point.gap));
                }
            farthest = std::min(reach, nearest + steep);
            if (farthest <= sight)
              break;
            sight = std::min(reach, 2. * sight);
          }
        points.erase(std::remove_if(points.begin(), points.end(),
                                    [&](const CoveredPoint &point) {
                                      return std::abs(point.at.gap) > farthest;
                                    }),
                     points.end());
        keep_nearest_sheets(slave.diameter(), points);
        return points;
      }

    private:
      static std::vector<BoundingBox<3>> boxes_of(const std::vector<SurfaceFace> &faces)
      {
        std::vector<BoundingBox<3>> boxes;
        for (const SurfaceFace &face : faces)
          boxes.push_back(box_of_sight(face, 0.));
        return boxes;
      }

      std::vector<const SurfaceFace *> within(const BoundingBox<3> &box) const
      {
        std::vector<std::size_t> numbers;
        tree_.query(boost::geometry::index::intersects(box), std::back_inserter(numbers));
        std::sort(numbers.begin(), numbers.end());
        std::vector<const SurfaceFace *> found;
        for (const std::size_t k : numbers)
          found.push_back(&faces_[k]);
        return found;
      }

      const std::vector<SurfaceFace> &faces_;
      const std::vector<BoundingBox<3>> boxes_;
      const decltype(pack_rtree_of_indices(boxes_)) tree_;
    };

    // Numbers from 0 for the nodes that do not hang, and how all follow from them.
    class Numbering
    {
    public:
      Numbering(const LinearElasticity &elasticity, const std::vector<Dof> &nodes)
      {
        const Body &body = elasticity.body();
        struct Weight
        {
          Dof node, other;
          double weight;
        };
        std::vector<Weight> own;
        for (const Dof node : nodes)
          if (body.locally_owned_dofs().is_element(node) && body.is_hanging(node))
            for (const auto &[other, weight] :
                 *body.hanging_nodes().get_constraint_entries(node))
              own.push_back({node, other, weight});
        for (const Weight &entry : all_gather(own, body.communicator()))
          hanging_[entry.node].emplace_back(entry.other, entry.weight);
        for (const Dof node : nodes)
          {
            const auto hanging = hanging_.find(node);
            if (hanging == hanging_.end())
              dofs.push_back(node);
            else
              for (const auto &[other, weight] : hanging->second)
                dofs.push_back(other);
          }
        sort_once(dofs);
      }

      // C: the given nodes by those that do not hang.
      SparseMatrix matrix(const std::vector<Dof> &nodes) const
      {
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t i = 0; i < nodes.size(); ++i)
          {
            const auto hanging = hanging_.find(nodes[i]);
            if (hanging == hanging_.end())
              entries.emplace_back(i, place_in(dofs, nodes[i]), 1.);
            else
              for (const auto &[other, weight] : hanging->second)
                entries.emplace_back(i, place_in(dofs, other), weight);
          }
        SparseMatrix C(static_cast<Eigen::Index>(nodes.size()),
                       static_cast<Eigen::Index>(dofs.size()));
        C.setFromTriplets(entries.begin(), entries.end());
        return C;
      }

      bool has_hanging_nodes() const { return !hanging_.empty(); }

      std::vector<Dof> dofs;

    private:
      std::map<Dof, std::vector<std::pair<Dof, double>>> hanging_;
    };

    std::vector<FaceShare> integrate(const LinearElasticity &elasticity,
                                     const std::vector<SurfaceFace> &slave_faces,
                                     const std::vector<SurfaceFace> &master_faces,
                                     const double reach, const double deepest,
                                     double &left_out)
    {
      const MasterSurface masters(master_faces);
      // each rank takes its share of the list
      MPI_Comm communicator      = elasticity.body().communicator();
      const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
      const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
      const std::size_t n        = slave_faces.size();
      std::vector<FaceShare> shares;
      for (std::size_t f = n * rank / n_ranks; f < n * (rank + 1) / n_ranks; ++f)
        for (const FaceShare &share :
             shares_of(slave_faces[f],
                       masters.opposite(slave_faces[f], reach, deepest, left_out)))
          shares.push_back(share);
      left_out = Utilities::MPI::max(left_out, communicator);
      shares   = all_gather(shares, communicator);
      keep_nearest_sheets(shares);
      return shares;
    }

    // What the shares add up to at all nodes that they are of, hanging ones too.
    struct Integrals
    {
      explicit Integrals(const std::vector<FaceShare> &shares)
      {
        for (const FaceShare &share : shares)
          if (share.is_own())
            slaves.push_back(share.slave);
          else
            masters.push_back(share.master);
        sort_once(slaves);
        sort_once(masters);
        const auto n = static_cast<Eigen::Index>(slaves.size());
        D = gaps = moduli = covers = Eigen::VectorXd::Zero(n);
        opposite                   = Eigen::MatrixX3d::Zero(n, 3);
        Eigen::VectorXd smallest   = Eigen::VectorXd::Constant(n, 1e300),
                        largest    = -smallest;
        std::vector<Eigen::Triplet<double>> entries, common;
        for (const FaceShare &share : shares)
          {
            const auto i = static_cast<Eigen::Index>(place_in(slaves, share.slave));
            if (!share.is_own())
              {
                const std::size_t j = place_in(masters, share.master);
                entries.emplace_back(i, j, share.value);
                common.emplace_back(i, j, share.overlap);
                continue;
              }
            D(i) += share.value;
            gaps(i) += share.gap;
            smallest(i) = std::min(smallest(i), share.smallest);
            largest(i)  = std::max(largest(i), share.largest);
            moduli(i)   = std::max(moduli(i), share.modulus);
            covers(i)   = std::max(covers(i), share.cover);
            opposite.row(i) += Eigen::RowVector3d::Map(share.normal.data());
          }
        const auto m = static_cast<Eigen::Index>(masters.size());
        M.resize(n, m);
        overlaps.resize(n, m);
        M.setFromTriplets(entries.begin(), entries.end());
        overlaps.setFromTriplets(common.begin(), common.end());
        for (Eigen::Index i = 0; i < n; ++i)
          if (D(i) > 0.)
            gaps(i) = D(i) * std::clamp(gaps(i) / D(i), smallest(i), largest(i));
      }

      std::vector<Dof> slaves, masters;
      Eigen::VectorXd D, gaps, moduli, covers; // gaps: times D
      Eigen::MatrixX3d opposite;
      SparseMatrix M, overlaps;
    };
  } // namespace

  Mortar::Mortar(const LinearElasticity &elasticity,
                 const std::vector<SurfaceFace> &slave_faces,
                 const std::vector<SurfaceFace> &master_faces)
  {
    if (slave_faces.empty() || master_faces.empty())
      return;
    const double reach =
      std::min(slave_faces.front().surface_size, master_faces.front().surface_size);
    thickness = std::min(slave_faces.front().thickness, master_faces.front().thickness);
    facets    = depth_of_facets(slave_faces) + depth_of_facets(master_faces);
    const Integrals all(integrate(elasticity, slave_faces, master_faces, reach, thickness,
                                  deepest_left_out));
    const Numbering of_slave(elasticity, all.slaves), of_master(elasticity, all.masters);
    slaves  = of_slave.dofs;
    masters = of_master.dofs;
    if (slaves.empty())
      return;
    const SparseMatrix C         = of_slave.matrix(all.slaves);
    const SparseMatrix C_master  = of_master.matrix(all.masters);
    const SparseMatrix M_hanging = C.transpose() * all.M * C_master;
    overlaps = C.cwiseAbs().transpose() * all.overlaps * C_master.cwiseAbs();
    areas    = C.transpose() * all.D;
    normals  = (C.cwiseAbs().transpose() * all.opposite).rowwise().normalized();
    const std::set<Dof> rim = rim_of(slave_faces);
    for (std::size_t i = 0; i < slaves.size(); ++i)
      if (rim.count(slaves[i]) == 0)
        normals.row(static_cast<Eigen::Index>(i)).setZero();
    youngs_moduli = covers = Eigen::VectorXd::Zero(areas.size());
    for (Eigen::Index j = 0; j < C.cols(); ++j)
      for (SparseMatrix::InnerIterator entry(C, j); entry; ++entry)
        {
          youngs_moduli(j) = std::max(youngs_moduli(j), all.moduli(entry.row()));
          covers(j)        = std::max(covers(j), all.covers(entry.row()));
        }
    if (of_slave.has_hanging_nodes())
      {
        const SparseMatrix D_hanging = C.transpose() * all.D.asDiagonal() * C;
        const Eigen::SparseLU<SparseMatrix> inverse(D_hanging);
        weights = SparseMatrix(inverse.solve(M_hanging));
        gaps    = inverse.solve(C.transpose() * all.gaps);
      }
    else
      {
        const Eigen::VectorXd inverse = areas.cwiseInverse();
        weights                       = inverse.asDiagonal() * M_hanging;
        gaps                          = inverse.cwiseProduct(C.transpose() * all.gaps);
      }
    weights.prune(1., no_weight);
  }

  Eigen::Index Mortar::row_of(const types::global_dof_index slave) const
  {
    const std::size_t row = place_in(slaves, slave);
    return row < slaves.size() && slaves[row] == slave ? static_cast<Eigen::Index>(row)
                                                       : -1;
  }

  bool Mortar::is_of_both(const types::global_dof_index slave) const
  {
    return std::binary_search(masters.begin(), masters.end(), slave);
  }
} // namespace stiction
