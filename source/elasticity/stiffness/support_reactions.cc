#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/model/prescribed_displacement.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/elasticity/stiffness/support_reactions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <set>

namespace stiction
{
  using namespace dealii;

  SupportReactions::SupportReactions(const LinearElasticity &elasticity,
                                     const LA::Vector &u, const LA::Vector &contact_force)
    : nodal_(std::make_unique<LA::Vector>(elasticity.internal_force(u)))
  {
    const Body &body = elasticity.body();
    *nodal_ -= elasticity.load();
    *nodal_ -= contact_force;
    for (const auto dof : body.locally_owned_dofs())
      if (!elasticity.is_prescribed(dof))
        (*nodal_)(dof) = 0.;

    const PrescribedDisplacement &supports = elasticity.prescribed_displacement();
    auto boundary_of                       = supports.supporting_boundaries();
    std::set<types::global_dof_index> at_points;
    for (const auto &node : supports.supported_nodes())
      {
        AtPoint point{node.position, Tensor<1, 3>()};
        for (unsigned int c = 0; c < 3; ++c)
          {
            const types::global_dof_index dof = node.first_dof + c;
            if (!node.components[c] || !at_points.insert(dof).second)
              continue; // a node may be given twice
            boundary_of.erase(dof);
            if (nodal_->in_local_range(dof))
              point.force[c] = (*nodal_)(dof);
          }
        point.force = Utilities::MPI::sum(point.force, body.communicator());
        points_.push_back(point);
      }

    for (const auto id : supports.boundaries())
      boundaries_[id];
    for (const Body::Node &node : body.locally_owned_nodes())
      for (unsigned int c = 0; c < 3; ++c)
        {
          const auto support = boundary_of.find(node.dofs[c]);
          if (support == boundary_of.end())
            continue;
          Tensor<1, 3> force;
          force[c]        = (*nodal_)(node.dofs[c]);
          OnBoundary &sum = boundaries_.at(support->second);
          sum.force += force;
          sum.moment += cross_product_3d(node.position, force);
        }
    for (auto &sum : boundaries_)
      {
        sum.second.force  = Utilities::MPI::sum(sum.second.force, body.communicator());
        sum.second.moment = Utilities::MPI::sum(sum.second.moment, body.communicator());
      }
  }

  SupportReactions::~SupportReactions() = default;
} // namespace stiction
