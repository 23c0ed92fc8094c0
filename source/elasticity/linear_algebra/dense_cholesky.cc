#include <stiction/elasticity/linear_algebra/dense_cholesky.h>

#include <deal.II/lac/lapack_templates.h>

#include <stdexcept>
#include <string>

namespace stiction::dense_cholesky
{
  using dealii::types::blas_int;

  namespace
  {
    void require_success(const blas_int info)
    {
      if (info != 0)
        throw std::runtime_error("a dense matrix that should be positive "
                                 "definite is not (LAPACK info " +
                                 std::to_string(info) + ")");
    }
  } // namespace

  void factorize(double *A, const int n)
  {
    const blas_int order = n;
    blas_int info        = 0;
    dealii::potrf("L", &order, A, &order, &info);
    require_success(info);
  }

  void invert(double *L, const int n)
  {
    const blas_int order = n;
    blas_int info        = 0;
    dealii::potri("L", &order, L, &order, &info);
    require_success(info);
  }

  void solve(const double *L, const int n, double *b)
  {
    const blas_int order = n, one = 1;
    blas_int info = 0;
    dealii::potrs("L", &order, &one, L, &order, b, &order, &info);
    require_success(info);
  }
} // namespace stiction::dense_cholesky
