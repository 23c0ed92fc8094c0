// What is written as Matrix Market files is read back to the last bit; the
// other storages of the format say the same; each file that is no such problem
// gets one sentence with its line.

#include <stiction/output/problem/matrix_market.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <sstream>

#include "problem_tests.h"

using namespace stiction;
using namespace problem_tests;

namespace
{
  const std::string directory = "results/problem";

  std::string read_text(const std::string &file)
  {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  // One node, easy numbers, every file in another storage.
  void write_small_problem()
  {
    std::filesystem::remove_all(directory);
    std::filesystem::create_directories(directory);
    write_text(directory + "/Q.mtx", "%%MatrixMarket matrix coordinate real symmetric\n"
                                     "% one node\n"
                                     "\n"
                                     "3 3 4\n"
                                     "1 1 4.0\n"
                                     "2 2 5e0\n"
                                     "3 1 -1\n"
                                     "3 3 6\n");
    write_text(directory + "/h.mtx", "%%matrixmarket MATRIX Array Integer General\r\n"
                                     "3 1\r\n"
                                     "1 +2 -3\r\n");
    write_text(directory + "/friction_coefficient.mtx",
               "\xef\xbb\xbf%%MatrixMarket matrix array real symmetric\r1 1\r0.25");
  }

  void refused_text(const std::string &what, const std::string &file,
                    const std::string &text)
  {
    write_small_problem();
    write_text(directory + "/" + file, text);
    refused(what, []() { read_matrix_market(directory); });
  }

  void round_trips()
  {
    std::filesystem::create_directories(directory);
    for (const bool coulomb : {true, false})
      for (const bool with_mesh : {true, false})
        for (const Index m : {1, 2, 30})
          {
            // into one directory: nothing of the last problem is left
            const DualProblem problem    = some_problem(m, coulomb, with_mesh);
            const Eigen::VectorXd lambda = random(3 * m, 1, -1.);
            if (m != 2)
              write_matrix_market(directory, problem);
            else
              write_matrix_market(directory, problem, lambda,
                                  problem.Q * lambda - problem.h);
            std::cout << (coulomb ? "Coulomb" : "given") << ", " << m
                      << (m == 1 ? " node" : " nodes")
                      << (with_mesh ? ", areas and positions" : "") << ": same bits "
                      << yes(same_bits(problem, read_matrix_market(directory)) &&
                             same_bits(problem, read_matrix_market(directory + "/Q.mtx")))
                      << ", solution only if there is one "
                      << yes(std::filesystem::exists(directory + "/lambda.mtx") ==
                             (m == 2))
                      << std::endl;
          }
  }

  void storages()
  {
    write_small_problem();
    const DualProblem small = read_matrix_market(directory);
    std::cout << "small problem\nQ\n"
              << small.Q << "\nh\n"
              << small.h.transpose() << "\nF\n"
              << small.slip_bound.data() << std::endl;

    DualProblem problem;
    problem.Q          = small.Q;
    problem.h          = small.h;
    problem.slip_bound = qp::SlipBound::given(Eigen::VectorXd::Ones(1));
    write_matrix_market(directory, problem);
    std::cout << "Q.mtx is written as\n" << read_text(directory + "/Q.mtx");

    const std::string general =
      "%%MatrixMarket matrix array real general\n3 3\n4 0 -1\n0 5 0\n-1 0 6\n";
    const std::string coordinates =
      "%%MatrixMarket matrix coordinate integer general\n3 3 6\n"
      "1 1 4\n3 1 -1\n1 3 -1\n2 2 3\n2 2 2\n3 3 6\n";
    for (const std::string &text : {general, coordinates})
      {
        write_text(directory + "/Q.mtx", text);
        std::cout << "the same " << yes(read_matrix_market(directory).Q == small.Q)
                  << std::endl;
      }
  }

  void refusals()
  {
    const std::string array      = "%%MatrixMarket matrix array real general\n";
    const std::string symmetric  = "%%MatrixMarket matrix array real symmetric\n";
    const std::string coordinate = "%%MatrixMarket matrix coordinate real general\n";

    std::filesystem::remove_all(directory);
    refused("no directory", []() { read_matrix_market(directory); });
    std::filesystem::create_directories(directory);
    refused("an empty directory", []() { read_matrix_market(directory); });
    write_small_problem();
    std::filesystem::remove(directory + "/h.mtx");
    refused("no h", []() { read_matrix_market(directory); });
    write_small_problem();
    std::filesystem::remove(directory + "/friction_coefficient.mtx");
    refused("no law", []() { read_matrix_market(directory); });
    refused_text("both laws", "slip_bound.mtx", array + "1 1\n0\n");

    refused_text("empty", "Q.mtx", "");
    refused_text("binary", "Q.mtx", std::string(100, '\0'));
    refused_text("a table", "Q.mtx", "4 0 0\n0 5 0\n0 0 6\n");
    for (const std::string kind :
         {"matrix array complex general", "matrix coordinate pattern general",
          "matrix array real skew-symmetric", "vector array real general",
          "matrix array real"})
      refused_text(kind, "Q.mtx", "%%MatrixMarket " + kind + "\n3 3\n");
    refused_text("only the head", "Q.mtx", array + "% nothing\n");
    refused_text("half a size", "Q.mtx", array + "3\n");
    refused_text("size no number", "Q.mtx", array + "three 3\n");
    refused_text("size negative", "Q.mtx", array + "-3 -3\n");
    refused_text("not square", "Q.mtx", array + "3 6\n");
    refused_text("order 4", "Q.mtx", array + "4 4\n");
    refused_text("size 0", "Q.mtx", array + "0 0\n");
    refused_text("very large", "Q.mtx", symmetric + "999999999 999999999\n1\n");
    refused_text("too short", "Q.mtx",
                 array + "3 3\n4.00000000000000\n0\n0\n% pause\n0\n5\n");
    refused_text("too long", "Q.mtx", array + "3 3\n4 0 0\n0 5 0\n0 0 6\n7\n");
    refused_text("no number", "Q.mtx", array + "3 3\n4 0 0\n0 5,0 0\n0 0 6\n");
    refused_text("no number, long", "Q.mtx",
                 array + "3 3\n" + std::string(1000, 'x') + "\n");
    refused_text("NaN", "Q.mtx", array + "3 3\n4 0 0\n0 5 nan\n0 0 6\n");
    refused_text("infinite", "Q.mtx", array + "3 3\n4 0 0\n0 1e999 0\n0 0 6\n");
    refused_text("diagonal negative", "Q.mtx", symmetric + "3 3\n4 0 0\n-5 0\n6\n");
    refused_text("diagonal 0", "Q.mtx", array + "3 3\n4 0 0\n0 5 0\n0 0 0\n");
    refused_text("unsymmetric", "Q.mtx", array + "3 3\n4 0 0\n1e-3 5 0\n0 0 6\n");
    refused_text("row too large", "Q.mtx", coordinate + "3 3 3\n1 1 4\n2 2 5\n4 3 6\n");
    refused_text("row 0", "Q.mtx", coordinate + "3 3 3\n1 1 4\n0 2 5\n3 3 6\n");
    refused_text("above the diagonal", "Q.mtx",
                 "%%MatrixMarket matrix coordinate real symmetric\n"
                 "3 3 3\n1 1 4\n2 3 5\n3 3 6\n");
    refused_text("too few for the diagonal", "Q.mtx",
                 coordinate + "3 3 2\n1 1 4\n2 2 5\n");
    refused_text("diagonal missing", "Q.mtx",
                 coordinate + "3 3 3\n1 1 4\n2 2 5\n2 2 6\n");

    refused_text("h too short", "h.mtx", array + "2 1\n1\n2\n");
    refused_text("h a row", "h.mtx", array + "1 3\n1 2 3\n");
    refused_text("not integer", "h.mtx",
                 "%%MatrixMarket matrix array integer general\n3 1\n1\n2.5\n3\n");
    refused_text("F negative", "friction_coefficient.mtx", array + "1 1\n-0.3\n");
    refused_text("area 0", "areas.mtx", coordinate + "1 1 0\n");
    refused_text("nodes in two dimensions", "nodes.mtx", array + "1 2\n0\n0\n");

    refused("no contact node", []() { write_matrix_market(directory, DualProblem()); });
    refused("not to be written", []() {
      write_matrix_market("results/nowhere", some_problem(1, true, false));
    });
  }
} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  round_trips();
  storages();
  refusals();
}
