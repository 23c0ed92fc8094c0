#include <stiction/base/errors.h>
#include <stiction/base/files.h>
#include <stiction/output/problem/fclib.h>
#include <stiction/output/problem/fclib_layout.h>
#include <stiction/output/problem/problem_check.h>

#include <algorithm>
#include <limits>
#include <new>
#include <ostream>
#include <type_traits>
#include <vector>

namespace stiction
{
  using namespace fclib;

  namespace
  {
    using Eigen::Index;

    // HDF5 in memory fails for one reason.
    template<typename Result> Result checked(const Result result)
    {
      if (result < 0)
        throw std::bad_alloc();
      return result;
    }

    // An HDF5 file in memory. HDF5 does not take a full disk well: it tries
    // again when the program ends. So the bytes are written by ourselves.
    class Image
    {
    public:
      explicit Image(const std::size_t expected_size)
        : file_(create(expected_size), H5Fclose)
      {
      }

      void add_group(const std::string &name)
      {
        const Handle created(
          checked(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)),
          H5Gclose);
      }

      // Entries to be written by parts; chunk = 0: not compressed.
      Handle add_dataset(const std::string &name, const hid_t type,
                         const std::vector<hsize_t> &size, const hsize_t chunk = 0)
      {
        const Handle space(
          checked(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr)),
          H5Sclose);
        const Handle properties(checked(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
        if (chunk > 0 && H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0)
          {
            checked(H5Pset_chunk(properties, 1, &chunk));
            checked(H5Pset_deflate(properties, 4));
          }
        return {checked(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT,
                                   properties, H5P_DEFAULT)),
                H5Dclose};
      }

      template<typename Number>
      static void write_part(const hid_t dataset, const hsize_t begin,
                             const std::vector<Number> &values)
      {
        const hsize_t size = values.size();
        const Handle file_space(checked(H5Dget_space(dataset)), H5Sclose);
        const Handle memory_space(checked(H5Screate_simple(1, &size, nullptr)), H5Sclose);
        checked(H5Sselect_hyperslab(file_space, H5S_SELECT_SET, &begin, nullptr, &size,
                                    nullptr));
        checked(H5Dwrite(
          dataset, std::is_same<Number, int>::value ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE,
          memory_space, file_space, H5P_DEFAULT, values.data()));
      }

      void add(const std::string &name, const std::vector<int> &values)
      {
        add(name, H5T_STD_I32LE, H5T_NATIVE_INT, {values.size()}, values.data());
      }

      // A list, or a table row by row.
      void add(const std::string &name, const Eigen::MatrixXd &values)
      {
        std::vector<hsize_t> size(1, values.rows());
        if (values.cols() > 1)
          size.push_back(values.cols());
        const Eigen::MatrixXd rows_first = values.transpose();
        add(name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, size, rows_first.data());
      }

      void add(const std::string &name, const std::string &text)
      {
        const Handle type(checked(H5Tcopy(H5T_C_S1)), H5Tclose);
        checked(H5Tset_size(type, text.size() + 1));
        add(name, type, type, {}, text.c_str()); // a scalar
      }

      void write(std::ostream &out) const
      {
        checked(H5Fflush(file_, H5F_SCOPE_GLOBAL));
        std::vector<char> bytes(checked(H5Fget_file_image(file_, nullptr, 0)));
        checked(H5Fget_file_image(file_, bytes.data(), bytes.size()));
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      }

    private:
      void add(const std::string &name, const hid_t type, const hid_t memory_type,
               const std::vector<hsize_t> &size, const void *entries)
      {
        checked(H5Dwrite(add_dataset(name, type, size), memory_type, H5S_ALL, H5S_ALL,
                         H5P_DEFAULT, entries));
      }

