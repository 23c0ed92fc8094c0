// What is written in FCLIB's layout is read back to the last bit, components
// being interleaved in between; all three kinds of sparse matrix say the same;
// each file that is no such problem gets one sentence, and HDF5 is silent.

#include <stiction/output/problem/fclib.h>

#include <deal.II/base/mpi.h>

#include <hdf5.h>

#include <filesystem>
#include <limits>
#include <vector>

#include "problem_tests.h"

using namespace stiction;
using namespace problem_tests;

namespace
{
  const std::string local = "/fclib_local/";

  // A file that is edited.
  class Editor
  {
  public:
    explicit Editor(const std::string &file)
      : file_(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT))
    {
    }

    ~Editor() { H5Fclose(file_); }

    Editor(const Editor &)            = delete;
    Editor &operator=(const Editor &) = delete;

    void remove(const std::string &name)
    {
      if (H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0)
        H5Ldelete(file_, name.c_str(), H5P_DEFAULT);
    }

    void add_group(const std::string &name)
    {
      H5Gclose(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    }

    void set(const std::string &name, const std::vector<double> &values,
             const hid_t type = H5T_IEEE_F64LE, std::vector<hsize_t> sizes = {})
    {
      remove(name);
      if (sizes.empty())
        sizes = {values.size()};
      const hid_t space =
        H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
      const hid_t dataset = H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT,
                                       H5P_DEFAULT, H5P_DEFAULT);
      if (H5Tget_class(type) != H5T_STRING)
        H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                 values.data());
      H5Dclose(dataset);
      H5Sclose(space);
    }

    void set_integers(const std::string &name, const std::vector<double> &values)
    {
      set(name, values, H5T_STD_I32LE);
    }

    std::vector<double> get(const std::string &name)
    {
      const hid_t dataset = H5Dopen2(file_, name.c_str(), H5P_DEFAULT);
      const hid_t space   = H5Dget_space(dataset);
      std::vector<double> values(H5Sget_simple_extent_npoints(space));
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      H5Sclose(space);
      H5Dclose(dataset);
      return values;
    }

  private:
    const hid_t file_;
  };

  // An edited copy of the file of a problem with 2 nodes.
  void refused_edit(const std::string &what, const bool coulomb,
                    const std::function<void(Editor &)> &edit)
  {
    const std::string file = "results/edited.hdf5";
    write_fclib(file, some_problem(2, coulomb, true));
    {
      Editor editor(file);
      edit(editor);
    }
    refused(what, [&]() { read_fclib(file); });
  }

  void refused_entry(const std::string &what, const std::string &name,
                     const unsigned int entry, const double value,
                     const bool coulomb = true)
  {
    refused_edit(what, coulomb, [&](Editor &editor) {
      std::vector<double> values = editor.get(local + name);
      values[entry]              = value;
      if (name == "W/i" || name == "W/p")
        editor.set_integers(local + name, values);
      else
        editor.set(local + name, values);
    });
  }

  void round_trips()
  {
    for (const bool coulomb : {true, false})
      for (const bool with_mesh : {true, false})
        // 100 nodes: more entries than pass at a time
        for (const Index m : {1, 2, 100})
          {
            const DualProblem problem    = some_problem(m, coulomb, with_mesh);
            const Eigen::VectorXd lambda = random(3 * m, 1, -1.);
            write_fclib("results/problem.hdf5", problem, lambda,
                        problem.Q * lambda - problem.h);
            const DualProblem back = read_fclib("results/problem.hdf5");
            std::cout << (coulomb ? "Coulomb" : "given") << ", " << m
                      << (m == 1 ? " node" : " nodes")
                      << (with_mesh ? ", areas and positions" : "") << ": same bits "
                      << yes(same_bits(problem, back)) << std::endl;
          }
  }

  void interleaving()
  {
    const DualProblem problem = some_problem(2, true, false);
    Eigen::VectorXd lambda(6);
    lambda << 1., 2., 3., 4., 5., 6.;
    write_fclib("results/problem.hdf5", problem, lambda, 10. * lambda);
    Editor editor("results/problem.hdf5");
    std::cout << "lambda = (1 2; 3 4; 5 6) is stored as";
    for (const double value : editor.get("/solution/r"))
      std::cout << ' ' << value;
    std::cout << "\n10 times that as";
    for (const double value : editor.get("/solution/u"))
      std::cout << ' ' << value;

    const auto x = editor.get(local + "W/x");
    const auto q = editor.get(local + "vectors/q");
    std::cout << "\nW(1, 2) is Q of t1 and t2 of the first node "
              << yes(x[2 * 6 + 1] == problem.Q(2, 4))
              << ", q(3) is -h of nu of the second " << yes(q[3] == -problem.h(1))
              << std::endl;
  }

  // By rows, as triplets in any order with one there twice, and not quite
  // symmetric.
  void kinds()
  {
    const DualProblem problem = some_problem(2, true, false);
    const std::string file    = "results/kinds.hdf5";
    write_fclib(file, problem);
    {
      Editor editor(file);
      editor.set_integers(local + "W/nz", {-2});
    }
    std::cout << "by rows: same bits " << yes(same_bits(problem, read_fclib(file)));

    {
      Editor editor(file);
      const std::vector<double> x = editor.get(local + "W/x");
      std::vector<double> rows, columns, values;
      for (int k = 35; k >= 0; --k) // any order
        {
          columns.push_back(k / 6);
          rows.push_back(k % 6);
          values.push_back(k == 35 ? 0.25 * x[k] : x[k]);
        }
      rows.push_back(5);
      columns.push_back(5);
      values.push_back(0.75 * x[35]);
      values.resize(40, 0.); // beyond nz there may be room
      editor.set_integers(local + "W/nz", {37});
      editor.set_integers(local + "W/nzmax", {40});
      editor.set_integers(local + "W/p", rows);
      editor.set_integers(local + "W/i", columns);
      editor.set(local + "W/x", values);
    }
    const DualProblem triplets = read_fclib(file);
    std::cout << "\ntriplets: same to rounding "
              << yes((triplets.Q - problem.Q).norm() < 1e-15 * problem.Q.norm());

    write_fclib(file, problem);
    {
      Editor editor(file);
      auto x = editor.get(local + "W/x");
      x[1] += 1e-9 * x[0];
      editor.set(local + "W/x", x);
    }
    const DualProblem nearly = read_fclib(file);
    std::cout << "\nsymmetric to 1e-9: accepted, made symmetric "
              << yes(nearly.Q == nearly.Q.transpose() && nearly.Q != problem.Q)
              << std::endl;
  }

  void refusals()
  {
    refused("no such file", []() { read_fclib("results/none.hdf5"); });
    refused("a directory", []() { read_fclib("results"); });
    write_text("results/text.hdf5", "# no HDF5\n");
    refused("a text", []() { read_fclib("results/text.hdf5"); });
    write_fclib("results/half.hdf5", some_problem(2, true, true));
    std::filesystem::resize_file("results/half.hdf5",
                                 std::filesystem::file_size("results/half.hdf5") / 2);
    refused("half a file", []() { read_fclib("results/half.hdf5"); });

    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();

    refused_edit("no problem", true,
                 [](Editor &editor) { editor.remove("/fclib_local"); });
    refused_edit("a global problem", true, [](Editor &editor) {
      editor.remove("/fclib_local");
      editor.add_group("/fclib_global");
    });
    refused_edit("no group", true,
                 [](Editor &editor) { editor.set("/fclib_local", {1.}); });
    refused_edit("two dimensions", true,
                 [](Editor &editor) { editor.set_integers(local + "spacedim", {2}); });
    refused_edit("no dimension", true,
                 [](Editor &editor) { editor.remove(local + "spacedim"); });
    for (const std::string name : {"V", "R", "vectors/s"})
      refused_edit("mixed, " + name, true,
                   [&](Editor &editor) { editor.add_group(local + name); });

    refused_edit("no W", true, [](Editor &editor) { editor.remove(local + "W"); });
    refused_edit("W not square", true,
                 [](Editor &editor) { editor.set_integers(local + "W/n", {3}); });
    refused_edit("W of order 4", true, [](Editor &editor) {
      editor.set_integers(local + "W/m", {4});
      editor.set_integers(local + "W/n", {4});
    });
    refused_edit("W of order 0", true, [](Editor &editor) {
      editor.set_integers(local + "W/m", {0});
      editor.set_integers(local + "W/n", {0});
    });
    refused_edit("unknown kind", true,
                 [](Editor &editor) { editor.set_integers(local + "W/nz", {-3}); });
    refused_edit("more triplets than room", true,
                 [](Editor &editor) { editor.set_integers(local + "W/nz", {37}); });
    refused_edit("x too short", true, [](Editor &editor) {
      editor.set(local + "W/x", std::vector<double>(35, 1.));
    });
    refused_edit("no i", true, [](Editor &editor) { editor.remove(local + "W/i"); });
    refused_edit("i not integer", true, [](Editor &editor) {
      editor.set(local + "W/i", std::vector<double>(36, 1.));
    });
    refused_edit("x a table", true, [](Editor &editor) {
      editor.set(local + "W/x", std::vector<double>(36, 1.), H5T_IEEE_F64LE, {6, 6});
    });
    refused_entry("index too large", "W/i", 7, 6);
    refused_entry("index negative", "W/i", 7, -1);
    refused_entry("p begins with 1", "W/p", 0, 1);
    refused_entry("p falls", "W/p", 3, 30);
    refused_entry("p too large", "W/p", 6, 37);
    refused_entry("NaN in W", "W/x", 8, nan);
    refused_entry("unsymmetric", "W/x", 8, 1e-9);
    refused_edit("unsymmetric, by rows", true, [](Editor &editor) {
      editor.set_integers(local + "W/nz", {-2});
      auto x = editor.get(local + "W/x");
      x[8]   = 1e-9;
      editor.set(local + "W/x", x);
    });
    refused_entry("diagonal negative", "W/x", 7, -1e-9);
    refused_entry("diagonal 0", "W/x", 7, 0.);

    refused_edit("q too short", true, [](Editor &editor) {
      editor.set(local + "vectors/q", {1., 2., 3.});
    });
    refused_edit("no q", true,
                 [](Editor &editor) { editor.remove(local + "vectors/q"); });
    refused_edit("no vectors", true,
                 [](Editor &editor) { editor.remove(local + "vectors"); });
    refused_edit("q of strings", true, [](Editor &editor) {
      editor.set(local + "vectors/q", std::vector<double>(6), H5T_C_S1);
    });
    refused_entry("infinite q", "vectors/q", 5, -inf);
    refused_entry("mu negative", "vectors/mu", 1, -0.3);
    refused_entry("mu NaN", "vectors/mu", 0, nan);
    refused_edit("mu for each component", true, [](Editor &editor) {
      editor.set(local + "vectors/mu", std::vector<double>(6, 0.3));
    });
    refused_entry("both laws", "vectors/mu", 1, 0.3, false);
    refused_entry("slip bound negative", "given_slip_bound", 0, -1., false);
    refused_entry("area 0", "areas", 1, 0.);
    refused_edit("positions 3 x m", true, [](Editor &editor) {
      editor.set(local + "positions", std::vector<double>(6, 1.), H5T_IEEE_F64LE, {3, 2});
    });

    refused("no contact node", []() { write_fclib("results/none.hdf5", DualProblem()); });
    refused("not to be written", []() {
      write_fclib("results/nowhere/a.hdf5", some_problem(1, true, false));
    });
    std::cout << "no file of that: "
              << yes(!std::filesystem::exists("results/none.hdf5") &&
                     !std::filesystem::exists("results/nowhere"))
              << std::endl;

    // a small file may say that it is a large matrix
    const std::string file = "results/edited.hdf5";
    write_fclib(file, some_problem(2, true, false));
    {
      Editor editor(file);
      const unsigned int n = 3000000;
      editor.set_integers(local + "W/m", {double(n)});
      editor.set_integers(local + "W/n", {double(n)});
      editor.set_integers(local + "W/nz", {36});
      editor.set(local + "vectors/q", std::vector<double>(n));
      editor.set(local + "vectors/mu", std::vector<double>(n / 3));
    }
    std::string message;
    try
      {
        read_fclib(file);
      }
    catch (const InputError &error)
      {
        message = error.what();
      }
    std::cout << "72 TB are more than the memory: "
              << yes(message.find("72000 GB") != std::string::npos) << std::endl;
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::create_directories("results");
  round_trips();
  interleaving();
  kinds();
  refusals();
}
