#include <stiction/contact/dual/dual_method_factory.h>
#include <stiction/parameters/parameters.h>
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
#include <vector>

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
      if (parameters.method == "newton")
        return std::make_unique<Newton>(Q);
      if (parameters.method == "admm")
        return std::make_unique<Admm>(Q);
      return std::make_unique<GaussSeidel>(Q, variant(parameters.disc_solver));
    }

    bool is_refused(const std::string &method, const Parameters &parameters,
                    const bool has_body)
    {
      if (method == "admm")
        return parameters.dual_operator.form != "assembled";
      return method == "newton multigrid" &&
             (!has_body || !parameters.output.export_directory.empty() ||
              parameters.stiffness_solver.type == "mumps" ||
              parameters.contact_solver.coulomb_iteration != "direct" ||
              parameters.performance.measure_factorizations);
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

  std::string advice_on_method(const Parameters &parameters, const bool is_coulomb,
                               const bool has_body)
  {
    const ContactSolverParameters &chosen = parameters.contact_solver;
    const std::string &method             = chosen.method;
    if (method == "gauss seidel" && chosen.disc_solver != "newton" &&
        chosen.disc_solver != "spectral")
      return "choose 'Contact solver/Disc solver = spectral'";
    const bool approximates = is_coulomb && chosen.coulomb_iteration == "fixed point";
    if (approximates && method != "mpgp")
      return "choose 'Contact solver/Coulomb iteration = direct'";

    // a matrix has factors, which find a way where products do not
    if (method == "newton" && parameters.dual_operator.form != "assembled")
      return "choose 'Dual operator/Form = assembled'";

    std::vector<std::string> others;
    for (const char *const other : {"newton", "newton multigrid", "admm", "gauss seidel"})
      if (other != method && !is_refused(other, parameters, has_body))
        others.push_back(std::string("'") +
                         (others.empty() ? "Contact solver/Method = " : "") + other +
                         "'");
    if (approximates)
      return "choose " + others[0] + " with 'Coulomb iteration = direct'";
    return "choose " + others[0] + (others.size() > 1 ? " or " + others[1] : "");
  }
} // namespace stiction
