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

  /// Writes solution.pvtu (with its pieces and solution.pvd): displacement,
  /// stress tensor, von Mises stress. Collective.
  ///
  /// @param error_indicators by active cells, J^½, for another field; none if
  ///   empty.
  void
  write_solution(const std::string &directory,
                 const LinearElasticity &elasticity,
                 const LA::Vector &u,
                 const dealii::Vector<double> &error_indicators);

  /// Removes the index files that an earlier run left of the body, so that they
  /// are not taken for those of this one.
  void
  remove_solution(const std::string &directory, MPI_Comm communicator);

  /// Writes contact.pvtu (with its pieces and contact.pvd): the contact
  /// boundary with pressure, traction on the body, slip, gap, status, area
  /// and slip bound at every contact node. At nodes that are not contact nodes
  /// because their displacement is prescribed, status is −1 and the other
  /// fields are zero. Collective.
  void
  write_contact(const std::string &directory,
                const LinearElasticity &elasticity,
                const ContactSurface &surface,
                const Certificate &certificate);
} // namespace stiction

#endif
