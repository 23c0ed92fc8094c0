#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <memory>
#include <string>

namespace stiction
{
  struct TriangulatedSurface;

  /// A rigid obstacle, as a function ψ that is positive outside of it: its
  /// signed distance, or anything else with the same zero set and sign. Near
  /// the obstacle ψ/‖∇ψ‖ is the distance to first order.
  class Obstacle
  {
  public:
    /// ψ at a point, and its gradient, which points away from the obstacle.
    struct Value
    {
      double psi = 0.;
      dealii::Tensor<1, 3> gradient;
    };

    virtual ~Obstacle() = default;

    /// ψ and ∇ψ. The gradient may be zero where it has no direction, as at the
    /// centre of a sphere.
    virtual Value at(const dealii::Point<3> &p) const = 0;

    /// The same for a body with this outward normal: where an edge or a corner of the
    /// obstacle touches it, or two of its sides are as near, the gradient of the many
    /// there that is most opposite to the normal.
    virtual Value facing(const dealii::Point<3> &p, const dealii::Tensor<1, 3> &) const
    {
      return at(p);
    }

    /// Its surface, if it is given as triangles; nullptr otherwise.
    virtual const TriangulatedSurface *triangles() const { return nullptr; }

    /// Reads what a user says of an obstacle, 'plane : 0; 0; -1; 0; 0; 1' and
    /// the like; see the help of 'Boundary conditions/Obstacle'. Collective.
    ///
    /// @param location the beginning of a sentence about the entry, see
    ///   ParameterFile::locate().
    /// @param size that of the body, m: formulas are differentiated by steps
    ///   of a small part of it.
    /// @param time the value of t in formulas.
    /// @return nothing for 'foundation', which is no body in space.
    ///
    /// Throws InputError if the text or the file it names cannot be used.
    static std::unique_ptr<Obstacle> read(const std::string &text,
                                          const std::string &location, double size,
                                          double time, MPI_Comm communicator);
  };
} // namespace stiction
