#include <stiction/contact/pairs/held_slaves.h>
#include <stiction/contact/pairs/mortar.h>
#include <stiction/elasticity/linear_algebra/dof_subset.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>

namespace stiction
{
  unsigned int n_held_alone(const LinearElasticity &elasticity, const Mortar &mortar)
  {
    LA::Vector held = elasticity.zero_vector();
    for (const auto dof : held.locally_owned_elements())
      held(dof) = elasticity.is_prescribed(dof) ? 1. : 0.;
    const Eigen::VectorXd slaves  = DofSubset::of_nodes(mortar.slaves).restriction(held);
    const Eigen::VectorXd masters = DofSubset::of_nodes(mortar.masters).restriction(held);
    const Eigen::Index m = mortar.weights.rows(), n = mortar.weights.cols();
    unsigned int n_nodes = 0;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        bool is_alone = false;
        for (Eigen::Index c = 0; c < 3; ++c)
          if (slaves(i + c * m) > 0.)
            {
              double all = 0., free = 0.;
              for (decltype(mortar.weights)::InnerIterator a(mortar.weights, i); a; ++a)
                {
                  all += std::abs(a.value());
                  free += std::abs(a.value()) * (1. - masters(a.col() + c * n));
                }
              is_alone = is_alone || free > 0.5 * all;
            }
        n_nodes += is_alone ? 1 : 0;
      }
    return n_nodes;
  }
} // namespace stiction
