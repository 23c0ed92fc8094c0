#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/output/problem/fclib.h>
#include <stiction/output/problem/matrix_market.h>
#include <stiction/output/problem/problem_check.h>
#include <stiction/output/problem/problem_files.h>

#include <filesystem>
#include <ostream>

namespace stiction
{
  namespace
  {
    constexpr const char *hdf5_name = "problem.hdf5";

    void write_readme(std::ostream &out, const DualProblem &problem,
                      const bool has_solution)
    {
      const bool is_coulomb = problem.slip_bound.is_coulomb();
      out << "A discrete contact problem with " << (is_coulomb ? "Coulomb" : "given")
          << " friction, " << problem.slip_bound.n_nodes()
          << " contact nodes\n"
             "written by stiction " STICTION_VERSION "\n\n"
             "THE PROBLEM\n"
             "Find contact forces lambda such that, with r = Q lambda - h, at "
             "each node\n"
             "  normal      lambda_nu >= 0, r_nu >= 0, lambda_nu r_nu = 0\n"
             "  tangential  |lambda_t| <= g; r_t = 0 where |lambda_t| < g; and "
             "in any case\n"
             "              g r_t = -|r_t| lambda_t (where g = 0, r_t is "
             "free)\n"
          << (is_coulomb
                ? "  slip bound  g = F lambda_nu, F the coefficient of friction\n"
                  "This is a fixed point, not a minimisation.\n"
                : "  slip bound  g is given at each node, also where it is "
                  "open\n"
                  "This is: minimise lambda.Q lambda / 2 - lambda.h subject to "
                  "the bounds on lambda.\n")
          << "\n"
             "SIGNS\n"
             "  lambda_nu   normal force, compression positive\n"
             "  lambda_t    tangential force of the body on the obstacle\n"
             "  r           (remaining gap; -slip in t1; -slip in t2)\n"
             "  nu, t1, t2  unit normal towards the obstacle and tangents of "
             "the node, t2 = t1 x nu\n"
             "              (the ellipse of orthotropic friction is scaled to a "
             "disc: entries t2 of\n"
             "              lambda are divided and those of r multiplied by "
             "F2/F1; entries in held\n"
             "              directions are 0)\n"
             "\n"
             "UNITS\n"
             "lambda and g are forces, h and r lengths, Q length per force, "
             "areas "
             "length^2, in\n"
             "the units of the parameter file.\n"
             "\n"
             "MATRIX MARKET FILES (text, 17 significant digits)\n"
             "Vectors by blocks: all nu, then all t1, then all t2. Dense "
             "('array'), column by\n"
             "column; Q, being symmetric, as its lower triangle.\n"
             "  Q.mtx       Q = B K^-1 B^T, K the stiffness of the body, B "
             "the contact components\n"
             "  h.mtx       h = B K^-1 f - (gap; 0; 0), f the loads\n"
          << (is_coulomb ? "  friction_coefficient.mtx   F, one for each node\n"
                         : "  slip_bound.mtx             g, one for each node\n");
      if (problem.areas.size() > 0)
        out << "  areas.mtx   area of each node; pressure = lambda_nu / "
               "area\n";
      if (problem.positions.size() > 0)
        out << "  nodes.mtx   x, y, z of each node\n";
      if (has_solution)
        out << "  lambda.mtx, gradient.mtx   lambda and r = Q lambda - h of "
               "the solution found\n";
      out << "\n"
          << hdf5_name
          << " (HDF5, the layout of FCLIB 3.1: "
             "https://frictionalcontactlibrary.github.io)\n"
             "A 'local' problem. Components interleaved: nu, t1, t2 of the "
             "first node, then of the\n"
             "second, ...; indices from 0.\n"
             "  /fclib_local/spacedim       3\n"
             "  /fclib_local/W              Q, every entry, by columns (nz = "
             "-1)\n"
             "  /fclib_local/vectors/q      -h\n"
          << (is_coulomb ? "  /fclib_local/vectors/mu     F\n"
                         : "  /fclib_local/vectors/mu     0: FCLIB does not know given "
                           "friction\n"
                           "  /fclib_local/given_slip_bound  g, not of FCLIB: with mu "
                           "alone it is another problem\n");
      if (problem.areas.size() > 0)
        out << "  /fclib_local/areas          areas of the nodes, not of "
               "FCLIB\n";
      if (problem.positions.size() > 0)
        out << "  /fclib_local/positions      x, y, z of each node, not of "
               "FCLIB\n";
      if (has_solution)
        out << "  /solution/r, /solution/u    lambda and r = Q lambda - h of "
               "the solution found\n";
    }
  } // namespace

  void export_problem(const std::string &directory, const DualProblem &problem,
                      const Eigen::VectorXd &lambda, const Eigen::VectorXd &gradient)
  {
    problem_check::require_writable(problem, lambda, gradient, directory);
    require_writable(directory, directory);
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error)
      throw InputError(directory + ": cannot be made, must be a directory "
                                   "that exists or can be made.");

    write_fclib(directory + "/" + hdf5_name, problem, lambda, gradient);
    write_matrix_market(directory, problem, lambda, gradient);
    write_file(directory + "/README.txt",
               [&](std::ostream &out) { write_readme(out, problem, lambda.size() > 0); });
  }

  DualProblem import_problem(const std::string &path, const bool symmetric_part)
  {
    namespace fs = std::filesystem;
    std::error_code error;
    if (fs::is_directory(path, error))
      {
        const fs::path hdf5 = fs::path(path) / hdf5_name;
        if (fs::exists(fs::path(path) / "Q.mtx", error))
          return read_matrix_market(path, symmetric_part);
        if (fs::exists(hdf5, error))
          return read_fclib(hdf5.string(), symmetric_part);
        throw InputError(path + ": holds no problem, must be a directory with "
                                "Q.mtx or problem.hdf5.");
      }

    const std::string extension = fs::path(path).extension().string();
    if (extension == ".mtx")
      return read_matrix_market(path, symmetric_part);
    if (extension == ".hdf5" || extension == ".h5")
      return read_fclib(path, symmetric_part);
    throw InputError(
      path + (fs::exists(path, error) ? ": is no problem file" : ": does not exist") +
      ", must be a directory, Q.mtx, or a file *.hdf5 or *.h5 "
      "of FCLIB.");
  }
} // namespace stiction
