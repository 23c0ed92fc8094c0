#ifndef stiction_contact_primal_foundation_h
#define stiction_contact_primal_foundation_h

#include <Eigen/Core>

namespace stiction
{
  class Body;

  /// Springs E_i A_i/L under nodes, L being the diagonal of the bounding box: together
  /// about as stiff as the body, N/m.
  Eigen::VectorXd foundation_under(const Eigen::VectorXd &youngs_moduli,
                                   const Eigen::VectorXd &areas, const Body &body);
} // namespace stiction

#endif
