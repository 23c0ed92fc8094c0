#include <stiction/elasticity/stiffness/general_element_stiffness.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    // Voigt's order of the components of a symmetric tensor.
    constexpr unsigned int n_strains                                             = 6;
    constexpr std::array<std::pair<unsigned int, unsigned int>, n_strains> voigt = {
      {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

    Eigen::Matrix<double, n_strains, n_strains> voigt_matrix(
      const SymmetricTensor<4, 3> &stiffness)
    {
      Eigen::Matrix<double, n_strains, n_strains> C;
      for (unsigned int a = 0; a < n_strains; ++a)
        for (unsigned int b = 0; b < n_strains; ++b)
          C(a, b) =
            stiffness[voigt[a].first][voigt[a].second][voigt[b].first][voigt[b].second];
      return C;
    }
  } // namespace

  GeneralElementStiffness::GeneralElementStiffness(const Mapping<3> &mapping,
                                                   const FiniteElement<3> &fe)
    : values_(std::make_unique<FEValues<3>>(mapping, fe, QGauss<3>(fe.degree + 1),
                                            update_gradients | update_JxW_values))
    , at_nodes_(std::make_unique<FEValues<3>>(
        mapping, fe.base_element(0), fe.base_element(0).get_unit_support_points(),
        update_quadrature_points))
    , strains_(n_strains * values_->n_quadrature_points, fe.n_dofs_per_cell())
    , stresses_(strains_.rows(), strains_.cols())
    , matrix_(fe.n_dofs_per_cell(), fe.n_dofs_per_cell())
  {
  }

  GeneralElementStiffness::~GeneralElementStiffness() = default;

  const FullMatrix<double> &GeneralElementStiffness::operator()(
    const DoFHandler<3>::active_cell_iterator &cell, const CellMaterial &material)
  {
    const std::vector<Point<3>> nodes = places_of_nodes(cell);
    if (!is_translation(nodes, material))
      {
        values_->reinit(cell);
        integrate(material);
      }
    has_last_      = true;
    last_nodes_    = nodes;
    last_material_ = material;
    return matrix_;
  }

  std::vector<Point<3>> GeneralElementStiffness::places_of_nodes(
    const DoFHandler<3>::active_cell_iterator &cell)
  {
    if (values_->get_fe().degree > 1)
      {
        at_nodes_->reinit(cell);
        return at_nodes_->get_quadrature_points();
      }
    std::vector<Point<3>> vertices;
    for (const unsigned int v : cell->vertex_indices())
      vertices.push_back(cell->vertex(v));
    return vertices;
  }

  bool GeneralElementStiffness::is_translation(const std::vector<Point<3>> &nodes,
                                               const CellMaterial &material) const
  {
    if (!has_last_ || material.stiffness != last_material_.stiffness ||
        material.mean_dilatation != last_material_.mean_dilatation)
      return false;
    double size = 0., change = 0.;
    for (unsigned int v = 1; v < nodes.size(); ++v)
      {
        const Tensor<1, 3> edge = nodes[v] - nodes[0];
        size                    = std::max(size, edge.norm());
        change = std::max(change, (edge - (last_nodes_[v] - last_nodes_[0])).norm());
      }
    return change <= 1e-12 * size;
  }

  void GeneralElementStiffness::fill_strains(const unsigned int q)
  {
    const FiniteElement<3> &fe = values_->get_fe();
    for (const unsigned int j : values_->dof_indices())
      {
        const Tensor<1, 3> &gradient = values_->shape_grad(j, q);
        const unsigned int component = fe.system_to_component_index(j).first;
        for (unsigned int a = 0; a < n_strains; ++a)
          {
            const auto [k, l]              = voigt[a];
            strains_(n_strains * q + a, j) = component == k   ? gradient[l]
                                             : component == l ? gradient[k]
                                                              : 0.;
          }
      }
  }

  void GeneralElementStiffness::integrate(const CellMaterial &material)
  {
    const unsigned int n_points = values_->n_quadrature_points;
    double volume               = 0.;
    Eigen::RowVectorXd mean     = Eigen::RowVectorXd::Zero(strains_.cols());
    for (unsigned int q = 0; q < n_points; ++q)
      {
        fill_strains(q);
        mean += values_->JxW(q) * strains_.middleRows<3>(n_strains * q).colwise().sum();
        volume += values_->JxW(q);
      }
    mean /= volume;

    const Eigen::Matrix<double, n_strains, n_strains> C =
      voigt_matrix(material.stiffness);
    for (unsigned int q = 0; q < n_points; ++q)
      {
        auto B = strains_.middleRows<n_strains>(n_strains * q);
        if (material.mean_dilatation)
          {
            const Eigen::RowVectorXd correction =
              (mean - B.topRows<3>().colwise().sum()) / 3.;
            B.topRows<3>().rowwise() += correction;
          }
        stresses_.middleRows<n_strains>(n_strains * q) = values_->JxW(q) * C * B;
      }

    const Eigen::MatrixXd K = strains_.transpose() * stresses_;
    for (unsigned int i = 0; i < matrix_.m(); ++i)
      for (unsigned int j = 0; j < matrix_.n(); ++j)
        matrix_(i, j) = 0.5 * (K(i, j) + K(j, i));
  }
} // namespace stiction
