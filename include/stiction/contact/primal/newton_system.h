#pragma once

#include <stiction/contact/primal/contact_state.h>
#include <stiction/contact/primal/primal_active_set.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <functional>
#include <memory>
#include <vector>

namespace stiction
{
  class ContactLevel;
  class Multigrid;

  /// The linear system of a linearised contact problem in displacements,
  /// (W K P + S) d = W R − S w − c at the contact nodes and K d = R elsewhere,
  /// and its inexact solution by generalised conjugate residuals with a
  /// multigrid preconditioner for the symmetric part P K P + S.
  ///
  /// The distances δ of pressed obstacles are unknowns, too. A node that is held
  /// at its obstacle moves with it, and the row of an obstacle is P + Cᵀλ = 0, λ
  /// being the reaction in directions that are held and what the contact rows
  /// ask for in the others. The first directions of the method move one
  /// obstacle each, with what the body does about it by the preconditioner: block
  /// elimination, which the iterations after it complete.
  ///
  /// Motions that hardly anything resists (ContactLevel::loose_motions()) are lost in a
  /// preconditioner, above all in single precision, and a residual that is minimised does
  /// not grow first so that they move. Near the end they are kept apart by deflation
  /// (R. A. Nicolaides, Deflation of conjugate gradients with applications to boundary
  /// value problems, 1987): forces do no work along them, at the start and after each
  /// iteration, and what they do against normals that differ is left to these.
  ///
  /// The method minimises the residual like GMRES, and has the residual, the
  /// contact forces and the slip at hand after every iteration: the caller
  /// stops it as soon as another linearisation is worth more. After that the
  /// state is updated without another product.
  class NewtonSystem
  {
  public:
    /// @param level the number of the problem's level for the preconditioner.
    ///   All arguments must outlive the object.
    /// @param factorizes whether it asks for factors where systems are hard.
    NewtonSystem(const ContactLevel &problem, unsigned int level,
                 Multigrid &preconditioner, bool factorizes = true);

    /// The iterations that solve() takes at most beside those that move obstacles: their
    /// directions are kept, 12 bytes an unknown each, 20 with factors. 20 iterations on a
    /// small level, whose factors are cheaper than more of them, else 40: with 20, bodies
    /// of cut tetrahedra of degree 2 on one another need twice the steps.
    unsigned int max_directions() const;

    /// What is known after an iteration.
    struct Progress
    {
      unsigned int iterations;
      /// Of the linear system: the sum of its norms at the nodes, N.
      double residual;
      const Eigen::VectorXd &contact_residual; ///< its part at contact nodes
      const Eigen::VectorXd &lambda, &w;       ///< of the displacement so far
      double reduction; ///< Euclidean norm over the one at the start
    };

    /// Takes the step of the linearisation as far as the caller wants. One
    /// product with K and one cycle of the preconditioner an iteration, and one
    /// product at the start. Collective.
    ///
    /// @param stop asked after each iteration.
    /// @param is_near whether contact states are about right, so that steps along motions
    ///   that hardly anything resists go where they should: they are deflated then.
    /// @return the number of iterations.
    unsigned int solve(ContactState &state, const PrimalActiveSet &linearization,
                       const std::function<bool(const Progress &)> &stop,
                       bool is_near = false);

    /// So many systems left unfinished, or in one of them so many preconditioned vectors
    /// that are less near than they are meant to, and the next are factorised.
    static constexpr unsigned int max_unfinished = 3;

    /// How many systems were left at max_directions(). After a few of them the
    /// preconditioner is asked to factorise the level; if it does, this is zero
    /// again.
    unsigned int n_unfinished() const { return n_unfinished_; }

    /// Whether the last system was.
    bool left_unfinished() const { return left_unfinished_; }

    /// Whether that was done.
    bool is_factorized() const { return is_factorized_; }

    /// Whether all systems so far were solved without that.
    bool is_easy() const { return !is_factorized_ && n_unfinished_ == 0; }

    /// Whether it would ask, but is not to.
    bool is_too_hard() const { return is_too_hard_; }

