#ifndef stiction_elasticity_stiffness_element_stiffness_h
#define stiction_elasticity_stiffness_element_stiffness_h

#include <stiction/elasticity/kernels/cell_stiffness.h>

#include <deal.II/lac/full_matrix.h>

namespace stiction
{
  /// The stiffness matrices of single cells, for assembly: 24 × 24, vertex by
  /// vertex, three rows each; 2 × 2 × 2 Gauss points. Unit: N/m.
  class ElementStiffness
  {
  public:
    /// The matrix of a cell; valid until the next call. A cell that is the last
    /// one shifted costs nothing.
    const dealii::FullMatrix<double> &operator()(const HexahedralCell &cell);

  private:
    bool is_translation(const HexahedralCell &cell) const;

    void integrate(const HexahedralCell &cell);

    HexahedralCell last_{};
    bool has_last_ = false;
    dealii::FullMatrix<double> matrix_{24, 24};
  };
} // namespace stiction

#endif
