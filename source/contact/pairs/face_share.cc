#include "face_share.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Of the area of a face: what is covered of it carries no dual functions if it is
    // less.
    constexpr double no_cover = 1e-10;

    // The shape functions of a slave face on the part of it that one body covers.
    struct Part
    {
      explicit Part(const Eigen::Index n)
        : products(Eigen::MatrixXd::Zero(n, n))
        , integrals(Eigen::VectorXd::Zero(n))
      {
      }

      Eigen::MatrixXd products;  // ∫ φ φᵀ
      Eigen::VectorXd integrals; // ∫ φ
      Eigen::MatrixXd to_dual;   // ψ = to_dual φ
    };

    Eigen::VectorXd shape_functions(const SurfaceFace &slave, const CoveredPoint &point)
    {
      return Eigen::VectorXd::Map(FaceShape(slave.degree, point.at.first).value.data(),
                                  slave.n_nodes());
    }

    // By the pieces of the mesh that are opposite.
    std::map<unsigned int, Part> parts_of(const SurfaceFace &slave,
                                          const std::vector<CoveredPoint> &points)
    {
      std::map<unsigned int, Part> all, parts;
      for (const CoveredPoint &point : points)
        {
          const Eigen::VectorXd phi = shape_functions(slave, point);
          Part &part = all.try_emplace(point.master->piece, phi.size()).first->second;
          part.products += point.at.weight * phi * phi.transpose();
          part.integrals += point.at.weight * phi;
        }
      for (auto &[piece, part] : all)
        if (part.integrals.sum() >= no_cover * slave.diameter() * slave.diameter())
          {
            part.to_dual =
              part.integrals.asDiagonal() * part.products.fullPivLu().inverse();
            parts.emplace(piece, part);
          }
      return parts;
    }
  } // namespace

  std::vector<FaceShare> shares_of(const SurfaceFace &slave,
                                   const std::vector<CoveredPoint> &points)
  {
    const Eigen::Index n = slave.n_nodes();
    const auto parts     = parts_of(slave, points);
    if (parts.empty())
      return {};
    Eigen::VectorXd d = Eigen::VectorXd::Zero(n), gap = d;
    for (const auto &[piece, part] : parts)
      d += part.integrals;
    Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(n, 3);
    double smallest = std::numeric_limits<double>::max(), largest = -smallest,
           modulus = 0., cover = 0.;
    std::map<types::global_dof_index, Eigen::MatrixX2d> M; // and the overlaps
    for (const CoveredPoint &point : points)
      {
        smallest        = std::min(smallest, point.at.gap);
        largest         = std::max(largest, point.at.gap);
        const auto part = parts.find(point.master->piece);
        if (point.at.weight == 0. || part == parts.end())
          continue;
        const FaceShape other(point.master->degree, point.at.second);
        const Eigen::VectorXd phi = shape_functions(slave, point);
        const Eigen::VectorXd psi = point.at.weight * part->second.to_dual * phi;
        const Tensor<1, 3> normal = point.master->normal();
        gap += point.at.gap * psi;
        normals += point.at.weight * phi.cwiseAbs() *
                   Eigen::RowVector3d(normal[0], normal[1], normal[2]);
        modulus = std::max(modulus, point.master->youngs_modulus);
        cover += point.at.part;
        for (unsigned int j = 0; j < point.master->n_nodes(); ++j)
          {
            auto &columns =
              M.try_emplace(point.master->dofs[j], Eigen::MatrixX2d::Zero(n, 2))
                .first->second;
            columns.col(0) += other.value[j] * psi;
            columns.col(1) += point.at.weight * std::abs(other.value[j]) * phi.cwiseAbs();
          }
      }

    std::vector<FaceShare> shares;
    for (Eigen::Index i = 0; i < n; ++i)
      {
        FaceShare share{slave.dofs[i],
                        numbers::invalid_dof_index,
                        d(i),
                        0.,
                        gap(i),
                        modulus,
                        smallest,
                        largest,
                        slave.diameter(),
                        cover,
                        {{normals(i, 0), normals(i, 1), normals(i, 2)}}};
        shares.push_back(share);
        for (const auto &[master, columns] : M)
          {
            share.master  = master;
            share.value   = columns(i, 0);
            share.overlap = columns(i, 1);
            shares.push_back(share);
          }
      }
    return shares;
  }
} // namespace stiction
