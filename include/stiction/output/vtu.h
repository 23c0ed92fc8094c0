#ifndef stiction_output_vtu_h
#define stiction_output_vtu_h

#include <stiction/elasticity/linear_algebra.h>

#include <mpi.h>

#include <string>

namespace dealii
{
  template<typename Number>
  class Vector;
}

namespace stiction
{
  class Certificate;
  class ContactSurface;
  class LinearElasticity;
  struct OutputParameters;

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
  void
  write_solution(const LinearElasticity &elasticity,
                 const LA::Vector &u,
                 const LA::Vector &reaction,
                 const dealii::Vector<double> &error_indicators,
                 const OutputParameters &parameters);

  /// Removes the index files that an earlier run left of the body, so that they
  /// are not taken for those of this one.
  void
  remove_solution(const std::string &directory, MPI_Comm communicator);

  /// Writes contact.pvtu (with its pieces and contact.pvd): the contact
  /// boundary with pressure, traction on the body and its tangential part,
  /// slip, gap, status, area, slip bound, displacement and the normal towards
  /// the obstacle at every contact node. At nodes that are not contact nodes
  /// because their displacement is prescribed, or because they face away from
  /// the obstacle, status is −1 and the other fields but the displacement are
  /// zero. Collective.
  void
  write_contact(const LinearElasticity &elasticity,
                const LA::Vector &u,
                const ContactSurface &surface,
                const Certificate &certificate,
                const OutputParameters &parameters);
} // namespace stiction

#endif
