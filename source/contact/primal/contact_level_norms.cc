// How large forces of a level are, and when they are rounding.

#include <stiction/contact/primal/contact_level.h>
#include <stiction/elasticity/linear_algebra/sum_over_ranks.h>
#include <stiction/elasticity/stiffness/stiffness_operator.h>
#include <stiction/qp/contact_scales.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace stiction
{
  using namespace dealii;

  double ContactLevel::sum_of_norms(const LA::Vector &v,
                                    const std::vector<unsigned char> &components)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < v.locally_owned_size() / 3; ++i)
      {
        double square = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          if (components.empty() || (components[i] >> c & 1) != 0)
            square += v.begin()[3 * i + c] * v.begin()[3 * i + c];
        sum += std::sqrt(square);
      }
    return Utilities::MPI::sum(sum, v.get_mpi_communicator());
  }

  ContactLevel::Scales ContactLevel::scales(const LA::Vector &u, const LA::Vector &R,
                                            const Eigen::VectorXd &lambda) const
  {
    // a prescribed node may be prescribed in some components only
    double reactions = 0.;
    for (std::size_t k = 0; k < fixed_.size();)
      {
        const unsigned int node = fixed_[k] / 3;
        double square           = 0.;
        for (; k < fixed_.size() && fixed_[k] / 3 == node; ++k)
          square += R.local_element(fixed_[k]) * R.local_element(fixed_[k]);
        reactions += std::sqrt(square);
      }
    double energy = 0.; // uᵀKu = uᵀ(f − R)
    for (unsigned int k = 0; k < u.locally_owned_size(); ++k)
      energy += u.local_element(k) * (load_.local_element(k) - R.local_element(k));
    std::array<double, 2> sums{{reactions, energy}};
    sum_over_ranks(sums, u.get_mpi_communicator());

    double contact_forces = 0.;
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      contact_forces += at_node(lambda, i).cwiseProduct(B_.frames()[i].scales()).norm();

    const State::Scales least = earlier_scales_.least();
    Scales scales;
    scales.force =
      std::max(nonzero(std::max({load_sum_, sums[0], contact_forces})), least.force);
    scales.scaling = contact_scaling(scales.force, std::max(sums[1], least.energy),
                                     areas_, boundary_area_, stiffness_of_cells_);
    return scales;
  }

  double ContactLevel::rounding_of_forces(const LA::Vector &u) const
  {
    const std::vector<double> blocks = stiffness_->diagonal_blocks();
    LA::Vector forces                = u;
    basis_.to_absolute(forces);
    for (std::size_t k = 0; k < forces.locally_owned_size(); ++k)
      forces.begin()[k] *= unit_roundoff * blocks[9 * (k / 3) + 4 * (k % 3)];
    return sum_of_norms(forces);
  }

  bool ContactLevel::is_rounding(const LA::Vector &forces, const LA::Vector &u) const
  {
    const std::vector<double> blocks = stiffness_->diagonal_blocks();
    const double size                = reach_of_rounding(unit_roundoff) * u.linfty_norm();
    bool exceeds                     = false;
    for (unsigned int k = 0; k < forces.locally_owned_size(); ++k)
      exceeds = exceeds || std::abs(forces.local_element(k)) >
                             size * blocks[9 * (k / 3) + 4 * (k % 3)];
    return !Utilities::MPI::logical_or(exceeds, u.get_mpi_communicator());
  }

  double ContactLevel::sum_of_norms_inside(const LA::Vector &v) const
  {
    return sum_of_norms(v, free_components_);
  }
} // namespace stiction
