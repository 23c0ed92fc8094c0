#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/mesh/mesh_level.h>
#include <stiction/elasticity/model/materials.h>
#include <stiction/elasticity/stiffness/cell_dilatation.h>
#include <stiction/elasticity/stiffness/element_stiffness.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <utility>

namespace stiction
{
  using namespace dealii;

  namespace
  {
    using Gradients8 = Eigen::Matrix<double, 8, 3>;

    // The gradients of the trilinear functions on the unit cube at Gauss point
    // q.
    Gradients8 reference_gradients(const unsigned int q)
    {
      const double half_distance = 0.5 / std::sqrt(3.);
      Gradients8 gradients;
      for (unsigned int v = 0; v < 8; ++v)
        for (unsigned int d = 0; d < 3; ++d)
          {
            gradients(v, d) = 1.;
            for (unsigned int e = 0; e < 3; ++e)
              {
                const bool is_far = (v >> e & 1) != 0;
                const double x =
                  0.5 + ((q >> e & 1) != 0 ? half_distance : -half_distance);
                gradients(v, d) *= e == d ? (is_far ? 1. : -1.) : (is_far ? x : 1. - x);
              }
          }
      return gradients;
    }

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

    // The rows of B at one Gauss point: the strains εxx, εyy, εzz, 2εyz, 2εxz, 2εxy of
    // all unknowns, from the gradients of all functions.
    Eigen::MatrixXd strains(const Eigen::Ref<const Eigen::VectorXd> &gradients)
    {
      Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n_strains, gradients.size());
      for (unsigned int a = 0; a < n_strains; ++a)
        for (Eigen::Index i = 0; i < gradients.size(); i += 3)
          {
            const auto [k, l] = voigt[a];
            B(a, i + k)       = gradients(i + l);
            B(a, i + l)       = gradients(i + k);
          }
      return B;
    }

