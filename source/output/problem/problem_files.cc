#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/output/problem/fclib.h>
#include <stiction/output/problem/matrix_market.h>
#include <stiction/output/problem/problem_check.h>
#include <stiction/output/problem/problem_files.h>

#include <filesystem>
#include <map>
#include <ostream>
#include <sstream>

namespace stiction
{
  namespace
  {
    constexpr const char *hdf5_name = "problem.hdf5";

    // README.txt from its third line on. What stands before the bar is what a
    // line is for: Coulomb friction (C) or given friction (G), known areas (A),
    // known positions (P), a known solution (S).
    constexpr const char *readme = R"( |
 |THE PROBLEM
 |Find contact forces lambda such that, with r = Q lambda - h, at each node
 |  normal      lambda_nu >= 0, r_nu >= 0, lambda_nu r_nu = 0
 |  tangential  |lambda_t| <= g; r_t = 0 where |lambda_t| < g; and in any case
 |              g r_t = -|r_t| lambda_t (where g = 0, r_t is free)
C|  slip bound  g = F lambda_nu, F the coefficient of friction
C|This is a fixed point, not a minimisation.
G|  slip bound  g is given at each node, also where it is open
G|This is: minimise lambda.Q lambda / 2 - lambda.h subject to the bounds on lambda.
 |
 |SIGNS
 |  lambda_nu   normal force, compression positive
 |  lambda_t    tangential force of the body on the obstacle
 |  r           (remaining gap; -slip in t1; -slip in t2)
 |  nu, t1, t2  unit normal towards the obstacle and tangents of the node, t2 = t1 x nu
 |              (the ellipse of orthotropic friction is scaled to a disc: entries t2 of
 |              lambda are divided and those of r multiplied by F2/F1; entries in held
 |              directions are 0)
 |
 |UNITS
 |lambda and g are forces, h and r lengths, Q length per force, areas length^2, in
 |the units of the parameter file.
 |
 |MATRIX MARKET FILES (text, 17 significant digits)
 |Vectors by blocks: all nu, then all t1, then all t2. Dense ('array'), column by
 |column; Q, being symmetric, as its lower triangle.
 |  Q.mtx       Q = B K^-1 B^T, K the stiffness of the body, B the contact components
 |  h.mtx       h = B K^-1 f - (gap; 0; 0), f the loads
C|  friction_coefficient.mtx   F, one for each node
G|  slip_bound.mtx             g, one for each node
A|  areas.mtx   area of each node; pressure = lambda_nu / area
P|  nodes.mtx   x, y, z of each node
S|  lambda.mtx, gradient.mtx   lambda and r = Q lambda - h of the solution found
 |
 |problem.hdf5 (HDF5, the layout of FCLIB 3.1: https://frictionalcontactlibrary.github.io)
 |A 'local' problem. Components interleaved: nu, t1, t2 of the first node, then of the
 |second, ...; indices from 0.
 |  /fclib_local/spacedim       3
 |  /fclib_local/W              Q, every entry, by columns (nz = -1)
 |  /fclib_local/vectors/q      -h
C|  /fclib_local/vectors/mu     F
G|  /fclib_local/vectors/mu     0: FCLIB does not know given friction
G|  /fclib_local/given_slip_bound  g, not of FCLIB: with mu alone it is another problem
A|  /fclib_local/areas          areas of the nodes, not of FCLIB
P|  /fclib_local/positions      x, y, z of each node, not of FCLIB
S|  /solution/r, /solution/u    lambda and r = Q lambda - h of the solution found
)";

    void write_readme(std::ostream &out, const DualProblem &problem,
                      const bool has_solution)
    {
      const bool is_coulomb = problem.slip_bound.is_coulomb();
      out << "A discrete contact problem with " << (is_coulomb ? "Coulomb" : "given")
          << " friction, " << problem.slip_bound.n_nodes()
          << " contact nodes\nwritten by stiction " STICTION_VERSION "\n";
      const std::map<char, bool> is_for = {{' ', true},
                                           {'C', is_coulomb},
                                           {'G', !is_coulomb},
                                           {'A', problem.areas.size() > 0},
                                           {'P', problem.positions.size() > 0},
                                           {'S', has_solution}};
      std::istringstream lines(readme);
      for (std::string line; std::getline(lines, line);)
        if (is_for.at(line[0]))
          out << line.substr(2) << '\n';
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
      ", must be a directory, Q.mtx, or a file *.hdf5 or *.h5 of FCLIB.");
  }
} // namespace stiction
