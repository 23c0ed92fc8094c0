// Each figure of the certificate catches the fault it is there for. A
// certified answer is spoilt in one respect at a time; listed are the figures
// that then exceed 1e-6. The figures come from u, λ and the data alone, so
// the faults are put there.

#include "tests.h"

#include <stiction/contact/certificate/duality_gap.h>
#include <stiction/contact/interface/state.h>
#include <stiction/contact/dual/schur_complement.h>
#include <stiction/elasticity/mesh/body.h>
#include <stiction/elasticity/solvers/stiffness_solver.h>
#include <stiction/elasticity/stiffness/linear_elasticity.h>
#include <stiction/qp/methods/gauss_seidel.h>

#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace stiction;

namespace
{
  // A dual operator with one wrong per cent in its tangential rows.
  class WrongSchurComplement : public DualOperator
  {
  public:
    WrongSchurComplement(const LinearElasticity &elasticity,
                         const ContactSurface &surface, StiffnessSolver &solver)
      : DualOperator(surface.n_nodes())
      , right_(SchurComplement::create("by solves", elasticity, surface, solver))
    {
      set_right_hand_side(right_->right_hand_side());
    }

    Eigen::VectorXd compute_nodal_compliance() const override
    {
      return right_->nodal_compliance();
    }

  protected:
    void apply(const DualBlock rows, const DualBlock columns, Eigen::VectorXd &dst,
               const Eigen::VectorXd &src) const override
    {
      right_->vmult(rows, columns, dst, src);
      if (rows == DualBlock::tangential && columns == DualBlock::tangential)
        dst *= 1.01;
    }

  private:
    std::unique_ptr<DualOperator> right_;
  };
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Run run(shipped("brick.prm"),
                {"Geometry/Table 1 level=2", "Friction/Law=given",
                 "Friction/Slip stress=1.5e7", "Friction/Slip stress=1.5e7",
                 "Contact solver/Tolerance=1e-10"});

  const auto &elasticity       = run.problem->elasticity();
  const auto &surface          = run.problem->contact_surface();
  const auto &right            = run.problem->certificate();
  const Eigen::VectorXd lambda = run.problem->state().lambda;
  const LA::Vector u           = run.problem->state().u;
  const Eigen::Index m         = surface.n_nodes();

  const auto solver       = StiffnessSolver::create("mumps", elasticity, 1e-14);
  const auto displacement = [&](const Eigen::VectorXd &forces, StiffnessSolver &with) {
    LA::Vector load = elasticity.constrained_load();
    surface.B().add_transpose(-1., forces, load);
    LA::Vector v = elasticity.zero_vector();
    with.solve(v, load);
    return v;
  };
  const auto show = [&](const char *fault, const LA::Vector &v,
                        const Eigen::VectorXd &forces) {
    const Certificate certificate(elasticity, surface, {v, forces, {}});
    out() << fault << ":";
    for (const auto &figure : certificate.deciding_figures())
      if (!(figure.second <= 1e-6))
        out() << " " << figure.first;
    if (certificate.contact_figures().slip_angle > 0.1)
      out() << " slip_angle";
    out() << (certificate.converged(1e-6) ? " (certified)" : "") << std::endl;
  };

  // a node of each kind, the most decided one
  const auto node = [&](const std::function<double(Eigen::Index)> &size) {
    Eigen::Index best = 0;
    for (Eigen::Index i = 0; i < m; ++i)
      if (size(i) > size(best))
        best = i;
    return best;
  };
  const Eigen::Index open =
    node([&](const Eigen::Index i) { return right.gradient()(i); });
  const Eigen::Index closed = node([&](const Eigen::Index i) { return lambda(i); });

  show("nothing wrong", u, lambda);

  {
    const WrongSchurComplement wrong(elasticity, surface, *solver);
    GaussSeidel gauss_seidel(wrong);
    DualIterate iterate{Eigen::VectorXd::Zero(3 * m), -wrong.right_hand_side()};
    const auto result =
      gauss_seidel.solve(iterate, {qp::SlipBound::given(right.slip_bound()),
                                   right.scaling(),
                                   {1e-9, std::numeric_limits<double>::infinity(), 200}});
    out() << "(the solver with the wrong Q says it converged: " << yes(result.converged)
          << ")" << std::endl;
    show("a wrong Q", displacement(iterate.lambda, *solver), iterate.lambda);
  }

  {
    // conjugate gradients stopped early, without a preconditioner that would
    // depend on the number of ranks
    LA::Vector load = elasticity.constrained_load();
    surface.B().add_transpose(-1., lambda, load);
    LA::Vector loose = elasticity.zero_vector();
    dealii::IterationNumberControl control(100, 0.);
    dealii::SolverCG<LA::Vector> cg(control);
    cg.solve(elasticity.constrained_stiffness(), loose, load,
             dealii::PreconditionIdentity());
    show("a loose linear solve", loose, lambda);
  }

  {
    Eigen::VectorXd forces = lambda;
    forces.tail(2 * m) *= 1.001;
    show("friction forces 0.1 % too large", displacement(forces, *solver), forces);
    forces = lambda;
    forces.tail(2 * m) *= 0.999;
    show("friction forces 0.1 % too small", displacement(forces, *solver), forces);
  }

  {
    const double angle     = 0.01;
    Eigen::VectorXd forces = lambda;
    forces.segment(m, m) =
      std::cos(angle) * lambda.segment(m, m) - std::sin(angle) * lambda.tail(m);
    forces.tail(m) =
      std::sin(angle) * lambda.segment(m, m) + std::cos(angle) * lambda.tail(m);
    show("friction forces turned by half a degree", displacement(forces, *solver),
         forces);
  }

  {
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(3 * m);
    shift(closed)         = 1e-3 * right.scaling().displacement;
    LA::Vector v          = u;
    surface.B().add_transpose(1., shift, v);
    show("a penetrating node", v, lambda);

    Eigen::VectorXd forces = lambda;
    forces(closed)         = 0.99 * lambda(closed);
    show("a node held too little, in equilibrium", displacement(forces, *solver), forces);
  }

  {
    Eigen::VectorXd forces = lambda;
    forces(open)           = 1e-3 * right.scaling().force(open);
    show("pressure across an open gap", displacement(forces, *solver), forces);
    forces(open) = -forces(open);
    show("tension at an open node", displacement(forces, *solver), forces);
  }

  show("contact forces that u does not know of", u, 1.001 * lambda);

  // Away from the solution the duality gap is a bound, and not a wild one.
  out() << "duality gap of the certified answer below 1e-7: "
        << yes(right.body_figures().duality_gap < 1e-7) << std::endl;
  for (const double size : {1e-2, 1e-4})
    {
      Eigen::VectorXd forces = lambda;
      for (Eigen::Index i = 0; i < 3 * m; ++i)
        forces(i) *= 1. + size * std::sin(7. * static_cast<double>(i));
      const LA::Vector v = displacement(forces, *solver);
      const double gap   = duality_gap(elasticity, surface, {v, forces, {}}, *solver);

      // the pair (û, λ̂) is near (u, λ): compare with the error of u itself
      LA::Vector error = v;
      error -= u;
      const double true_error = std::sqrt((error * elasticity.internal_force(error)) /
                                          (u * elasticity.internal_force(u)));
      const double ratio      = gap / true_error;
      out() << "error of size " << size
            << ": the gap is 0.9 to 10 times the energy error: "
            << yes(ratio > 0.9 && ratio < 10.) << std::endl;
    }
}
