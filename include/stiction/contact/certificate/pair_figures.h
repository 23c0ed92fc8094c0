#pragma once

#include <deal.II/base/tensor.h>

#include <limits>
#include <vector>

namespace stiction
{
  class ContactBoundary;
  class ContactSurface;
  class LinearElasticity;
  struct State;

  /// What tells of a pair how far an answer is to be trusted that is right on its mesh.
  struct PairFigures
  {
    /// Of the normal force, at nodes beyond the edge of what lies opposite.
    double share_beyond_edge = 0.;
    /// The largest pressure there, over the largest of the other nodes, at least 1.
    double peak_beyond_edge = 1.;

    /// How far a pressed node is at most from where it was on the other side, along the
    /// surface, and the mean distance of these nodes, m.
    double way = 0., spacing = 1.;

    /// How many cells, those of the side with the larger ones there, what is pressed is
    /// wide where it ends within a surface: √12 times the standard deviation of places
    /// along a principal axis, which is the width of a strip.
    double cells_across = std::numeric_limits<double>::max();

    /// Friction across the gap in which the meshes are made has a moment
    /// Σ g_i n_i × λ_i that bodies which touch do not have: the mean of g weighted with
    /// friction, m, and that moment over those of all forces about its axis through the
    /// centre of pressure, Σ |e · ((x_i − c) × λ_i)|, each at least a hundredth of the
    /// force times its arm.
    double gap = 0., moment_across_gap = 0.;

    /// How much of the normal force is across the normals of the other side where a body
    /// stands on an edge, |Σ_r λ_i (n_i + m_i)| / Σ λ_i with the nodes r at the rim and
    /// the normals m_i opposite.
    double tilt = 0.;

    /// How far one of several bodies opposite comes towards a pressed node that lies over
    /// their joint, beyond the mean of them that the node follows, at most, m.
    double joint = 0.;

    /// By how much the distances of the meshes at pressed nodes, less their gaps, differ,
    /// over what facets of surfaces that fit make them differ by.
    double misfit = 0.;

    /// The pressure that presses facets of elements of degree 1 flat, over the largest
    /// one: that of a wave of the depth θh/8 and the length h between half-spaces, πθ /
    /// (16 (1/E₁ + 1/E₂)) with the mean angles θ to next faces that are inclined, summed
    /// over both sides (Johnson, Contact Mechanics, 13.2). 0 on meshes that match, and
    /// where next to no nodes bear.
    double facet_pressure = 0.;

    /// The energy from facets, J, see climbed_facets().
    double climbed = 0.;

    /// How much of the tractions p the other side does not feel, since they change sign
    /// from node to node, Σ A_i |p_i − q_i| / Σ A_i |p_i|, where q are means with the
    /// weights W of tractions opposite, which are means of p. Below 1/3 where pressures
    /// are smooth.
    double wavering = 0.;

    /// How far that leaves pressures undetermined, 2 (1/E of the other side) / (sum of
    /// both sides), at most 1, with means over the boundaries: a side that is far softer
    /// determines them itself, as on a rigid wall.
    double stiffness_in_wavering = 1.;
  };

  /// Of a contact boundary that is a pair; of one that is tied only how tractions waver.
  /// Collective.
  ///
  /// @param force_scale that of the problem, N: a pair that bears next to nothing of it
  ///   has no figures.
  PairFigures pair_figures(const LinearElasticity &elasticity,
                           const ContactSurface &surface, const ContactBoundary &pair,
                           const State &state, double force_scale);

  /// The forces that each of the boundaries opposite exerts on the body of a pair, N. A
  /// node on an edge between two of them counts to the first. Collective.
  std::vector<dealii::Tensor<1, 3>> forces_of_partners(const LinearElasticity &elasticity,
                                                       const ContactSurface &surface,
                                                       const ContactBoundary &pair,
                                                       const State &state);
} // namespace stiction
