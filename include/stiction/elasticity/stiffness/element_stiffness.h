#pragma once

#include <stiction/elasticity/kernels/cell_stiffness.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/full_matrix.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace dealii
{
  template<int dim, int spacedim> class FEValues;
  template<int dim, int spacedim> class Mapping;
} // namespace dealii

namespace stiction
{
  class Materials;
  class MeshLevel;

  /// The stiffness matrices of single cells of any material, ∫ ε(φ_i) : C : ε(φ_j),
  /// node by node, three rows each, by Gauss points. Unit: N/m. Materials are told apart
  /// by their addresses.
  class ElementStiffness
  {
  public:
    /// For trilinear cells alone.
    ElementStiffness();

    /// @param mapping of hexahedra, of at most the degree of the element. Both
    ///   arguments must outlive the object.
    ElementStiffness(const dealii::Mapping<3, 3> &mapping,
                     const dealii::FiniteElement<3> &fe);
    ~ElementStiffness();

    /// The matrix of a trilinear cell, 24 × 24, in the cell's unit; valid until the
    /// next call. A cell that is the last one shifted costs nothing.
    const dealii::FullMatrix<double> &operator()(const HexahedralCell &cell);

    /// That of a cell of the element, in the order of its unknowns.
    const dealii::FullMatrix<double> &operator()(
      const dealii::DoFHandler<3>::active_cell_iterator &cell, const Material &material);

  private:
    /// Whether the cell is the last one shifted, by its nodes; from now on it is the
    /// last one.
    bool is_translation(const Eigen::Matrix3Xd &nodes, const Material &material,
                        double unit);

    void integrate(const Material &material, double unit);

    std::unique_ptr<dealii::FEValues<3, 3>> values_;
    Eigen::Matrix3Xd last_nodes_; // vertices, or Gauss points
    const Material *last_material_ = nullptr;
    double last_unit_              = 0.;
    Eigen::MatrixXd gradients_; // a column a Gauss point, three rows a function
    Eigen::VectorXd weights_;   // the volumes that Gauss points stand for
    Eigen::MatrixXd products_;
    dealii::FullMatrix<double> matrix_;
  };

  /// Calls back with the nodes of every cell that this rank owns, by their local
  /// numbers, and its stiffness matrix, node by node; valid during the call. Trilinear
  /// cells come in the order of MeshLevel::for_each_cell().
  ///
  /// @param unit of the matrix, in N/m. @param is_wanted by the nodes of a cell; empty:
  ///   each is.
  void for_each_element(
    const MeshLevel &level, const Materials &materials, double unit,
    const std::function<void(const std::vector<unsigned int> &nodes,
                             const dealii::FullMatrix<double> &K)> &callback,
    const std::function<bool(const std::vector<unsigned int> &nodes)> &is_wanted = {});
} // namespace stiction
