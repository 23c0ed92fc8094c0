#pragma once

#include <stiction/contact/interface/contact_surface.h>

#include <deal.II/base/types.h>

#include <Eigen/SparseCore>

#include <array>
#include <map>
#include <tuple>
#include <vector>

namespace stiction
{
  class Body;

  /// Of nodes whose forces act elsewhere those of the same boundary that are on a face
  /// with them: (i, j, weight) for node i of @p of and j of @p among, weights ∫|φ_i φ_j|
  /// over the boundary, those of an i that has such nodes divided by their sum. Both
  /// lists are known to all ranks. Collective.
  std::vector<Eigen::Triplet<double>> neighbours_on_boundary(
    const LinearElasticity &elasticity, const std::vector<ContactBoundary> &boundaries,
    const SmoothParts &parts, const std::vector<ContactNode> &of,
    const std::vector<ContactNode> &among);

  /// The nodes of the contact boundaries with what their faces and cells say of
  /// them: normal, area, modulus, and where they are prescribed. Hanging nodes hand
  /// their shares on to those that they hang on.
  class NodeShares
  {
  public:
    /// Adds up the faces of all ranks. Collective.
    NodeShares(const LinearElasticity &elasticity,
               const std::vector<ContactBoundary> &boundaries, const SmoothParts &parts);

    /// The area of all contact boundaries, m².
    double boundary_area() const { return boundary_area_; }

    /// In an order that does not depend on the number of ranks; without tangents yet. A
    /// node of several boundaries, or of several parts of one, is there once for each.
    /// Collective.
    std::vector<ContactNode> nodes() const;

  private:
    // What a rank knows of a node, or all ranks together.
    enum : unsigned int
    {
      first_dof,
      boundary,
      part,
      prescribed, // components, as bits
      modulus,    // Young's, the largest
      area,
      normal,                // × area
      position = normal + 3, // from the owner of the node, as is its piece
      piece    = position + 3,
      n_data   = piece + 1
    };
    using Share = std::array<double, n_data>;

    void add_faces();
    void add_with_prescribed(dealii::types::global_dof_index dof, double weight,
                             Share share);
    void add(dealii::types::global_dof_index dof, double weight, const Share &share);
    void exchange();

    /// The shares with the positions and pieces of their nodes. Collective.
    std::vector<Share> with_places() const;

    const LinearElasticity &elasticity_;
    const Body &body_;
    const std::vector<ContactBoundary> &boundaries_;
    const SmoothParts &parts_;
    /// By the first unknown of a node, a boundary, tied ones first, and a part of it.
    std::map<std::tuple<dealii::types::global_dof_index, double, double>, Share> shares_;
    double boundary_area_ = 0.;
  };
} // namespace stiction
