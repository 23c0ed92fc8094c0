#include <stiction/errors.h>
#include <stiction/output/fclib.h>
#include <stiction/output/files.h>
#include <stiction/output/problem_check.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <ostream>
#include <type_traits>
#include <vector>

// HDF5's C interface: deal.II's wrapper checks what HDF5 returns in debug mode
// only, and a user's file may hold anything. libfclib itself stands on the
// serial HDF5, which cannot live in one program with the parallel one of
// deal.II.
#include <hdf5.h>

namespace stiction
{
  namespace
  {
    using Eigen::Index;
    using problem_check::Allowed;

    const std::string group       = "/fclib_local";
    const std::string matrix      = group + "/W";
    const std::string given_bound = group + "/given_slip_bound";
    const std::string areas       = group + "/areas";
    const std::string positions   = group + "/positions";

    // How many numbers pass through a buffer at a time.
    constexpr Index batch = 1 << 16;

    // FCLIB's unknown k, component k % 3 of node k / 3, in our blocks.
    Index
    in_blocks(const Index k, const Index n)
    {
      return k % 3 * (n / 3) + k / 3;
    }

    // While it lives, HDF5 prints no error stack: the sentence is ours.
    class Silence
    {
    public:
      Silence()
      {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
      }

      ~Silence()
      {
        H5Eset_auto2(H5E_DEFAULT, function_, data_);
      }

      Silence(const Silence &) = delete;
      Silence &
      operator=(const Silence &) = delete;

    private:
      H5E_auto2_t function_ = nullptr;
      void *data_           = nullptr;
    };

    // An object of HDF5, closed at the end. Negative: there is none.
    class Handle
    {
    public:
      Handle(const hid_t id, herr_t (*close)(hid_t))
        : id_(id)
        , close_(close)
      {
      }

      ~Handle()
      {
        if (id_ >= 0)
          close_(id_);
      }

      Handle(Handle &&other) noexcept
        : id_(other.id_)
        , close_(other.close_)
      {
        other.id_ = -1;
      }

      Handle(const Handle &) = delete;
      Handle &
      operator=(const Handle &) = delete;
      Handle &
      operator=(Handle &&) = delete;

      operator hid_t() const
      {
        return id_;
      }

    private:
      hid_t id_;
      herr_t (*close_)(hid_t);
    };



    // ------------------------------------------------------------- writing

    // HDF5 in memory fails for one reason.
    template<typename Result>
    Result
    checked(const Result result)
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

      void
      add_group(const std::string &name)
      {
        const Handle created(
          checked(H5Gcreate2(
            file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)),
          H5Gclose);
      }

      // Entries to be written by parts; chunk = 0: not compressed.
      Handle
      add_dataset(const std::string &name,
                  const hid_t type,
                  const std::vector<hsize_t> &size,
                  const hsize_t chunk = 0)
      {
        const Handle space(
          checked(H5Screate_simple(
            static_cast<int>(size.size()), size.data(), nullptr)),
          H5Sclose);
        const Handle properties(checked(H5Pcreate(H5P_DATASET_CREATE)),
                                H5Pclose);
        if (chunk > 0 && H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0)
          {
            checked(H5Pset_chunk(properties, 1, &chunk));
            checked(H5Pset_deflate(properties, 4));
          }
        return {checked(H5Dcreate2(file_,
                                   name.c_str(),
                                   type,
                                   space,
                                   H5P_DEFAULT,
                                   properties,
                                   H5P_DEFAULT)),
                H5Dclose};
      }

      template<typename Number>
      static void
      write_part(const hid_t dataset,
                 const hsize_t begin,
                 const std::vector<Number> &values)
      {
        const hsize_t size = values.size();
        const Handle file_space(checked(H5Dget_space(dataset)), H5Sclose);
        const Handle memory_space(checked(H5Screate_simple(1, &size, nullptr)),
                                  H5Sclose);
        checked(H5Sselect_hyperslab(
          file_space, H5S_SELECT_SET, &begin, nullptr, &size, nullptr));
        checked(H5Dwrite(dataset,
                         std::is_same<Number, int>::value ? H5T_NATIVE_INT
                                                          : H5T_NATIVE_DOUBLE,
                         memory_space,
                         file_space,
                         H5P_DEFAULT,
                         values.data()));
      }

      void
      add(const std::string &name, const std::vector<int> &values)
      {
        write_part(
          add_dataset(name, H5T_STD_I32LE, {values.size()}), 0, values);
      }

