#pragma once

namespace dealii
{
  namespace MemorySpace
  {
    struct Host;
  }
  namespace LinearAlgebra
  {
    namespace distributed
    {
      template<typename Number, typename MemorySpace> class Vector;
    }
  } // namespace LinearAlgebra
  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace stiction
{
  /// The distributed linear algebra, named in this one place. Vectors are
  /// deal.II's own, which serve assembled matrices and matrix-free products
  /// alike; matrices are Epetra, which deal.II 9.4 stands on and Tpetra will
  /// follow.
  namespace LA
  {
    template<typename Number>
    using VectorOf =
      dealii::LinearAlgebra::distributed::Vector<Number, dealii::MemorySpace::Host>;

    using Vector       = VectorOf<double>;
    using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
  } // namespace LA
} // namespace stiction
