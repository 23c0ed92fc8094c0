#pragma once

namespace dealii::MemorySpace
{
  struct Host;
}
namespace dealii::LinearAlgebra::distributed
{
  template<typename Number, typename MemorySpace> class Vector;
}
namespace dealii::TrilinosWrappers
{
  class SparseMatrix;
}

/// The distributed linear algebra, named in this one place. Vectors are
/// deal.II's own, which serve assembled matrices and matrix-free products
/// alike; matrices are Epetra, which deal.II 9.4 stands on and Tpetra will
/// follow.
namespace stiction::LA
{
  template<typename Number>
  using VectorOf =
    dealii::LinearAlgebra::distributed::Vector<Number, dealii::MemorySpace::Host>;

  using Vector       = VectorOf<double>;
  using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
} // namespace stiction::LA
