#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>
#include <stiction/qp/node_status.h>

#include <Eigen/Core>

#include <mpi.h>

#include <string>
#include <vector>

namespace stiction
{
  class Body;
  class Certificate;
  class ContactSurface;

  /// Writes displacement.csv, a row for each node of the body: its place, its
  /// displacement and the force of the supports on it. Nodes come in the order
  /// of the unknowns, which depends on the number of ranks. Collective.
  ///
  /// deal.II holds the fields of .vtu files in single precision; here all 17
  /// digits are.
  ///
  /// Throws InputError if the file cannot be written; so does the other.
  ///
  /// @param tag what the name of the file has behind the word; so in the other.
  void write_nodal_displacement(const std::string &directory, const Body &body,
                                const LA::Vector &u, const LA::Vector &reaction,
                                const std::string &tag);

  /// Writes contact.csv, a row for each contact node: its place, its normal
  /// towards the obstacle, its area and the id of its boundary, the force on
  /// the body and its normal part (compression positive), the slip bound (a
  /// force), the gap, the slip and the two numbers of its NodeStatus.
  /// Collective.
  void write_contact_nodes(const std::string &directory, const ContactSurface &surface,
                           const Certificate &certificate,
                           const std::vector<NodeStatus> &statuses, MPI_Comm communicator,
                           const std::string &tag);

  /// The mean pressure over the faces around each contact node, of the part of the
  /// boundary that it bears for: the normal forces of the contact nodes of these faces
  /// over their areas, counting a node once for each face, Pa. It wavers little where
  /// pressures waver from node to node, as on cells that were cut from tetrahedra.
  /// Collective.
  ///
  /// @param normal_force of each contact node, N.
  Eigen::VectorXd pressure_around(const Body &body, const ContactSurface &surface,
                                  const Eigen::VectorXd &normal_force);
} // namespace stiction
