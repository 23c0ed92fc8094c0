#ifndef stiction_elasticity_stiffness_general_element_stiffness_h
#define stiction_elasticity_stiffness_general_element_stiffness_h

#include <stiction/elasticity/stiffness/cell_material.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/full_matrix.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace dealii
{
  template<int dim, int spacedim>
  class FEValues;
  template<int dim, int spacedim>
  class Mapping;
} // namespace dealii

namespace stiction
{
  /// The stiffness matrices of single cells of any displacement element and any
  /// linear elastic material, ∫ ε(φ_i) : C : ε(φ_j), by Gauss points. Unit:
  /// N/m.
  class GeneralElementStiffness
  {
  public:
    /// @param mapping of hexahedra, of at most the degree of the element. Both
    ///   arguments must outlive the object.
    GeneralElementStiffness(const dealii::Mapping<3, 3> &mapping,
                            const dealii::FiniteElement<3> &fe);
    ~GeneralElementStiffness();

    /// The matrix of a cell, in the order of the cell's unknowns; valid until
    /// the next call. A cell that is the last one shifted costs nothing.
    const dealii::FullMatrix<double> &operator()(
      const dealii::DoFHandler<3>::active_cell_iterator &cell,
      const CellMaterial &material);

  private:
    std::vector<dealii::Point<3>> places_of_nodes(
      const dealii::DoFHandler<3>::active_cell_iterator &cell);

    /// Whether it is the last cell shifted, by its nodes.
    bool is_translation(const std::vector<dealii::Point<3>> &nodes,
                        const CellMaterial &material) const;

    void integrate(const CellMaterial &material);

    /// The rows of B at one quadrature point: the strains εxx, εyy, εzz, 2εyz,
    /// 2εxz, 2εxy of all shape functions.
    void fill_strains(unsigned int q);

    std::unique_ptr<dealii::FEValues<3, 3>> values_;
    std::unique_ptr<dealii::FEValues<3, 3>> at_nodes_;
    bool has_last_ = false;
    std::vector<dealii::Point<3>> last_nodes_;
    CellMaterial last_material_;
    Eigen::MatrixXd strains_, stresses_; ///< six rows a quadrature point
    dealii::FullMatrix<double> matrix_;
  };
} // namespace stiction

#endif
