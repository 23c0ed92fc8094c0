#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/base/text/read_line.h>
#include <stiction/base/text/text_scanner.h>
#include <stiction/output/problem/matrix_market.h>
#include <stiction/output/problem/problem_check.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>
#include <vector>

namespace stiction
{
  namespace
  {
    namespace fs = std::filesystem;
    using Eigen::Index;
    using problem_check::Allowed;

    constexpr const char *coulomb_name = "friction_coefficient.mtx";
    constexpr const char *given_name   = "slip_bound.mtx";

    // ------------------------------------------------------------- writing

    // Column by column, of a symmetric matrix the lower triangle.
    void write(const std::string &name, const Eigen::MatrixXd &matrix,
               const bool is_symmetric, const std::vector<std::string> &comments)
    {
      write_file(name, [&](std::ostream &out) {
        out << "%%MatrixMarket matrix array real "
            << (is_symmetric ? "symmetric" : "general") << '\n';
        for (const std::string &comment : comments)
          out << "% " << comment << '\n';
        out << matrix.rows() << ' ' << matrix.cols() << '\n';
        char number[32];
        for (Index j = 0; j < matrix.cols(); ++j)
          for (Index i = is_symmetric ? j : 0; i < matrix.rows(); ++i)
            {
              const int length =
                std::snprintf(number, sizeof(number), "%.16e\n", matrix(i, j));
              out.write(number, length);
            }
      });
    }

    void remove(const std::string &name)
    {
      std::error_code error;
      fs::remove(name, error);
      if (error)
        throw InputError(name + ": cannot be removed, though it does not "
                                "belong to this problem, must be in a "
                                "directory with the permission to write.");
    }

    // ------------------------------------------------------------- reading

    // The words of a file of a matrix.
    class Words : public TextScanner
    {
    public:
      explicit Words(const std::string &path)
        : TextScanner(path, path, "%") // which the first line begins with, too
        , path_(path)
      {
        if (!is_readable())
          throw InputError(path + ": cannot be read, must be a file that "
                                  "exists and may be read.");
        read_banner();
      }

      void require_next(const std::string &what)
      {
        if (!next_word())
          refuse_end(", must hold " + what);
      }

      // The word as a number.
      double number(const Allowed allowed) const
      {
        char *end          = nullptr;
        const double value = std::strtod(this_word().c_str(), &end);
        if (*end != '\0')
          fail("must be a number");
        problem_check::require(value, allowed, [&]() { return place() + ": the entry"; });
        if (is_integer_ && value != std::floor(value))
          fail("must be an integer, as the first line says");
        return value;
      }

      // The word as a size or an index.
      Index integer(const Index least, const Index most, const char *what) const
      {
        char *end             = nullptr;
        const long long value = std::strtoll(this_word().c_str(), &end,
                                             10); // too large: the largest
        if (*end != '\0' || value < least || value > most)
          fail("must be " + std::string(what) + ", an integer from " +
               std::to_string(least) + " to " + std::to_string(most));
        return value;
      }

      [[noreturn]] void fail(const std::string &must) const
      {
        constexpr std::size_t at_most = 40;
        std::string word              = this_word();
        if (word.size() > at_most)
          word = word.substr(0, at_most) + "...";
        refuse("'" + word + "' is not allowed, " + must);
      }

      [[noreturn]] void refuse_end(const std::string &rest) const
      {
        throw InputError(path_ + ", line " + std::to_string(line_number() + 1) +
                         ": the file ends" + rest + ".");
      }

      bool is_coordinate() const { return is_coordinate_; }

      bool is_symmetric() const { return is_symmetric_; }

    private:
      void read_banner()
      {
        const std::string banner = "%%MATRIXMARKET";
        const std::string rule =
          "must begin with '%%MatrixMarket matrix array real general', or "
          "with coordinate, integer, symmetric in place of the last three";

        // a binary file may be one long line
        std::ifstream in(path_);
        std::string text(banner.size(), ' ');
        const auto is_read = [&]() {
          return bool(in.read(text.data(), static_cast<std::streamsize>(text.size())));
        };
        if (!is_read() ||
            (text.rfind(byte_order_mark, 0) == 0 &&
             !(in.seekg(static_cast<std::streamoff>(byte_order_mark.size())) &&
               is_read())) ||
            upper(text) != banner)
          throw InputError(path_ + ", line 1: is no Matrix Market file, " + rule + ".");
        stiction::read_line(in, text);
        std::istringstream words(upper(text));
        std::string object, format, field, symmetry, more;
        words >> object >> format >> field >> symmetry >> more;
        is_coordinate_ = format == "COORDINATE";
        is_integer_    = field == "INTEGER";
        is_symmetric_  = symmetry == "SYMMETRIC";
        if (object != "MATRIX" || !(is_coordinate_ || format == "ARRAY") ||
            !(is_integer_ || field == "REAL" || field == "DOUBLE") ||
            !(is_symmetric_ || symmetry == "GENERAL") || !more.empty())
          throw InputError(path_ + ", line 1: another kind of Matrix Market file, " +
                           rule + ".");
      }

