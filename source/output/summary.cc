#include <stiction/contact/certificate.h>
#include <stiction/contact/contact_surface.h>
#include <stiction/elasticity/body.h>
#include <stiction/elasticity/linear_elasticity.h>
#include <stiction/output/summary.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_vector.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace stiction
{
  namespace
  {
    using nlohmann::json;

    json
    to_json(const dealii::Tensor<1, 3> &v)
    {
      return {v[0], v[1], v[2]};
    }
  } // namespace



  json
  certificate_to_json(const Certificate &certificate)
  {
    const Certificate::Figures &figures = certificate.figures();
    return {{"equilibrium_residual", figures.equilibrium_residual},
            {"kkt_residual", figures.kkt_residual},
            {"penetration", figures.penetration},
            {"complementarity", figures.complementarity},
            {"cone_violation", figures.cone_violation},
            {"slip_angle", figures.slip_angle},
            {"force_balance", figures.force_balance},
            {"moment_balance", figures.moment_balance},
            {"duality_gap", figures.duality_gap}};
  }



  json
  contact_to_json(const ContactSurface &surface,
                  const Certificate &certificate,
                  const double tolerance)
  {
    const Eigen::Index m          = surface.n_nodes();
    const Eigen::VectorXd &lambda = certificate.lambda();

    std::array<unsigned int, 3> count{};
    unsigned int undecided = 0;
    double max_pressure = 0., area = 0.;
    for (Eigen::Index i = 0; i < m; ++i)
      {
        const NodeStatus status = certificate.status(i);
        ++count[static_cast<unsigned int>(status)];
        undecided += certificate.is_undecided(i, tolerance) ? 1 : 0;
        max_pressure = std::max(max_pressure, lambda(i) / surface.areas()(i));
        if (status != NodeStatus::open)
          area += surface.areas()(i);
      }

    json tangential_force = nullptr;
    if (surface.is_plane())
      tangential_force = {lambda.segment(m, m).sum(), lambda.tail(m).sum()};

    return {{"open", count[0]},
            {"slip", count[1]},
            {"stick", count[2]},
            {"undecided", undecided},
            {"normal_force", lambda.head(m).sum()},
            {"tangential_force", tangential_force},
            {"force_on_body", to_json(certificate.force_on_body())},
            {"moment", to_json(certificate.moment_on_body())},
            {"max_pressure", max_pressure},
            {"area", area}};
  }



  json
  energy_to_json(const ContactSurface &surface, const Certificate &certificate)
  {
    // Σ λ_t · slip, and r_t = −slip
    const Eigen::Index n = 2 * surface.n_nodes();
    return {
      {"strain", certificate.strain_energy()},
      {"load_work", certificate.load_work()},
      {"friction_dissipation",
       0. - certificate.lambda().tail(n).dot(certificate.gradient().tail(n))}};
  }



  json
  displacement_to_json(const LinearElasticity &elasticity, const LA::Vector &u)
  {
    // the first component is the size, so that the largest array is the one
    // sought; ties go to the largest place, on any number of ranks
    std::array<double, 4> largest{{-1., 0., 0., 0.}};
    for (const Body::Node &node : elasticity.body().locally_owned_nodes())
      {
        dealii::Tensor<1, 3> displacement;
        for (unsigned int c = 0; c < 3; ++c)
          displacement[c] = u(node.dofs[c]);
        largest = std::max(largest,
                           {{displacement.norm(),
                             node.position[0],
                             node.position[1],
                             node.position[2]}});
      }
    for (const auto &theirs : dealii::Utilities::MPI::all_gather(
           elasticity.body().communicator(), largest))
      largest = std::max(largest, theirs);
    return {{"max", largest[0]}, {"at", {largest[1], largest[2], largest[3]}}};
  }

} // namespace stiction
