// The parts of the Newton method: the Krylov methods solve what they are
// given, hand back the image of the solution without a product of their own,
// and a good preconditioner saves iterations; Nyström's preconditioner from
// all directions is the inverse; the linearisation is the derivative of the
// conditions, seen by differences.

#include <stiction/qp/methods/admm.h>
#include <stiction/qp/sets/contact_linearization.h>
#include <stiction/qp/sets/feasible_set.h>
#include <stiction/qp/sets/slip_bound.h>
#include <stiction/qp/solvers/krylov_methods.h>
#include <stiction/qp/solvers/nystrom_preconditioner.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "qp_tests.h"

using namespace stiction;
using namespace stiction::qp;
using namespace qp_tests;

int main()
{
  Random random(2);
  const Index n = 20;

  // Krylov methods
  {
    const MatrixXd A = random.spd(n, 1e4), B = random.spd(n, 10.);
    MatrixXd U = A;
    U(0, n - 1) += 0.5; // not symmetric
    const VectorXd b  = random.vector(n);
    unsigned int used = 0;
    const auto with   = [&](const MatrixXd &M) {
      return [&used, &B, M](const VectorXd &v, VectorXd &Mv, VectorXd &image) {
        ++used;
        Mv    = M * v;
        image = B * v;
      };
    };
    const auto none  = [](const VectorXd &v) { return v; };
    const auto exact = [&](const VectorXd &v) -> VectorXd { return A.llt().solve(v); };
    const auto cg    = conjugate_gradients(with(A), b, none, 1e-10, 500);
    print_below("CG: residual", (A * cg.y - b).norm() / b.norm(), 1e-7);
    print_below("CG: image", (B * cg.y - cg.image).norm() / b.norm(), 1e-9);
    print("CG: a product an iteration", used == cg.iterations);
    print("CG with the inverse as preconditioner takes one iteration",
          conjugate_gradients(with(A), b, exact, 1e-6, 500).iterations == 1);
    used          = 0;
    const auto gm = gmres(with(U), b, none, 1e-10, 500);
    print_below("GMRES: residual", (U * gm.y - b).norm() / b.norm(), 1e-9);
    print_below("GMRES: image", (B * gm.y - gm.image).norm() / b.norm(), 1e-7);
    print("GMRES: a product an iteration, at most n",
          used == gm.iterations && gm.iterations <= n);
    print("GMRES with a good preconditioner takes fewer",
          gmres(with(U), b, exact, 1e-10, 500).iterations < gm.iterations / 2);
  }

  // linearisation and preconditioner, where every kind of node occurs
  {
    const Index m      = 6;
    const MatrixXd A   = random.spd(3 * m, 100.);
    const VectorXd rho = random.vector(m, 0.5, 2.);
    VectorXd x = random.vector(3 * m, -0.6, 0.6), r = random.vector(3 * m);
    r.tail(2 * m) *= 0.5;
    x.head(m) << 2., 2., 2., 2., -0.3, 1.; // the fifth is open
    r.head(m) << 0., 0.1, -0.1, 0., 1., 0.;
    const auto bound = SlipBound::coulomb(VectorXd::Constant(m, 0.3));
    const ContactLinearization step(x, r, rho, bound);
    print("Some slip, some stick", step.curvature().maxCoeff() > 0. &&
                                     step.n_free() > 2 * m && step.n_free() < 3 * m);

    // The conditions C(x) = x − P(x − ρr; bound of x − ρr) have the derivative
    // that the step d = d0 + Zy makes zero: C + C'd = 0 with r' = A d, for the
    // y that solves the reduced equation, but for terms of second order.
    const auto conditions = [&](const VectorXd &at, const VectorXd &gradient) {
      VectorXd a = at - rho.replicate(3, 1).cwiseProduct(gradient), y = a;
      project(y, m, 0.3 * a.head(m).cwiseMax(0.));
      return VectorXd(at - y);
    };
    print_below("Its residual is that of the conditions",
                std::abs(step.residual() - conditions(x, r).norm()), 1e-14);
    MatrixXd Z(3 * m, step.n_free()), W(3 * m, step.n_free());
    for (Index k = 0; k < step.n_free(); ++k)
      Z.col(k) = step.embed(VectorXd::Unit(step.n_free(), k));
    for (Index k = 0; k < 3 * m; ++k)
      W.row(k) = step.test(VectorXd::Unit(3 * m, k)).transpose();
    print_below("Z and its transpose",
                (step.transpose_embed(x) - Z.transpose() * x).norm(), 1e-13);
    // near a solution: x* of the conditions with this A and b = A x − r
    VectorXd xs = x, rs = r;
    double residual = 1.;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const ContactLinearization s(xs, rs, 0.1 * rho, bound);
        MatrixXd Zs(3 * m, s.n_free()), Ws(3 * m, s.n_free());
        for (Index k = 0; k < s.n_free(); ++k)
          Zs.col(k) = s.embed(VectorXd::Unit(s.n_free(), k));
        for (Index k = 0; k < 3 * m; ++k)
          Ws.row(k) = s.test(VectorXd::Unit(3 * m, k)).transpose();
        MatrixXd M = Ws.transpose() * A * Zs;
        M.diagonal() += s.curvature();
        const VectorXd d =
          s.prescribed() - Zs * M.lu().solve(Ws.transpose() * (rs + A * s.prescribed()));
        xs += d;
        rs += A * d;
        const double before = residual;
        residual            = conditions(xs, rs).norm();
        if (residual < 1e-6 && residual > 1e-13)
          print("Quadratic at the end: a step squares the error",
                residual < 10. * before * before + 1e-12);
      }
    print_below("Exact steps end at a solution", residual, 1e-12);

    NystromPreconditioner preconditioner;
    for (Index k = 0; k < 3 * m; ++k)
      preconditioner.add(VectorXd::Unit(3 * m, k), A.col(k));
    preconditioner.set_up(step, VectorXd::Constant(m, 1e-9));
    MatrixXd M = W.transpose() * A * Z;
    M.diagonal() += step.curvature();
    const VectorXd v = random.vector(step.n_free());
    print_below("Nystrom's preconditioner from all directions is the inverse",
                (M * preconditioner.apply(v) - v).norm(), 1e-5);
  }

  // ADMM against the reference solution
  {
    const Index m = 8;
    const Scaling scaling{VectorXd::Ones(m), 1.};
    Largest error, wrong_gradient;
    unsigned int not_converged = 0, many_factors = 0;
    for (unsigned int problem = 0; problem < 20; ++problem)
      {
        const MatrixXd A    = random.spd(3 * m, 100.);
        const VectorXd b    = random.vector(3 * m);
        const VectorXd g    = random.vector(m, 0., 2.);
        const VectorXd best = reference_solution(A, b, m, g);
        const DenseDualOperator op(A, b);
        Admm admm(op);
        DualIterate iterate{VectorXd::Zero(3 * m), -b};
        const auto &[x, r] = iterate;
        not_converged +=
          !admm.solve(iterate, {SlipBound::given(g), scaling, {1e-11, 1., 3000}})
             .converged;
        many_factors += admm.statistics().dense_factorizations > 4;
        error.add((x - best).norm() / best.norm());
        wrong_gradient.add((r - (A * x - b)).norm());
      }
    print_count("ADMM: problems not solved", not_converged);
    print_count("ADMM: more than four factorisations", many_factors);
    print_below("ADMM: distance from the reference solution", error, 1e-7);
    print_below("ADMM: gradient handed back is wrong by", wrong_gradient, 1e-9);
  }
}
