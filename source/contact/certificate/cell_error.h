#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/dofs/dof_handler.h>

#include <Eigen/Core>

#include <memory>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  struct State;

  /// The estimated error of one cell after another, see estimate_error().
  class CellError
  {
  public:
    /// Collective. What is given, but for the state, must outlive the object.
    static std::unique_ptr<CellError> create(const LinearElasticity &elasticity,
                                             const ContactSurface &surface,
                                             const State &state);

    virtual ~CellError() = default;

    /// η_K² of a cell that this rank owns, J. Throws InputError where a formula
    /// has no finite value, or an obstacle no normal.
    virtual double square(const dealii::DoFHandler<3>::active_cell_iterator &cell) = 0;

    /// u with what the own cells and their neighbours need of it.
    virtual const LA::Vector &displacement() const = 0;
  };
} // namespace stiction
