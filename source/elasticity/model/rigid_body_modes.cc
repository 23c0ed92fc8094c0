#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/rigid_body_modes.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

#include <array>

namespace stiction
{
  using namespace dealii;

  std::vector<std::vector<double>> rigid_body_modes(const Body &body)
  {
    // the nodes are in the order of their unknowns
    std::vector<Point<3>> positions;
    positions.reserve(body.locally_owned_nodes().size());
    for (const Body::Node &node : body.locally_owned_nodes())
      positions.push_back(node.position);
    return rigid_body_modes(body, positions);
  }

  std::vector<std::vector<double>> rigid_body_modes(
    const Body &body, const std::vector<Point<3>> &positions)
  {
    const auto &corners   = body.bounding_box().get_boundary_points();
    const Point<3> centre = body.bounding_box().center();
    const double radius   = corners.first.distance(corners.second) / 2.;

    std::vector<std::vector<double>> modes(6, std::vector<double>(3 * positions.size()));
    for (std::size_t i = 0; i < positions.size(); ++i)
      {
        const Tensor<1, 3> x = (positions[i] - centre) / radius;
        for (unsigned int a = 0; a < 3; ++a)
          {
            modes[a][3 * i + a] = 1.;
            // e_a × x is -x_{a+2} along a+1 and x_{a+1} along a+2
            modes[3 + a][3 * i + (a + 1) % 3] = -x[(a + 2) % 3];
            modes[3 + a][3 * i + (a + 2) % 3] = x[(a + 1) % 3];
          }
      }
    return modes;
  }

  std::string free_rigid_body_motions(const Body &body,
                                      const AffineConstraints<double> &constraints)
  {
    const auto modes      = rigid_body_modes(body);
    const IndexSet &owned = body.locally_owned_dofs();

    // A motion is free if it vanishes at every fixed unknown: the null space
    // of the Gram matrix of the modes restricted to them.
    std::array<double, 36> gram{};
    std::size_t k = 0;
    for (const auto dof : owned)
      {
        if (constraints.is_constrained(dof) &&
            constraints.get_constraint_entries(dof)->empty())
          for (unsigned int a = 0; a < 6; ++a)
            for (unsigned int b = 0; b < 6; ++b)
              gram[6 * a + b] += modes[a][k] * modes[b][k];
        ++k;
      }
    Utilities::MPI::sum(ArrayView<const double>(gram.data(), gram.size()),
                        body.communicator(), ArrayView<double>(gram.data(), gram.size()));

    const Eigen::Map<const Eigen::Matrix<double, 6, 6>> matrix(gram.data());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(matrix);
    const double scale = eigen.eigenvalues()(5);

    static const std::array<const char *, 6> names = {
      {"translation along x", "translation along y", "translation along z",
       "rotation about x", "rotation about y", "rotation about z"}};

    std::string text;
    Eigen::Matrix<double, 6, 1> in_null_space = Eigen::Matrix<double, 6, 1>::Zero();
    for (unsigned int e = 0; e < 6; ++e)
      if (eigen.eigenvalues()(e) <= 1e-10 * scale)
        in_null_space += eigen.eigenvectors().col(e).cwiseAbs2();
    for (unsigned int a = 0; a < 6; ++a)
      if (in_null_space(a) > 1e-6) // the mode has a part in the null space
        text += (text.empty() ? "" : ", ") + std::string(names[a]);
    return text;
  }
} // namespace stiction
