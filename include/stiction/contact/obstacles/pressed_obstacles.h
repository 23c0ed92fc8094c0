#ifndef stiction_contact_obstacles_pressed_obstacles_h
#define stiction_contact_obstacles_pressed_obstacles_h

#include <stiction/contact/obstacles/force_control.h>

#include <Eigen/Core>

namespace stiction
{
  class ObstacleMotion;

  /// A direction presses on a contact node if its cosine with −n is above this
  /// one.
  constexpr double least_approach = 0.1;

  /// Where to search for the places of the pressed obstacles. They begin where
  /// E √(A/2π) δ is the force, A being the area that would be cut off by an
  /// obstacle δ beyond the place of first contact: half of it would be in
  /// contact (Hertz), and a flat punch has that stiffness.
  ///
  /// @param areas of the contact nodes, m².
  /// @param forces prescribed, N.
  /// @param youngs_modulus, body_size Pa, m.
  ForceControl::Range range_of_search(const ObstacleMotion &motion,
                                      const Eigen::VectorXd &areas,
                                      const Eigen::VectorXd &forces,
                                      double youngs_modulus, double body_size);

  /// What pressed obstacles do in a solution of the contact problem.
  ///
  /// @param directions C of ObstacleMotion, 3m × n.
  /// @param lambda, gradient contact forces and r = (remaining gap; −slip).
  /// @param force_scale S.
  ForceControl::Outcome outcome_of(const Eigen::MatrixXd &directions,
                                   const Eigen::VectorXd &lambda,
                                   const Eigen::VectorXd &gradient, double force_scale);
} // namespace stiction

#endif