      void
      add(const std::string &name, const Eigen::VectorXd &values)
      {
        write_part(
          add_dataset(
            name, H5T_IEEE_F64LE, {static_cast<hsize_t>(values.size())}),
          0,
          std::vector<double>(values.data(), values.data() + values.size()));
      }

      // Row by row.
      void
      add(const std::string &name, const Eigen::MatrixXd &values)
      {
        const Eigen::
          Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>
            by_rows = values;
        const Handle dataset =
          add_dataset(name,
                      H5T_IEEE_F64LE,
                      {static_cast<hsize_t>(values.rows()),
                       static_cast<hsize_t>(values.cols())});
        checked(H5Dwrite(dataset,
                         H5T_NATIVE_DOUBLE,
                         H5S_ALL,
                         H5S_ALL,
                         H5P_DEFAULT,
                         by_rows.data()));
      }

      void
      add(const std::string &name, const std::string &text)
      {
        const Handle type(checked(H5Tcopy(H5T_C_S1)), H5Tclose);
        checked(H5Tset_size(type, text.size() + 1));
        const Handle space(checked(H5Screate(H5S_SCALAR)), H5Sclose);
        const Handle dataset(checked(H5Dcreate2(file_,
                                                name.c_str(),
                                                type,
                                                space,
                                                H5P_DEFAULT,
                                                H5P_DEFAULT,
                                                H5P_DEFAULT)),
                             H5Dclose);
        checked(
          H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
      }

      void
      write(std::ostream &out) const
      {
        checked(H5Fflush(file_, H5F_SCOPE_GLOBAL));
        std::vector<char> bytes(checked(H5Fget_file_image(file_, nullptr, 0)));
        checked(H5Fget_file_image(file_, bytes.data(), bytes.size()));
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      }

    private:
      static hid_t
      create(const std::size_t expected_size)
      {
        // room is made by so many bytes at a time: few times, little too much
        const std::size_t step =
          std::max<std::size_t>(expected_size / 8, 1 << 20);
        const Handle access(checked(H5Pcreate(H5P_FILE_ACCESS)), H5Pclose);
        checked(H5Pset_fapl_core(access, step, false));
        return checked(
          H5Fcreate("in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access));
      }

      const Handle file_;
    };



    Eigen::VectorXd
    interleaved(const Eigen::VectorXd &blocks)
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
    void
    add_matrix(Image &image, const Eigen::MatrixXd &Q)
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

      const int n_columns =
        std::min(n, std::max(1, static_cast<int>(batch) / n));
      const Handle rows =
        image.add_dataset(matrix + "/i",
                          H5T_STD_I32LE,
                          {count},
                          static_cast<hsize_t>(n_columns) * n);
      const Handle values =
        image.add_dataset(matrix + "/x", H5T_IEEE_F64LE, {count});
      std::vector<int> i;
      std::vector<double> x;
      for (int first = 0; first < n; first += n_columns)
        {
          i.clear();
          x.clear();
          for (int column = first; column < std::min(first + n_columns, n);
               ++column)
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

    void
    add_description(Image &image, const bool is_coulomb)
    {
      image.add_group(group + "/info");
      image.add(group + "/info/title",
                std::string(is_coulomb
                              ? "Elastic body with Coulomb friction"
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
          std::string(
            is_coulomb
              ? ""
              : " FCLIB has no given friction: the condition is |r_t| <= "
                "given_slip_bound at each node, whatever r_n; solved with mu "
                "it is another problem."));
      image.add(group + "/info/math_info",
                std::string(is_coulomb
                              ? "W is symmetric positive definite"
                              : "W is symmetric positive definite; convex, "
                                "the solution is unique"));
    }



    // ------------------------------------------------------------- reading

    class Reader
    {
    public:
      explicit Reader(const std::string &path)
        : path_(path)
        , file_(open(path), H5Fclose)
      {
      }

      [[noreturn]] void
      fail(const std::string &sentence) const
      {
        throw InputError(path_ + ": " + sentence + ".");
      }

      // The parents of the name must exist.
      bool
      has(const std::string &name) const
      {
        return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
      }

      void
      require_group(const std::string &name) const
      {
        const Handle opened(H5Gopen2(file_, name.c_str(), H5P_DEFAULT),
                            H5Gclose);
        if (opened < 0)
          fail("group " + name + " is missing, must be as FCLIB writes it");
      }

      // Opens a dataset of so many numbers (integers).
      Handle
      open_numbers(const std::string &name,
                   const Index size,
                   const std::string &meaning,
                   const bool integers) const
      {
        const std::string must = ", must be " + std::to_string(size) +
                                 (integers ? " integer" : " number") +
                                 (size == 1 ? "" : "s") +
                                 (meaning.empty() ? "" : ", " + meaning);
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
      void
      require_table(const std::string &name,
                    const Index n_rows,
                    const Index n_columns) const
      {
        const Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT),
                             H5Dclose);
        const Handle space(H5Dget_space(dataset), H5Sclose);
        std::array<hsize_t, 2> size{};
        if (H5Sget_simple_extent_ndims(space) != 2 ||
            H5Sget_simple_extent_dims(space, size.data(), nullptr) != 2 ||
            size[0] != static_cast<hsize_t>(n_rows) ||
            size[1] != static_cast<hsize_t>(n_columns))
          fail("dataset " + name + " is of another shape, must be a table of " +
               std::to_string(n_rows) + " rows and " +
               std::to_string(n_columns) + " columns");
      }

      template<typename Number>
      void
      read_part(const hid_t dataset,
                const std::string &name,
                const Index begin,
                std::vector<Number> &values) const
      {
        const hsize_t offset = begin;
        const hsize_t size   = values.size();
        const Handle file_space(H5Dget_space(dataset), H5Sclose);
        const Handle memory_space(H5Screate_simple(1, &size, nullptr),
                                  H5Sclose);
        if (H5Sget_simple_extent_ndims(file_space) != 1)
          fail("dataset " + name + " is a table, must be a list");
        if (H5Sselect_hyperslab(
              file_space, H5S_SELECT_SET, &offset, nullptr, &size, nullptr) <
              0 ||
            H5Dread(dataset,
                    memory_type(values.data()),
                    memory_space,
                    file_space,
                    H5P_DEFAULT,
                    values.data()) < 0)
          fail_to_read(name);
      }

      // All of it, any shape, in the order of the file.
      template<typename Number>
      std::vector<Number>
      read(const std::string &name,
           const Index size,
           const std::string &meaning) const
      {
        const Handle dataset =
          open_numbers(name, size, meaning, !std::is_same_v<Number, double>);
        std::vector<Number> values(size);
        if (H5Dread(dataset,
                    memory_type(values.data()),
                    H5S_ALL,
                    H5S_ALL,
                    H5P_DEFAULT,
                    values.data()) < 0)
          fail_to_read(name);
        return values;
      }

      long long
      integer(const std::string &name, const std::string &meaning = "") const
      {
        return read<long long>(name, 1, meaning)[0];
      }

      Eigen::VectorXd
      vector(const std::string &name,
             const Index size,
             const std::string &meaning,
             const Allowed allowed) const
      {
        const std::vector<double> read_values =
          read<double>(name, size, meaning);
        Eigen::VectorXd values =
          Eigen::Map<const Eigen::VectorXd>(read_values.data(), size);
        problem_check::require_all(
          values, allowed, [&](const Index i) { return entry(name, i); });
        return values;
      }

      std::string
      entry(const std::string &name, const Index i) const
      {
        return path_ + ": dataset " + name + ", entry " + std::to_string(i) +
               " (from 0)";
      }

      const std::string &
      path() const
      {
        return path_;
      }

    private:
      static hid_t
      open(const std::string &path)
      {
        std::error_code error;
        if (std::filesystem::is_directory(path, error) ||
            !std::ifstream(path, std::ios::binary))
          throw InputError(path + ": cannot be read, must be a file that "
                                  "exists and may be read.");
        const hid_t file =
          H5Fis_hdf5(path.c_str()) > 0
            ? H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)
            : -1;
        if (file < 0)
          throw InputError(path + ": is no HDF5 file or a damaged one, must "
                                  "be an HDF5 file as FCLIB writes it.");
        return file;
      }

      static hid_t
      memory_type(const double *)
      {
        return H5T_NATIVE_DOUBLE;
      }

      static hid_t
      memory_type(const long long *)
      {
        return H5T_NATIVE_LLONG;
      }

      [[noreturn]] void
      fail_to_read(const std::string &name) const
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
          reader.fail("datasets " + matrix + "/m and n are " +
                      std::to_string(m) + " and " + std::to_string(order_) +
                      ", must be equal and 3, 6, 9, ..., three for each "
                      "contact node");
        kind_  = reader.integer(matrix + "/nz");
        n_max_ = reader.integer(matrix + "/nzmax");
        if (kind_ < -2)
          reader.fail("dataset " + matrix + "/nz is " + std::to_string(kind_) +
                      ", must be the number of triplets, -1 (by columns) or "
                      "-2 (by rows)");
        if (n_max_ < 1 || kind_ > n_max_)
          reader.fail("dataset " + matrix + "/nzmax is " +
                      std::to_string(n_max_) +
                      ", must be the size of the dataset x, at least 1 and "
                      "at least nz");
      }

      Index
      order() const
      {
        return order_;
      }

      // In our blocks.
      Eigen::MatrixXd
      read()
      {
        problem_check::require_memory(static_cast<double>(order_),
                                      reader_.path() + ": group " + matrix);
        std::vector<long long> begin; // of each column or row
        Index count             = kind_;
        const bool are_triplets = kind_ >= 0;
        if (!are_triplets)
          {
            begin = reader_.read<long long>(
              matrix + "/p", order_ + 1, "one more than the order");
            for (Index j = 0; j <= order_; ++j)
              if (begin[j] < (j == 0 ? 0 : begin[j - 1]) ||
                  begin[j] > (j == 0 ? 0 : n_max_))
                reader_.fail("dataset " + matrix + "/p, entry " +
                             std::to_string(j) + " (from 0) is " +
                             std::to_string(begin[j]) +
                             ", must begin with 0, never fall, and end with "
                             "at most nzmax = " +
                             std::to_string(n_max_));
            count = begin[order_];
          }
        const std::string as_nz = "as nz says", as_max = "as nzmax says";
        const Handle x =
          reader_.open_numbers(matrix + "/x", n_max_, as_max, false);
        const Handle i = reader_.open_numbers(matrix + "/i",
                                              are_triplets ? count : n_max_,
                                              are_triplets ? as_nz : as_max,
                                              true);
        // of triplets only: what p is otherwise, is known already
        const Handle p = reader_.open_numbers(matrix + "/p",
                                              are_triplets ? count : order_ + 1,
                                              are_triplets ? as_nz : "",
                                              true);

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
      void
      require_indices(const std::string &name,
                      const std::vector<long long> &indices,
                      const Index offset) const
      {
        for (std::size_t k = 0; k < indices.size(); ++k)
          if (indices[k] < 0 || indices[k] >= order_)
            throw InputError(reader_.entry(matrix + "/" + name,
                                           offset + static_cast<Index>(k)) +
                             " is " + std::to_string(indices[k]) +
                             ", must be from 0 to " +
                             std::to_string(order_ - 1) + ".");
      }

      const Reader &reader_;
      long long order_ = 0, kind_ = 0, n_max_ = 0;
    };
  } // namespace



  void
  write_fclib(const std::string &path,
              const DualProblem &problem,
              const Eigen::VectorXd &lambda,
              const Eigen::VectorXd &gradient)
  {
    problem_check::require_writable(problem, lambda, gradient, path);
    const Index n = problem.h.size();
    if (n * n > std::numeric_limits<int>::max())
      throw InputError(path + ": cannot be written, FCLIB counts the entries "
                              "of W in 31 bits, there must be at most 15446 "
                              "contact nodes.");

    const Silence silence;
    const bool is_coulomb = problem.slip_bound.is_coulomb();
    Image image(sizeof(double) * static_cast<std::size_t>(n) * n);
    image.add_group(group);
    image.add(group + "/spacedim", std::vector<int>{3});
    add_matrix(image, problem.Q);
    image.add_group(group + "/vectors");
    image.add(group + "/vectors/q", Eigen::VectorXd(-interleaved(problem.h)));
    image.add(group + "/vectors/mu",
              is_coulomb ? problem.slip_bound.data()
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



  DualProblem
  read_fclib(const std::string &path)
  {
    const Silence silence;
    const Reader reader(path);

    if (!reader.has(group))
      reader.fail(reader.has("/fclib_global")
                    ? "holds a global problem of FCLIB (/fclib_global), must "
                      "hold a local one (" +
                        group + ")"
                    : "group " + group +
                        " is missing, must be a local problem as FCLIB writes "
                        "it");
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
                             ", must be 0 where there is a dataset " +
                             given_bound + ".");
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
        const Eigen::VectorXd by_rows = reader.vector(
          positions, n, "three for each contact node", Allowed::number);
        problem.positions.resize(m, 3);
        for (Index k = 0; k < n; ++k)
          problem.positions(k / 3, k % 3) = by_rows(k);
      }

    problem.Q = W.read();
    problem_check::make_symmetric(problem.Q, [&](const Index i, const Index j) {
      const auto interleaved_index = [m](const Index k) {
        return std::to_string(k % m * 3 + k / m);
      };
      return path + ": group " + matrix + ", row " + interleaved_index(i) +
             ", column " + interleaved_index(j) + " (from 0)";
    });
    return problem;
  }
} // namespace stiction
