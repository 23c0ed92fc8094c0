#include <stiction/base/errors.h>
#include <stiction/output/problem/fclib.h>
#include <stiction/output/problem/fclib_layout.h>
#include <stiction/output/problem/problem_check.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <type_traits>
#include <vector>

namespace stiction
{
  using namespace fclib;

  namespace
  {
    using Eigen::Index;
    using problem_check::Allowed;

    class Reader
    {
    public:
      explicit Reader(const std::string &path)
        : path_(path)
        , file_(open(path), H5Fclose)
      {
      }

      [[noreturn]] void fail(const std::string &sentence) const
      {
        throw InputError(path_ + ": " + sentence + ".");
      }

      // The parents of the name must exist.
      bool has(const std::string &name) const
      {
        return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
      }

      void require_group(const std::string &name) const
      {
        const Handle opened(H5Gopen2(file_, name.c_str(), H5P_DEFAULT), H5Gclose);
        if (opened < 0)
          fail("group " + name + " is missing, must be as FCLIB writes it");
      }

      // Opens a dataset of so many numbers (integers).
      Handle open_numbers(const std::string &name, const Index size,
                          const std::string &meaning, const bool integers) const
      {
        const std::string must =
          ", must be " + std::to_string(size) + (integers ? " integer" : " number") +
          (size == 1 ? "" : "s") + (meaning.empty() ? "" : ", " + meaning);
        Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
        if (dataset < 0)
          fail("dataset " + name + " is missing" + must);

        const Handle type(H5Dget_type(dataset), H5Tclose);
        const H5T_class_t type_class = H5Tget_class(type);
        if (type_class != H5T_INTEGER && (integers || type_class != H5T_FLOAT))
          fail("dataset " + name + " is of another type" + must);

        const Handle space(H5Dget_space(dataset), H5Sclose);
        const hssize_t found = H5Sget_simple_extent_npoints(space);
        if (found != size)
          fail("dataset " + name + " has size " + std::to_string(found) + must);
        return dataset;
      }

      // Of a dataset that exists.
      void require_table(const std::string &name, const Index n_rows,
                         const Index n_columns) const
      {
        const Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
        const Handle space(H5Dget_space(dataset), H5Sclose);
        std::array<hsize_t, 2> size{};
        if (H5Sget_simple_extent_ndims(space) != 2 ||
            H5Sget_simple_extent_dims(space, size.data(), nullptr) != 2 ||
            size[0] != static_cast<hsize_t>(n_rows) ||
            size[1] != static_cast<hsize_t>(n_columns))
          fail("dataset " + name + " is of another shape, must be a table of " +
               std::to_string(n_rows) + " rows and " + std::to_string(n_columns) +
               " columns");
      }

      template<typename Number>
      void read_part(const hid_t dataset, const std::string &name, const Index begin,
                     std::vector<Number> &values) const
      {
        const hsize_t offset = begin;
        const hsize_t size   = values.size();
        const Handle file_space(H5Dget_space(dataset), H5Sclose);
        const Handle memory_space(H5Screate_simple(1, &size, nullptr), H5Sclose);
        if (H5Sget_simple_extent_ndims(file_space) != 1)
          fail("dataset " + name + " is a table, must be a list");
        if (H5Sselect_hyperslab(file_space, H5S_SELECT_SET, &offset, nullptr, &size,
                                nullptr) < 0 ||
            H5Dread(dataset, memory_type(values.data()), memory_space, file_space,
                    H5P_DEFAULT, values.data()) < 0)
          fail_to_read(name);
      }

      // All of it, any shape, in the order of the file.
      template<typename Number>
      std::vector<Number> read(const std::string &name, const Index size,
                               const std::string &meaning) const
      {
        const Handle dataset =
          open_numbers(name, size, meaning, !std::is_same_v<Number, double>);
        std::vector<Number> values(size);
        if (H5Dread(dataset, memory_type(values.data()), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                    values.data()) < 0)
          fail_to_read(name);
        return values;
      }

      long long integer(const std::string &name, const std::string &meaning = "") const
      {
        return read<long long>(name, 1, meaning)[0];
      }

      Eigen::VectorXd vector(const std::string &name, const Index size,
                             const std::string &meaning, const Allowed allowed) const
      {
        const std::vector<double> read_values = read<double>(name, size, meaning);
        Eigen::VectorXd values =
          Eigen::Map<const Eigen::VectorXd>(read_values.data(), size);
        problem_check::require_all(values, allowed,
                                   [&](const Index i) { return entry(name, i); });
        return values;
      }

