#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <Eigen/Core>

#include <mpi.h>

#include <string>
#include <vector>

namespace dealii
{
  template<typename Number> class Vector;
}

namespace stiction
{
  class Certificate;
  class ContactSurface;
  class LinearElasticity;
  struct NodeStatus;
  struct OutputParameters;
  struct State;

  /// Writes solution.pvtu (with its pieces and solution.pvd): displacement,
  /// stress and von Mises stress, and with 'Output/Fields = all' strain,
  /// principal stresses (the largest first), the stress averaged at nodes over
  /// the cells of the same material, the reactions of the supports, material
  /// and body. Strain and stress are those of the formulation: with 'Volume
  /// strain = cell mean' their volume part is the cell's mean. Collective.
  ///
  /// @param reaction nodal forces of the supports on the body.
  /// @param error_indicators by active cells, J^½, for another field; none if
  ///   empty.
  /// @param tag what the names of the files have behind the word, "_0001"; so in the
  ///   other functions. With one the .pvd is left to StepHistory.
  void write_solution(const LinearElasticity &elasticity, const LA::Vector &u,
                      const LA::Vector &reaction,
                      const dealii::Vector<double> &error_indicators,
                      const OutputParameters &parameters, const std::string &tag);

  /// Writes contact.pvtu (with its pieces and contact.pvd): the contact
  /// boundary with pressure, traction on the body and its tangential part,
  /// slip, gap, normal and tangential status, area, slip bound, displacement
  /// and the normal towards the obstacle at every contact node. At nodes that
  /// are not contact nodes because their displacement is prescribed, or because
  /// they face away from the obstacle, both statuses are −1 and the other
  /// fields but the displacement are zero. Collective.
  ///
  /// @param slip_path SlipHistory::path for another field; none if empty.
  void write_contact(const LinearElasticity &elasticity, const LA::Vector &u,
                     const ContactSurface &surface, const Certificate &certificate,
                     const std::vector<NodeStatus> &statuses,
                     const OutputParameters &parameters, const std::string &tag,
                     const Eigen::VectorXd &slip_path);

  /// Writes obstacle.vtu, one file from rank 0: the surfaces of the obstacles
  /// near the contact boundaries where they are now, with the id of the contact
  /// boundary as cell data 'boundary'. The foundation is the contact boundary
  /// moved by its initial gap; of other obstacles it is the zero set of their
  /// distance in a box around the contact boundary, or their own triangles.
  /// Vertices lie on the surface, faces between them are plane. Collective.
  void write_obstacles(const std::string &directory, const LinearElasticity &elasticity,
                       const ContactSurface &surface, const State &state,
                       const std::string &tag);
} // namespace stiction
