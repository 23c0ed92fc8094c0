#include <stiction/contact/dual/contact_solver_parameters.h>
#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/qp/methods/admm.h>
#include <stiction/qp/methods/coulomb_fixed_point.h>
#include <stiction/qp/methods/gauss_seidel.h>
#include <stiction/qp/methods/mpgp.h>
#include <stiction/qp/methods/newton.h>
#include <stiction/qp/methods/squares.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace stiction
{
  namespace
  {
    std::optional<qp::DiscActiveSet::Variant> variant(const std::string &disc_solver)
    {
      if (disc_solver == "newton")
        return std::nullopt;
      using Variant                                        = qp::DiscActiveSet::Variant;
      static const std::map<std::string, Variant> variants = {
        {"as printed", Variant::as_printed},
        {"with expansion", Variant::with_expansion},
        {"with proportioning", Variant::with_proportioning},
        {"with projected release", Variant::with_projected_release},
        {"robust", Variant::robust},
        {"spectral", Variant::spectral}};
      return variants.at(disc_solver);
    }

    std::unique_ptr<DualMethod> create(const ContactSolverParameters &parameters,
                                       const DualOperator &Q)
    {
      if (parameters.method == "squares")
        return std::make_unique<Squares>(Q, parameters.squares);
      if (parameters.method == "mpgp")
        return std::make_unique<Mpgp>(Q);
      if (parameters.method == "newton" || parameters.is_primal())
        return std::make_unique<Newton>(Q);
      if (parameters.method == "admm")
        return std::make_unique<Admm>(Q);
      return std::make_unique<GaussSeidel>(Q, variant(parameters.disc_solver));
    }
  } // namespace

  std::unique_ptr<DualMethod> create_dual_method(
    const ContactSolverParameters &parameters, const DualOperator &Q, const bool coulomb)
  {
    auto method = create(parameters, Q);
    if (coulomb &&
        (!method->solves_coulomb() || parameters.coulomb_iteration == "fixed point"))
      return std::make_unique<CoulombFixedPoint>(std::move(method));
    return method;
  }

  double best_spring_compliance(const ContactSolverParameters &parameters)
  {
    return parameters.method == "admm" ? 1. : 30.;
  }

  double best_balance_weight(const ContactSolverParameters &parameters)
  {
    return parameters.method == "admm"           ? 1.
           : parameters.method == "gauss seidel" ? 5.
                                                 : 30.;
  }
} // namespace stiction