      std::string entry(const std::string &name, const Index i) const
      {
        return path_ + ": dataset " + name + ", entry " + std::to_string(i) + " (from 0)";
      }

      const std::string &path() const { return path_; }

    private:
      static hid_t open(const std::string &path)
      {
        std::error_code error;
        if (std::filesystem::is_directory(path, error) ||
            !std::ifstream(path, std::ios::binary))
          throw InputError(path + ": cannot be read, must be a file that "
                                  "exists and may be read.");
        const hid_t file = H5Fis_hdf5(path.c_str()) > 0
                             ? H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)
                             : -1;
        if (file < 0)
          throw InputError(path + ": is no HDF5 file or a damaged one, must "
                                  "be an HDF5 file as FCLIB writes it.");
        return file;
      }

      static hid_t memory_type(const double *) { return H5T_NATIVE_DOUBLE; }

      static hid_t memory_type(const long long *) { return H5T_NATIVE_LLONG; }

      [[noreturn]] void fail_to_read(const std::string &name) const
      {
        fail("dataset " + name +
             " cannot be read, must not be damaged and not compressed in a "
             "way that this HDF5 does not know");
      }

      const std::string path_;
      const Handle file_;
    };

    // W as in the file: interleaved.
    class MatrixReader
    {
    public:
      MatrixReader(const Reader &reader)
        : reader_(reader)
      {
        const long long m = reader.integer(matrix + "/m");
        order_            = reader.integer(matrix + "/n");
        if (m != order_ || m < 3 || m % 3 != 0)
          reader.fail("datasets " + matrix + "/m and n are " + std::to_string(m) +
                      " and " + std::to_string(order_) +
                      ", must be equal and 3, 6, 9, ..., three for each contact node");
        kind_  = reader.integer(matrix + "/nz");
        n_max_ = reader.integer(matrix + "/nzmax");
        if (kind_ < -2)
          reader.fail("dataset " + matrix + "/nz is " + std::to_string(kind_) +
                      ", must be the number of triplets, -1 (by columns) or "
                      "-2 (by rows)");
        if (n_max_ < 1 || kind_ > n_max_)
          reader.fail("dataset " + matrix + "/nzmax is " + std::to_string(n_max_) +
                      ", must be the size of the dataset x, at least 1 and at least nz");
      }

      Index order() const { return order_; }

      // In our blocks.
      Eigen::MatrixXd read()
      {
        problem_check::require_memory(static_cast<double>(order_),
                                      reader_.path() + ": group " + matrix);
        std::vector<long long> begin; // of each column or row
        Index count             = kind_;
        const bool are_triplets = kind_ >= 0;
        if (!are_triplets)
          {
            begin = reader_.read<long long>(matrix + "/p", order_ + 1,
                                            "one more than the order");
            for (Index j = 0; j <= order_; ++j)
              if (begin[j] < (j == 0 ? 0 : begin[j - 1]) ||
                  begin[j] > (j == 0 ? 0 : n_max_))
                reader_.fail("dataset " + matrix + "/p, entry " + std::to_string(j) +
                             " (from 0) is " + std::to_string(begin[j]) +
                             ", must begin with 0, never fall, and end with "
                             "at most nzmax = " +
                             std::to_string(n_max_));
            count = begin[order_];
          }
        const std::string as_nz = "as nz says", as_max = "as nzmax says";
        const Handle x = reader_.open_numbers(matrix + "/x", n_max_, as_max, false);
        const Handle i =
          reader_.open_numbers(matrix + "/i", are_triplets ? count : n_max_,
                               are_triplets ? as_nz : as_max, true);
        // of triplets only: what p is otherwise, is known already
        const Handle p =
          reader_.open_numbers(matrix + "/p", are_triplets ? count : order_ + 1,
                               are_triplets ? as_nz : "", true);

        Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(order_, order_);
        std::vector<double> values;
        std::vector<long long> first, second;
        Index line = 0;
        for (Index offset = 0; offset < count; offset += batch)
          {
            const Index size = std::min(batch, count - offset);
            values.resize(size);
            second.resize(size);
            reader_.read_part(x, matrix + "/x", offset, values);
            reader_.read_part(i, matrix + "/i", offset, second);
            require_indices("i", second, offset);
            if (are_triplets)
              {
                first.resize(size);
                reader_.read_part(p, matrix + "/p", offset, first);
                require_indices("p", first, offset);
              }
            for (Index k = 0; k < size; ++k)
              {
                problem_check::require(values[k], Allowed::number, [&]() {
                  return reader_.entry(matrix + "/x", offset + k);
                });
                if (!are_triplets)
                  while (begin[line + 1] <= offset + k)
                    ++line;
                // triplets: p rows, i columns; by columns: i rows; by rows: i
                // columns
                const Index a = are_triplets ? first[k] : line;
                const Index b = second[k];
                Index row     = in_blocks(a, order_);
                Index column  = in_blocks(b, order_);
                if (kind_ == -1)
                  std::swap(row, column);
                Q(row, column) += values[k];
              }
          }
        return Q;
      }