      const std::string path_;
      bool is_coordinate_ = false, is_integer_ = false, is_symmetric_ = false;
    };

    // A matrix and where its diagonal stands in the file.
    struct File
    {
      Eigen::MatrixXd matrix;
      std::vector<std::size_t> diagonal_lines;
    };

    struct Size
    {
      Index rows = 0, columns = 0, n_entries = 0;
    };

    // @param n_rows, n_columns what they have to be; 0: square, of an order 3, 6, ...
    Size read_size(Words &words, const Index n_rows, const Index n_columns,
                   const std::string &meaning)
    {
      constexpr Index largest_size = 1 << 30;

      words.require_next("the size of the matrix");
      const Index rows = words.integer(1, largest_size, "the number of rows");
      words.require_next("the number of columns");
      const Index columns    = words.integer(1, largest_size, "the number of columns");
      const std::string size = std::to_string(rows) + " x " + std::to_string(columns);
      const bool is_Q        = n_rows == 0;
      if (is_Q ? rows != columns || rows % 3 != 0
               : rows != n_rows || columns != n_columns)
        words.refuse("the matrix is " + size + ", must be " +
                     (is_Q ? std::string("square, of order 3, 6, 9, ...")
                           : std::to_string(n_rows) + " x " + std::to_string(n_columns)) +
                     ", " + meaning);
      if (words.is_symmetric() && rows != columns)
        words.refuse("the matrix is symmetric and " + size +
                     ", must be square or general");

      if (!words.is_coordinate())
        return {rows, columns,
                words.is_symmetric() ? rows * (rows + 1) / 2 : rows * columns};
      words.require_next("the number of entries");
      return {rows, columns,
              words.integer(is_Q ? rows : 0, largest_size * largest_size,
                            is_Q ? "the number of entries, with all of the diagonal"
                                 : "the number of entries")};
    }

    // A matrix of n_rows × n_columns; 0 × 0: square, of an order 3, 6, 9, ...
    File read(const std::string &path, const Index n_rows, const Index n_columns,
              const Allowed allowed, const std::string &meaning)
    {
      Words words(path);
      const auto [rows, columns, n_entries] =
        read_size(words, n_rows, n_columns, meaning);
      const bool is_Q = n_rows == 0;

      // Nothing is allocated for what the file cannot hold: an entry is at
      // least a digit and a blank.
      std::error_code error;
      const auto n_bytes = static_cast<double>(fs::file_size(path, error));
      if (!error && 2. * static_cast<double>(n_entries) > n_bytes + 1.)
        words.refuse("the file is too short for " + std::to_string(n_entries) +
                     " entries, must hold as many as are announced");
      if (is_Q)
        problem_check::require_memory(static_cast<double>(rows),
                                      words.place() + ": this");

      File file;
      file.matrix = Eigen::MatrixXd::Zero(rows, columns);
      if (is_Q)
        file.diagonal_lines.resize(rows);
      const auto require_next = [&, n = n_entries](const Index k) {
        if (!words.next_word())
          words.refuse_end(" after " + std::to_string(k) + " of " + std::to_string(n) +
                           " entries, must hold all of them");
      };
      Index i = 0, j = 0;
      for (Index k = 0; k < n_entries; ++k)
        {
          require_next(k);
          if (words.is_coordinate())
            {
              i = words.integer(1, rows, "a row") - 1;
              require_next(k);
              j = words.integer(1, words.is_symmetric() ? i + 1 : columns,
                                words.is_symmetric() ? "a column up to the diagonal"
                                                     : "a column") -
                  1;
              require_next(k);
            }
          const double value = words.number(allowed);
          if (words.is_coordinate())
            file.matrix(i, j) += value;
          else // a sum would lose the sign of -0
            file.matrix(i, j) = value;
          if (words.is_symmetric())
            file.matrix(j, i) = file.matrix(i, j);
          if (is_Q && i == j)
            file.diagonal_lines[i] = words.line_number();

          if (!words.is_coordinate() && ++i == rows)
            {
              ++j;
              i = words.is_symmetric() ? j : 0;
            }
        }
      if (words.next_word())
        words.fail("must be the end of the file after " + std::to_string(n_entries) +
                   " entries");
      return file;
    }

    Eigen::VectorXd read_vector(const std::string &path, const Index size,
                                const Allowed allowed, const std::string &meaning)
    {
      Eigen::VectorXd vector = read(path, size, 1, allowed, meaning).matrix;
      // entries that coordinates left out are 0
      problem_check::require_all(vector, allowed, [&](const Index i) {
        return path + ": entry " + std::to_string(i + 1);
      });
      return vector;
    }
  } // namespace

