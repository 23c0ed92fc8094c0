#ifndef stiction_elasticity_linear_algebra_h
#define stiction_elasticity_linear_algebra_h

namespace dealii
{
  namespace TrilinosWrappers
  {
    class SparseMatrix;
    namespace MPI
    {
      class Vector;
    }
  } // namespace TrilinosWrappers
} // namespace dealii

namespace stiction
{
  /// The distributed linear algebra, named in this one place: Epetra, which
  /// deal.II 9.4 stands on, will be followed by Tpetra.
  namespace LA
  {
    using Vector       = dealii::TrilinosWrappers::MPI::Vector;
    using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
  } // namespace LA
} // namespace stiction

#endif