  private:
    /// What an iteration adds: A d = v for the direction d, which is known as
    /// preconditioned vectors z and coefficients, and at the contact nodes. The
    /// v are orthogonal to each other.
    struct Direction
    {
      LA::VectorOf<float> z;
      double factor = 1.;    ///< of z
      LA::Vector solution;   ///< in place of z where systems are factorised
      bool is_exact = false; ///< whether it is
      LA::Vector v;
      double square = 0.;           ///< v·v
      Eigen::VectorXd distances;    ///< of the obstacles, beside z
      Eigen::VectorXd displacement; ///< B d − C δ
      Eigen::VectorXd force;        ///< of K d, as contact_forces()
      Eigen::VectorXd contact_rows; ///< of v
      Eigen::VectorXd obstacle_rows;
      std::vector<double> reaction; ///< K d at prescribed unknowns
      Eigen::VectorXd loose; ///< of loose motions taken away, before orthogonalize()

      /// All but the long vectors -= h times the other's.
      void subtract(double h, const Direction &other);
    };

    Direction &new_direction(unsigned int n);

    /// Whether systems are factorised from the next one on, or are too hard.
    bool turns_to_factors();

    /// Makes @p sign times the preconditioned v the vector of d. A factorisation is
    /// worth double precision: a body that moves as a whole by far more than it is
    /// strained is lost in single precision.
    void precondition(Direction &d, const LA::Vector &v, double sign);

    /// Sets what d is mapped to, from its z and distances.
    void apply(const PrimalActiveSet &linearization, Direction &d);

    /// Makes d the move of a pressed obstacle by a unit, and z what the
    /// preconditioner makes of the forces that this takes.
    void move_obstacle(const PrimalActiveSet &linearization, Eigen::Index obstacle,
                       Direction &d);

    /// Makes directions of the loose motions, with nodes that are held left in place, and
    /// factorises the stiffness that they have.
    void take_loose_motions(const PrimalActiveSet &linearization);

    /// Of forces along the loose motions.
    Eigen::VectorXd work_of_loose_motions(const LA::Vector &v) const;

    /// The amounts of the loose motions that take away this work; of size 0 if there are
    /// none.
    Eigen::VectorXd loose_part(const LA::Vector &v) const;

    /// Takes the loose motions away from d and from what it is mapped to, so that this
    /// does no work along them.
    void deflate(Direction &d) const;

    /// Makes what direction n is mapped to orthogonal to those before it, and enters
    /// their parts of it into column n of H.
    ///
    /// @return its product with the residual. @param obstacle_r the part of that at
    ///   the obstacles.
    double orthogonalize(unsigned int n, Eigen::MatrixXd &H,
                         const Eigen::VectorXd &obstacle_r);

    /// Pressed obstacles that some node is held at or has a spring to.
    std::vector<Eigen::Index> felt_obstacles(const PrimalActiveSet &linearization) const;

    /// u += Σ y_j z_j, and the obstacles with what is held at them.
    void add_all(ContactState &state, const PrimalActiveSet &linearization,
                 const Eigen::VectorXd &y) const;

    /// How nodes move that are held at obstacles which move by δ, length 3m.
    Eigen::VectorXd held_displacement(const PrimalActiveSet &linearization,
                                      const Eigen::VectorXd &distances) const;

    /// Of a displacement of the nodes, length 3m, what is held.
    static Eigen::VectorXd held_part(const PrimalActiveSet &linearization,
                                     const Eigen::VectorXd &moved);

    void set_supports(const PrimalActiveSet &linearization);

    /// W y + S w at the contact nodes.
    Eigen::VectorXd contact_rows(const PrimalActiveSet &linearization,
                                 const Eigen::VectorXd &force,
                                 const Eigen::VectorXd &displacement) const;

    const ContactLevel &problem_;
    const unsigned int level_;
    Multigrid &preconditioner_;
    const bool factorizes_;
    std::vector<std::unique_ptr<Direction>> directions_; ///< kept for reuse
    std::vector<std::unique_ptr<Direction>> loose_;      ///< of one system
    Eigen::PartialPivLU<Eigen::MatrixXd> loose_stiffness_;
    LA::Vector residual_, step_; ///< scratch
    unsigned int n_unfinished_ = 0;
    bool is_factorized_ = false, is_too_hard_ = false, left_unfinished_ = false;
  };
} // namespace stiction