      static hid_t create(const std::size_t expected_size)
      {
        // room is made by so many bytes at a time: few times, little too much
        const std::size_t step = std::max<std::size_t>(expected_size / 8, 1 << 20);
        const Handle access(checked(H5Pcreate(H5P_FILE_ACCESS)), H5Pclose);
        checked(H5Pset_fapl_core(access, step, false));
        return checked(H5Fcreate("in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access));
      }

      const Handle file_;
    };

    Eigen::VectorXd interleaved(const Eigen::VectorXd &blocks)
    {
      const Index n = blocks.size();
      Eigen::VectorXd result(n);
      for (Index k = 0; k < n; ++k)
        result(k) = blocks(in_blocks(k, n));
      return result;
    }

    // By columns: the most compact of FCLIB's three kinds for a matrix without
    // zeros, and the one kind its merit function multiplies with. The row
    // indices 0, 1, ..., n-1, 0, 1, ... are worth nothing once compressed.
    void add_matrix(Image &image, const Eigen::MatrixXd &Q)
    {
      const auto n     = static_cast<int>(Q.rows());
      const int n_all  = n * n;
      const auto count = static_cast<hsize_t>(n_all);

      image.add_group(matrix);
      image.add(matrix + "/m", std::vector<int>{n});
      image.add(matrix + "/n", std::vector<int>{n});
      image.add(matrix + "/nz", std::vector<int>{-1});
      image.add(matrix + "/nzmax", std::vector<int>{n_all});
      std::vector<int> begin(n + 1);
      for (int j = 0; j <= n; ++j)
        begin[j] = j * n;
      image.add(matrix + "/p", begin);

      const int n_columns = std::min(n, std::max(1, static_cast<int>(batch) / n));
      const Handle rows   = image.add_dataset(matrix + "/i", H5T_STD_I32LE, {count},
                                              static_cast<hsize_t>(n_columns) * n);
      const Handle values = image.add_dataset(matrix + "/x", H5T_IEEE_F64LE, {count});
      std::vector<int> i;
      std::vector<double> x;
      for (int first = 0; first < n; first += n_columns)
        {
          i.clear();
          x.clear();
          for (int column = first; column < std::min(first + n_columns, n); ++column)
            for (int row = 0; row < n; ++row)
              {
                const Index a = in_blocks(row, n);
                const Index b = in_blocks(column, n);
                i.push_back(row);
                x.push_back(Q(std::max(a, b), std::min(a, b)));
              }
          const hsize_t offset = static_cast<hsize_t>(first) * n;
          Image::write_part(rows, offset, i);
          Image::write_part(values, offset, x);
        }
    }

    void add_description(Image &image, const bool is_coulomb)
    {
      image.add_group(group + "/info");
      image.add(group + "/info/title",
                std::string(is_coulomb ? "Elastic body with Coulomb friction"
                                       : "Elastic body with GIVEN friction: the slip "
                                         "bound is given_slip_bound, mu = 0 is a "
                                         "placeholder"));
      image.add(
        group + "/info/description",
        "Static contact of a linear elastic body, condensed to its contact "
        "nodes by stiction " STICTION_VERSION
        ". W = B K^-1 B^T, q = -h = gap - displacement without contact; u = "
        "(remaining gap, -slip), r = force on the obstacle, compression "
        "positive; components (normal, t1, t2) node by node. Other datasets "
        "beside FCLIB's, as far as known: areas and positions of the nodes." +
          std::string(is_coulomb
                        ? ""
                        : " FCLIB has no given friction: the condition is |r_t| <= "
                          "given_slip_bound at each node, whatever r_n; solved with mu "
                          "it is another problem."));
      image.add(group + "/info/math_info",
                std::string(is_coulomb ? "W is symmetric positive definite"
                                       : "W is symmetric positive definite; convex, "
                                         "the solution is unique"));
    }
  } // namespace

  void write_fclib(const std::string &path, const DualProblem &problem,
                   const Eigen::VectorXd &lambda, const Eigen::VectorXd &gradient)
  {
    problem_check::require_writable(problem, lambda, gradient, path);
    const Index n = problem.h.size();
    if (n * n > std::numeric_limits<int>::max())
      throw InputError(path + ": cannot be written, FCLIB counts the entries of W in 31 "
                              "bits, there must be at most 15446 contact nodes.");

    const Silence silence;
    const bool is_coulomb = problem.slip_bound.is_coulomb();
    Image image(sizeof(double) * static_cast<std::size_t>(n) * n);
    image.add_group(group);
    image.add(group + "/spacedim", std::vector<int>{3});
    add_matrix(image, problem.Q);
    image.add_group(group + "/vectors");
    image.add(group + "/vectors/q", -interleaved(problem.h));
    image.add(group + "/vectors/mu", is_coulomb
                                       ? problem.slip_bound.data()
                                       : Eigen::VectorXd(Eigen::VectorXd::Zero(n / 3)));
    if (!is_coulomb)
      image.add(given_bound, problem.slip_bound.data());
    if (problem.areas.size() > 0)
      image.add(areas, problem.areas);
    if (problem.positions.size() > 0)
      image.add(positions, problem.positions);
    add_description(image, is_coulomb);
    if (lambda.size() > 0)
      {
        image.add_group("/solution");
        image.add("/solution/r", interleaved(lambda));
        image.add("/solution/u", interleaved(gradient));
      }

    write_file(path, [&](std::ostream &out) { image.write(out); });
  }
} // namespace stiction
