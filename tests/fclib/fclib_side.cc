// fclib_side read FILE          reads what stiction has written, and asks
//                               FCLIB whether the solution in it is one
// fclib_side write KIND FILE    writes the problem; KIND: triplets, columns,
//                               rows
//
// Only libfclib, see stiction_side.cc.

extern "C"
{
#include <fclib.h>
}

#include <cstdio>
#include <string>
#include <vector>

#include "exchange.h"

using exchange::m;
using exchange::n;

namespace
{
  int failures = 0;

  void expect(const bool condition, const char *what)
  {
    if (!condition)
      {
        std::printf("not so: %s\n", what);
        ++failures;
      }
  }

  // An entry of any of FCLIB's three kinds of matrix.
  double entry(const fclib_matrix &matrix, const int row, const int column)
  {
    double sum = 0.;
    if (matrix.nz >= 0)
      {
        for (int k = 0; k < matrix.nz; ++k)
          if (matrix.p[k] == row && matrix.i[k] == column)
            sum += matrix.x[k];
        return sum;
      }
    const int line  = matrix.nz == -1 ? column : row;
    const int index = matrix.nz == -1 ? row : column;
    for (int k = matrix.p[line]; k < matrix.p[line + 1]; ++k)
      if (matrix.i[k] == index)
        sum += matrix.x[k];
    return sum;
  }

  void read(const char *file)
  {
    fclib_local *const problem = fclib_read_local(file);
    expect(problem != nullptr, "FCLIB reads the problem");
    if (problem == nullptr)
      return;
    expect(problem->spacedim == 3, "three dimensions");
    expect(problem->V == nullptr && problem->R == nullptr, "no equality constraints");
    expect(problem->W->m == n && problem->W->n == n, "the order of W");
    expect(problem->info != nullptr && problem->info->title != nullptr &&
             problem->info->description != nullptr && problem->info->math_info != nullptr,
           "the problem is described");
    if (failures > 0)
      return;

    const auto q = exchange::q();
    bool same_W = true, same_q = true, same_mu = true;
    for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
          same_W = same_W && entry(*problem->W, i, j) == exchange::W(i, j);
        same_q = same_q && problem->q[i] == q[i];
      }
    for (int i = 0; i < m; ++i)
      same_mu = same_mu && problem->mu[i] == exchange::mu[i];
    expect(same_W, "the same W");
    expect(same_q, "the same q");
    expect(same_mu, "the same mu");

    fclib_solution *const solution = fclib_read_solution(file);
    expect(solution != nullptr && solution->u != nullptr && solution->r != nullptr,
           "FCLIB reads the solution");
    if (failures > 0)
      return;
    bool same_u = true, same_r = true;
    for (int i = 0; i < n; ++i)
      {
        same_u = same_u && solution->u[i] == exchange::velocity[i];
        same_r = same_r && solution->r[i] == exchange::reaction[i];
      }
    expect(same_u, "the same u");
    expect(same_r, "the same r");

    const double merit = fclib_merit_local(problem, MERIT_1, solution);
    std::printf("merit of the solution %g\n", merit);
    expect(merit < 1e-14, "the solution is one to FCLIB");

    // ... which is not true of anything
    for (const int k : {0, 1, 4, 6})
      {
        solution->r[k] += 1e-6;
        expect(fclib_merit_local(problem, MERIT_1, solution) > 1e-7,
               "another solution is none");
        solution->r[k] -= 1e-6;
      }
  }

  void write(const std::string &kind, const char *file)
  {
    std::vector<int> p, i;
    std::vector<double> x;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        {
          if (kind == "triplets")
            p.push_back(a);
          i.push_back(b);
          x.push_back(exchange::W(a, b));
        }
    if (kind != "triplets")
      for (int a = 0; a <= n; ++a)
        p.push_back(a * n);

    fclib_matrix W{};
    W.nzmax = n * n;
    W.m = W.n = n;
    W.nz      = kind == "triplets" ? n * n : kind == "columns" ? -1 : -2;
    W.p       = p.data();
    W.i       = i.data();
    W.x       = x.data();
    auto q    = exchange::q();
    auto mu   = exchange::mu;
    auto u    = exchange::velocity;
    auto r    = exchange::reaction;

    fclib_local problem{};
    problem.W        = &W;
    problem.q        = q.data();
    problem.mu       = mu.data();
    problem.spacedim = 3;
    std::remove(file); // FCLIB adds to a file that exists
    expect(fclib_write_local(&problem, file) == 1, "FCLIB writes the problem");
    fclib_solution solution{};
    solution.u = u.data();
    solution.r = r.data();
    expect(fclib_write_solution(&solution, file) == 1, "FCLIB writes the solution");
  }
} // namespace

int main(int argc, char *argv[])
{
  if (argc == 3 && argv[1] == std::string("read"))
    read(argv[2]);
  else if (argc == 4 && argv[1] == std::string("write"))
    write(argv[2], argv[3]);
  else
    return 2;
  return failures > 0 ? 1 : 0;
}