    // a(φ_i e_a, φ_j e_b) = ∫ λ ∂aφ_i ∂bφ_j + G (∂bφ_i ∂aφ_j + δ_ab ∇φ_i·∇φ_j)
    //
    // products: of all first derivatives, 3 × 3 for two nodes, integrated.
    void isotropic_stiffness(const Eigen::MatrixXd &products, const double lame_lambda,
                             const double shear_modulus, FullMatrix<double> &K)
    {
      for (unsigned int i = 0; i < K.m() / 3; ++i)
        for (unsigned int j = 0; j < K.m() / 3; ++j)
          {
            const Eigen::Matrix3d product = products.block<3, 3>(3 * i, 3 * j);
            const Eigen::Matrix3d block =
              lame_lambda * product +
              shear_modulus *
                (product.transpose() + product.trace() * Eigen::Matrix3d::Identity());
            for (unsigned int a = 0; a < 3; ++a)
              for (unsigned int b = 0; b < 3; ++b)
                K(3 * i + a, 3 * j + b) = block(a, b);
          }
    }
  } // namespace

  ElementStiffness::ElementStiffness() = default;

  ElementStiffness::ElementStiffness(const Mapping<3> &mapping,
                                     const FiniteElement<3> &fe)
    : values_(std::make_unique<FEValues<3>>(
        mapping, fe.base_element(0), QGauss<3>(fe.degree + 1),
        update_gradients | update_JxW_values | update_quadrature_points))
  {
  }

  ElementStiffness::~ElementStiffness() = default;

  const FullMatrix<double> &ElementStiffness::operator()(const HexahedralCell &cell)
  {
    static const std::array<Gradients8, 8> reference = []() {
      std::array<Gradients8, 8> all;
      for (unsigned int q = 0; q < 8; ++q)
        all[q] = reference_gradients(q);
      return all;
    }();

    Eigen::Matrix<double, 3, 8> vertices;
    for (unsigned int v = 0; v < 8; ++v)
      vertices.col(v) = Eigen::Map<const Eigen::Vector3d>(cell.vertices[v].data());
    if (is_translation(vertices, *cell.material, cell.unit))
      return matrix_;
    gradients_.resize(24, 8);
    weights_.resize(8);
    for (unsigned int q = 0; q < 8; ++q)
      {
        const Eigen::Matrix3d jacobian = vertices * reference[q];
        Eigen::Map<Eigen::Matrix<double, 3, 8>>(gradients_.col(q).data()) =
          (reference[q] * jacobian.inverse()).transpose();
        weights_(q) = jacobian.determinant() / 8.;
      }
    integrate(*cell.material, cell.unit);
    return matrix_;
  }

  const FullMatrix<double> &ElementStiffness::operator()(
    const DoFHandler<3>::active_cell_iterator &cell, const Material &material)
  {
    values_->reinit(static_cast<Triangulation<3>::active_cell_iterator>(cell));
    // the Gauss points say where all nodes are
    Eigen::Matrix3Xd points(3, values_->n_quadrature_points);
    for (const unsigned int q : values_->quadrature_point_indices())
      for (unsigned int d = 0; d < 3; ++d)
        points(d, q) = values_->quadrature_point(q)[d];
    if (is_translation(points, material, 1.))
      return matrix_;
    gradients_.resize(3 * values_->dofs_per_cell, values_->n_quadrature_points);
    weights_.resize(values_->n_quadrature_points);
    for (const unsigned int q : values_->quadrature_point_indices())
      {
        for (const unsigned int i : values_->dof_indices())
          for (unsigned int d = 0; d < 3; ++d)
            gradients_(3 * i + d, q) = values_->shape_grad(i, q)[d];
        weights_(q) = values_->JxW(q);
      }
    integrate(material, 1.);
    return matrix_;
  }

  bool ElementStiffness::is_translation(const Eigen::Matrix3Xd &nodes,
                                        const Material &material, const double unit)
  {
    bool is_same = last_material_ == &material && last_unit_ == unit;
    if (is_same)
      {
        const Eigen::Matrix3Xd edges = nodes.colwise() - nodes.col(0);
        is_same = (edges - (last_nodes_.colwise() - last_nodes_.col(0)))
                    .lpNorm<Eigen::Infinity>() <= 1e-12 * edges.lpNorm<Eigen::Infinity>();
      }
    last_nodes_    = nodes;
    last_material_ = &material;
    last_unit_     = unit;
    return is_same;
  }

  void ElementStiffness::integrate(const Material &material, const double unit)
  {
    const Eigen::Index n = gradients_.rows();
    matrix_.reinit(static_cast<unsigned int>(n), static_cast<unsigned int>(n));
    if (material.is_simple())
      {
        products_.noalias() =
          (gradients_ * weights_.asDiagonal()) * gradients_.transpose();
        isotropic_stiffness(products_, material.lame_lambda / unit,
                            material.shear_modulus / unit, matrix_);
        return;
      }

    const Eigen::Matrix<double, n_strains, n_strains> C =
      voigt_matrix(material.stiffness) / unit;
    const DilatationSpace space(values_ ? values_->get_fe().degree : 1, last_nodes_,
                                weights_);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index q = 0; q < weights_.size(); ++q)
      {
        Eigen::MatrixXd B = strains(gradients_.col(q));
        if (material.mean_dilatation)
          {
            const Eigen::RowVectorXd projected =
              space.at(last_nodes_.col(q)) * gradients_.transpose();
            B.topRows<3>().rowwise() +=
              ((projected - gradients_.col(q).transpose()) / 3.).eval();
          }
        K.noalias() += B.transpose() * (weights_(q) * C * B);
      }
    for (unsigned int i = 0; i < matrix_.m(); ++i)
      for (unsigned int j = 0; j < matrix_.n(); ++j)
        matrix_(i, j) = 0.5 * (K(i, j) + K(j, i));
  }

  void for_each_element(
    const MeshLevel &level, const Materials &materials, const double unit,
    const std::function<void(const std::vector<unsigned int> &,
                             const FullMatrix<double> &)> &callback,
    const std::function<bool(const std::vector<unsigned int> &)> &is_wanted)
  {
    if (level.is_trilinear())
      {
        ElementStiffness element_stiffness;
        level.for_each_cell([&](HexahedralCell cell) {
          const std::vector<unsigned int> nodes(cell.nodes.begin(), cell.nodes.end());
          if (is_wanted && !is_wanted(nodes))
            return;
          materials.assign(cell, unit);
          callback(nodes, element_stiffness(cell));
        });
        return;
      }
    const Body &body           = level.body();
    const FiniteElement<3> &fe = body.dof_handler().get_fe();
    ElementStiffness element_stiffness(body.mapping(), fe);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<unsigned int> nodes(dofs.size() / 3);
    FullMatrix<double> K;
    for (const auto &cell : body.locally_owned_cells())
      {
        cell->get_dof_indices(dofs);
        for (std::size_t i = 0; i < nodes.size(); ++i)
          nodes[i] = level.local_node(dofs[3 * i]);
        if (is_wanted && !is_wanted(nodes))
          continue;
        K = element_stiffness(cell, materials.of(cell->material_id()));
        K /= unit;
        callback(nodes, K);
      }
  }
} // namespace stiction