  void write_matrix_market(const std::string &directory, const DualProblem &problem,
                           const Eigen::VectorXd &lambda, const Eigen::VectorXd &gradient)
  {
    problem_check::require_writable(problem, lambda, gradient, directory);
    const std::string in = directory + "/";
    const std::string blocks =
      "By blocks: m normal components nu, m of the tangent t1, m of t2.";
    const std::string lengths =
      "Lengths and forces are in the units of the parameter file.";

    write(in + "Q.mtx", problem.Q, true,
          {"Q = B K^-1 B^T (m/N): how far the m contact nodes of an elastic body",
           "move under forces at them. Symmetric positive definite, order 3m.", blocks,
           lengths, "Stored: lower triangle, column by column."});
    write(in + "h.mtx", problem.h, false,
          {"h = B K^-1 f - (gap; 0; 0) (m), length 3m. " + blocks,
           "With contact forces lambda (N, compression positive),",
           "Q lambda - h = (remaining gap; -slip; -slip)."});

    const bool is_coulomb = problem.slip_bound.is_coulomb();
    write(in + (is_coulomb ? coulomb_name : given_name), problem.slip_bound.data(), false,
          is_coulomb
            ? std::vector<std::string>{"Coulomb friction: coefficient F of each of "
                                       "the m contact nodes,",
                                       "|(lambda_t1, lambda_t2)| <= F lambda_nu."}
            : std::vector<std::string>{
                "Given friction: slip bound g (N) of each of the m contact nodes,",
                "|(lambda_t1, lambda_t2)| <= g, whatever lambda_nu."});
    remove(in + (is_coulomb ? given_name : coulomb_name));

    const auto write_if_known = [&](const std::string &name,
                                    const Eigen::MatrixXd &values,
                                    const std::vector<std::string> &comments) {
      if (values.size() > 0)
        write(in + name, values, false, comments);
      else
        remove(in + name);
    };
    write_if_known("areas.mtx", problem.areas,
                   {"Area (m^2) of each of the m contact nodes; pressure = "
                    "lambda_nu / area."});
    write_if_known("nodes.mtx", problem.positions,
                   {"Positions (m) of the m contact nodes, columns x, y, z.",
                    "Stored: column by column."});
    write_if_known("lambda.mtx", lambda,
                   {"The solution lambda (N), length 3m. " + blocks});
    write_if_known("gradient.mtx", gradient,
                   {"Q lambda - h (m) of the solution, length 3m: (remaining "
                    "gap; -slip; -slip).",
                    blocks});
  }

  DualProblem read_matrix_market(const std::string &path, const bool symmetric_part)
  {
    std::error_code error;
    const bool is_directory  = fs::is_directory(path, error);
    const std::string Q_name = is_directory ? (fs::path(path) / "Q.mtx").string() : path;
    const fs::path directory = fs::path(Q_name).parent_path();
    const auto in = [&](const char *name) { return (directory / name).string(); };

    // What is quick to see before what is slow to read.
    const bool is_coulomb = fs::exists(in(coulomb_name), error);
    const bool is_given   = fs::exists(in(given_name), error);
    if (fs::exists(Q_name, error) && is_coulomb == is_given)
      throw InputError((directory.empty() ? "." : directory.string()) + ": holds " +
                       (is_coulomb ? "both " : "neither ") + coulomb_name +
                       (is_coulomb ? " and " : " nor ") + given_name +
                       ", must hold one of them: Coulomb or given friction.");

    File Q = read(Q_name, 0, 0, Allowed::number, "three rows for each contact node");
    DualProblem problem;
    problem.asymmetry = problem_check::make_symmetric(
      Q.matrix, symmetric_part, [&](const Index i, const Index j) {
        return Q_name +
               (i == j && Q.diagonal_lines[i] > 0
                  ? ", line " + std::to_string(Q.diagonal_lines[i])
                  : "") +
               ": the entry in row " + std::to_string(i + 1) + ", column " +
               std::to_string(j + 1);
      });
    const Index m              = Q.matrix.rows() / 3;
    const std::string per_node = "one row for each contact node";

    problem.h = read_vector(in("h.mtx"), 3 * m, Allowed::number, "as many rows as Q.mtx");
    problem.slip_bound =
      is_coulomb ? qp::SlipBound::coulomb(
                     read_vector(in(coulomb_name), m, Allowed::not_negative, per_node))
                 : qp::SlipBound::given(
                     read_vector(in(given_name), m, Allowed::not_negative, per_node));
    if (fs::exists(in("areas.mtx"), error))
      problem.areas = read_vector(in("areas.mtx"), m, Allowed::positive, per_node);
    if (fs::exists(in("nodes.mtx"), error))
      problem.positions = read(in("nodes.mtx"), m, 3, Allowed::number, per_node).matrix;
    problem.Q = std::move(Q.matrix);
    return problem;
  }
} // namespace stiction
