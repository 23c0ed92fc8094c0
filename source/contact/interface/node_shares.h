#pragma once

#include <stiction/contact/interface/contact_surface.h>

#include <deal.II/base/types.h>

#include <array>
#include <map>
#include <vector>

namespace stiction
{
  class Body;

  /// The nodes of the contact boundaries with what their faces and cells say of
  /// them: normal, area, modulus, and where they are prescribed. Nodes that are
  /// prescribed in all directions are left out; hanging nodes hand their shares
  /// on to those that they hang on.
  class NodeShares
  {
  public:
    /// Adds up the faces of all ranks. Collective.
    NodeShares(const LinearElasticity &elasticity,
               const std::vector<ContactBoundary> &boundaries);

    /// The area of all contact boundaries, m².
    double boundary_area() const { return boundary_area_; }

    /// In an order that does not depend on the number of ranks; without tangents yet. A
    /// node of several boundaries is there once for each. Collective.
    std::vector<ContactNode> nodes() const;

  private:
    // What a rank knows of a node, or all ranks together.
    enum : unsigned int
    {
      first_dof,
      boundary,
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
    /// By the first unknown of a node and a boundary, tied ones first.
    std::map<std::pair<dealii::types::global_dof_index, double>, Share> shares_;
    double boundary_area_ = 0.;
  };
} // namespace stiction
