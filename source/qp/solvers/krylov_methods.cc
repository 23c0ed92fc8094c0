#include <stiction/qp/solvers/krylov_methods.h>

#include <Eigen/QR>

#include <vector>

namespace stiction::qp
{
  KrylovSolution conjugate_gradients(const ProductWithImage &A, const Eigen::VectorXd &b,
                                     const Preconditioner &preconditioner,
                                     const double reduction,
                                     const unsigned int max_iterations)
  {
    KrylovSolution solution;
    solution.y = Eigen::VectorXd::Zero(b.size());
    if (b.isZero(0.)) // or of length 0
      return solution;
    Eigen::VectorXd r = b, z = preconditioner(r), p = z, Ap, image;
    double rz          = r.dot(z);
    const double first = rz;
    while (rz > reduction * reduction * first && solution.iterations < max_iterations)
      {
        A(p, Ap, image);
        ++solution.iterations;
        const double curvature = p.dot(Ap);
        if (!(curvature > 0.)) // rounding, or not positive definite
          break;
        const double alpha = rz / curvature;
        solution.y += alpha * p;
        if (solution.image.size() == 0)
          solution.image = alpha * image;
        else
          solution.image += alpha * image;
        r -= alpha * Ap;
        z                   = preconditioner(r);
        const double before = rz;
        rz                  = r.dot(z);
        p                   = z + rz / before * p;
      }
    return solution;
  }

  KrylovSolution gmres(const ProductWithImage &A, const Eigen::VectorXd &b,
                       const Preconditioner &preconditioner, const double reduction,
                       const unsigned int max_iterations)
  {
    const double first = b.norm();

    KrylovSolution solution;
    solution.y = Eigen::VectorXd::Zero(b.size());
    if (!(first > 0.))
      return solution;

    std::vector<Eigen::VectorXd> basis = {b / first}, directions, images;
    Eigen::MatrixXd H; // of Arnoldi, (k+1) × k
    Eigen::VectorXd c; // coefficients of the solution in the basis
    Eigen::VectorXd image;
    for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(max_iterations); ++k)
      {
        directions.push_back(preconditioner(basis[k]));
        Eigen::VectorXd w;
        A(directions[k], w, image);
        ++solution.iterations;
        images.push_back(image);
        H.conservativeResizeLike(Eigen::MatrixXd::Zero(k + 2, k + 1));
        for (unsigned int sweep = 0; sweep < 2; ++sweep) // Gram–Schmidt, twice
          for (Eigen::Index j = 0; j <= k; ++j)
            {
              const double h = basis[j].dot(w);
              H(j, k) += h;
              w -= h * basis[j];
            }
        H(k + 1, k) = w.norm();

        // the least squares problem is tiny beside one product
        const Eigen::VectorXd e = first * Eigen::VectorXd::Unit(k + 2, 0);
        c                       = H.colPivHouseholderQr().solve(e);
        if ((H * c - e).norm() <= reduction * first ||
            !(H(k + 1, k) > 1e-14 * H.col(k).norm()))
          break;
        basis.emplace_back(w / H(k + 1, k));
      }

    solution.image = Eigen::VectorXd::Zero(image.size());
    for (Eigen::Index j = 0; j < c.size(); ++j)
      {
        solution.y += c(j) * directions[j];
        solution.image += c(j) * images[j];
      }
    return solution;
  }
} // namespace stiction::qp