    private:
      void require_indices(const std::string &name, const std::vector<long long> &indices,
                           const Index offset) const
      {
        for (std::size_t k = 0; k < indices.size(); ++k)
          if (indices[k] < 0 || indices[k] >= order_)
            throw InputError(
              reader_.entry(matrix + "/" + name, offset + static_cast<Index>(k)) +
              " is " + std::to_string(indices[k]) + ", must be from 0 to " +
              std::to_string(order_ - 1) + ".");
      }

      const Reader &reader_;
      long long order_ = 0, kind_ = 0, n_max_ = 0;
    };
  } // namespace

  DualProblem read_fclib(const std::string &path, const bool symmetric_part)
  {
    const Silence silence;
    const Reader reader(path);

    if (!reader.has(group))
      reader.fail(reader.has("/fclib_global")
                    ? "holds a global problem of FCLIB (/fclib_global), must "
                      "hold a local one (" +
                        group + ")"
                    : "group " + group +
                        " is missing, must be a local problem as FCLIB writes it");
    reader.require_group(group);
    const long long dim = reader.integer(group + "/spacedim");
    if (dim != 3)
      reader.fail("dataset " + group + "/spacedim is " + std::to_string(dim) +
                  ", must be 3");
    reader.require_group(matrix);
    reader.require_group(group + "/vectors");
    for (const std::string name : {"/V", "/R", "/vectors/s"})
      if (reader.has(group + name))
        reader.fail(group + name +
                    " makes it a mixed problem with equality constraints, "
                    "must be absent");

    MatrixReader W(reader);
    const Index n              = W.order();
    const Index m              = n / 3;
    const std::string per_node = "one for each contact node";

    DualProblem problem;
    const Eigen::VectorXd q = reader.vector(
      group + "/vectors/q", n, "three for each contact node", Allowed::number);
    problem.h.resize(n);
    for (Index k = 0; k < n; ++k)
      problem.h(in_blocks(k, n)) = -q(k);

    const Eigen::VectorXd mu =
      reader.vector(group + "/vectors/mu", m, per_node, Allowed::not_negative);
    if (reader.has(given_bound))
      {
        for (Index i = 0; i < m; ++i)
          if (mu(i) != 0.)
            throw InputError(reader.entry(group + "/vectors/mu", i) + " is " +
                             problem_check::text(mu(i)) +
                             ", must be 0 where there is a dataset " + given_bound + ".");
        problem.slip_bound = qp::SlipBound::given(
          reader.vector(given_bound, m, per_node, Allowed::not_negative));
      }
    else
      problem.slip_bound = qp::SlipBound::coulomb(mu);

    if (reader.has(areas))
      problem.areas = reader.vector(areas, m, per_node, Allowed::positive);
    if (reader.has(positions))
      {
        reader.require_table(positions, m, 3);
        const Eigen::VectorXd by_rows =
          reader.vector(positions, n, "three for each contact node", Allowed::number);
        problem.positions.resize(m, 3);
        for (Index k = 0; k < n; ++k)
          problem.positions(k / 3, k % 3) = by_rows(k);
      }

    problem.Q         = W.read();
    problem.asymmetry = problem_check::make_symmetric(
      problem.Q, symmetric_part, [&](const Index i, const Index j) {
        const auto interleaved_index = [m](const Index k) {
          return std::to_string(k % m * 3 + k / m);
        };
        return path + ": group " + matrix + ", row " + interleaved_index(i) +
               ", column " + interleaved_index(j) + " (from 0)";
      });
    return problem;
  }
} // namespace stiction
