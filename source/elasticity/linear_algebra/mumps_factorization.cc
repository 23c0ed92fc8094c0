#include <stiction/elasticity/linear_algebra/matrix_rows.h>
#include <stiction/elasticity/linear_algebra/mumps_factorization.h>
#include <stiction/elasticity/linear_algebra/nested_dissection.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>

#include <dmumps_c.h>

namespace stiction
{
  namespace
  {
    // Numbers of the jobs of MUMPS.
    enum Job
    {
      initialise  = -1,
      terminate   = -2,
      analyse     = 1,
      factorise   = 2,
      solve_phase = 3
    };

    // MUMPS never wants a null pointer, even where there is nothing to see.
    template<typename T, typename Container> T *data_or(Container &container, T &nothing)
    {
      return container.size() == 0 ? &nothing : container.data();
    }

    // Calls back with the entries of the lower triangle: row, column and value.
    template<typename Callback>
    void for_each_lower_entry(const LA::SparseMatrix &matrix, const Callback &callback)
    {
      const Epetra_CrsMatrix &K = matrix.trilinos_matrix();
      const int *const numbers  = K.RowMap().MyGlobalElements();
      for (int i = 0; i < K.NumMyRows(); ++i)
        for_each_entry(K, numbers[i], [&](const int column, const double value) {
          if (column <= numbers[i])
            callback(numbers[i], column, value);
        });
    }
  } // namespace

  struct MumpsFactorization::Mumps
  {
    Mumps(const LA::SparseMatrix &matrix,
          const std::vector<dealii::types::global_dof_index> &schur_dofs);
    ~Mumps();
    Mumps(const Mumps &)            = delete;
    Mumps &operator=(const Mumps &) = delete;

    void factorize(const LA::SparseMatrix &matrix);
    bool find_entries(const LA::SparseMatrix &matrix);
    void copy_values(const LA::SparseMatrix &matrix);
    void run_analysis();
    void run_factorisation();
    void run_solve(int condensation, Eigen::VectorXd &b, Eigen::VectorXd *condensed);
    void call(Job job);
    void check(const char *phase) const;

    // the numbering of MUMPS' manual
    MUMPS_INT &icntl(const int i) { return id.icntl[i - 1]; }
    MUMPS_INT
    infog(const int i) const { return id.infog[i - 1]; }

    DMUMPS_STRUC_C id{};
    bool is_host  = false;
    double factor = 1.; // what is factorised is K times this, a power of two
    int n_schur   = 0;
    Eigen::MatrixXd schur;

    // what MUMPS keeps pointers to
    std::vector<MUMPS_INT> rows, columns, permutation, schur_list;
    std::vector<double> values;
    std::vector<bool> is_listed; // of all entries of the lower triangle
    bool is_analysed     = false;
    MUMPS_INT no_integer = 0;
    double no_number     = 0.;
  };

  MumpsFactorization::Mumps::Mumps(
    const LA::SparseMatrix &matrix,
    const std::vector<dealii::types::global_dof_index> &schur_dofs)
    : n_schur(static_cast<int>(schur_dofs.size()))
  {
    const MPI_Comm communicator = matrix.get_mpi_communicator();
    is_host = dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    for (const auto dof : schur_dofs)
      schur_list.push_back(static_cast<MUMPS_INT>(dof) + 1);

    id.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(communicator));
    id.par          = 1; // the host works too
    id.sym          = 1; // positive definite
    call(initialise);
    check("initialisation");
    for (const int stream : {1, 2, 3})
      icntl(stream) = -1; // errors come back as numbers, not as print
    icntl(4)  = 0;
    icntl(5)  = 0;  // assembled matrix ...
    icntl(18) = 3;  // ... distributed over the ranks
    icntl(8)  = 0;  // a positive definite matrix needs no scaling
    icntl(14) = 30; // per cent of work space more than estimated

    id.n = static_cast<MUMPS_INT>(matrix.m()); // after it was initialised

    factorize(matrix);
  }

  MumpsFactorization::Mumps::~Mumps() { call(terminate); }

  void MumpsFactorization::Mumps::factorize(const LA::SparseMatrix &matrix)
  {
    const bool is_new = find_entries(matrix);
    copy_values(matrix);
    if (dealii::Utilities::MPI::logical_or(is_new, matrix.get_mpi_communicator()))
      {
        run_analysis();
        is_analysed = true;
      }
    run_factorisation();
    values.clear();
    values.shrink_to_fit();
  }

  // Lists the entries that are not zero, of the second matrix on all entries: then a
  // third one needs no analysis. Returns whether the list has grown.
  bool MumpsFactorization::Mumps::find_entries(const LA::SparseMatrix &matrix)
  {
    const bool is_first = !is_analysed;
    bool is_new         = is_first;
    std::size_t k       = 0;
    for_each_lower_entry(matrix, [&](const int, const int, const double value) {
      if (is_first)
        is_listed.push_back(value != 0.);
      else if (!is_listed[k])
        is_new = is_listed[k] = true;
      ++k;
    });
    if (!is_new)
      return false;
    rows.clear();
    columns.clear();
    k = 0;
    for_each_lower_entry(matrix, [&](const int row, const int column, const double) {
      if (!is_listed[k++])
        return;
      rows.push_back(row + 1);
      columns.push_back(column + 1);
    });
    return true;
  }

  void MumpsFactorization::Mumps::copy_values(const LA::SparseMatrix &matrix)
  {
    std::size_t k = 0;
    values.reserve(rows.size());
    for_each_lower_entry(matrix, [&](const int, const int, const double value) {
      if (is_listed[k++])
        values.push_back(value);
    });

    // MUMPS takes what is far below one for zero; nothing is rounded by this
    double largest = 0.;
    for (const double value : values)
      largest = std::max(largest, std::abs(value));
    largest = dealii::Utilities::MPI::max(largest, matrix.get_mpi_communicator());
    factor  = largest > 0. ? std::ldexp(1., -std::ilogb(largest)) : 1.;
    for (double &value : values)
      value *= factor;
  }

  void MumpsFactorization::Mumps::run_analysis()
  {
    // Left to itself MUMPS orders by minimum degree as soon as a Schur
    // complement is asked for, at three times the operations.
    permutation =
      nested_dissection(rows, columns, id.n, schur_list, MPI_Comm_f2c(id.comm_fortran));
    icntl(7)   = 1; // the given ordering
    icntl(28)  = 1; // sequential analysis: the parallel one has no Schur
    id.perm_in = data_or(permutation, no_integer);
    id.nnz_loc = static_cast<MUMPS_INT8>(values.size());
    id.irn_loc = data_or(rows, no_integer);
    id.jcn_loc = data_or(columns, no_integer);
    if (n_schur > 0)
      {
        // lower triangle by columns, on a 1 × 1 grid of processes: the host
        icntl(19) = 2;
        id.nprow = id.npcol = 1;
        id.mblock = id.nblock = 100;
        id.size_schur         = n_schur;
        id.listvar_schur      = schur_list.data();
      }
    call(analyse);
    check("analysis");
  }

  void MumpsFactorization::Mumps::run_factorisation()
  {
    id.a_loc = data_or(values, no_number);
    if (n_schur > 0)
      {
        schur.resize(is_host ? n_schur : 0, is_host ? n_schur : 0);
        id.schur     = is_host ? schur.data() : &no_number;
        id.schur_lld = is_host ? n_schur : 1;
      }

    // The relative slack is too little for small problems on several ranks,
    // where S is assembled by messages: some megabytes come on top. INFOG, not
    // INFO: the decision has to be the same everywhere.
    MUMPS_INT megabytes = infog(16) + infog(16) / 3 + 50;
    for (unsigned int attempt = 0;; ++attempt)
      {
        icntl(23) = megabytes;
        call(factorise);
        // the errors of which the manual says: enlarge the work space
        const std::array<MUMPS_INT, 3> limit_too_small    = {{-9, -11, -19}};
        const std::array<MUMPS_INT, 5> estimate_too_small = {{-8, -14, -15, -17, -20}};
        const auto is_one_of                              = [&](const auto &errors) {
          return std::find(errors.begin(), errors.end(), infog(1)) != errors.end();
        };
        if (attempt == 6 ||
            !(is_one_of(limit_too_small) || is_one_of(estimate_too_small)))
          break;
        megabytes *= 2;
        if (is_one_of(estimate_too_small))
          icntl(14) *= 2;
      }
    check("factorisation");
    schur /= factor;
  }

  void MumpsFactorization::Mumps::run_solve(const int condensation, Eigen::VectorXd &b,
                                            Eigen::VectorXd *condensed)
  {
    id.nrhs = 1;
    id.lrhs = id.n;
    id.rhs  = is_host ? b.data() : &no_number;
    if (condensation != 2)
      b *= factor; // expansion continues with that of the condensation
    if (condensed != nullptr)
      {
        condensed->resize(is_host ? n_schur : 0);
        id.lredrhs = std::max(1, n_schur);
        id.redrhs  = data_or(*condensed, no_number);
      }
    icntl(26) = condensation;
    call(solve_phase);
    check("solve");
    if (condensation == 1)
      *condensed /= factor;
  }

  void MumpsFactorization::Mumps::call(const Job job)
  {
    id.job = job;
    dmumps_c(&id);
  }

  void MumpsFactorization::Mumps::check(const char *phase) const
  {
    if (infog(1) == -13)
      throw std::bad_alloc();
    if (infog(1) < 0)
      throw std::runtime_error(std::string("MUMPS failed in its ") + phase +
                               " with INFOG(1) = " + std::to_string(infog(1)) +
                               ", INFOG(2) = " + std::to_string(infog(2)));
  }

  // -------------------------------------------------- MumpsFactorization

  MumpsFactorization::MumpsFactorization(
    const LA::SparseMatrix &matrix,
    const std::vector<dealii::types::global_dof_index> &schur_dofs)
    : mumps_(std::make_unique<Mumps>(matrix, schur_dofs))
  {
  }

  MumpsFactorization::~MumpsFactorization() = default;

  void MumpsFactorization::refactorize(const LA::SparseMatrix &matrix)
  {
    mumps_->factorize(matrix);
  }

  Eigen::MatrixXd &MumpsFactorization::schur_complement() { return mumps_->schur; }

  bool MumpsFactorization::is_host() const { return mumps_->is_host; }

  void MumpsFactorization::solve(Eigen::VectorXd &b) { mumps_->run_solve(0, b, nullptr); }

  void MumpsFactorization::condense(Eigen::VectorXd &b, Eigen::VectorXd &condensed)
  {
    mumps_->run_solve(1, b, &condensed);
  }

  void MumpsFactorization::expand(Eigen::VectorXd &b, Eigen::VectorXd &condensed)
  {
    mumps_->run_solve(2, b, &condensed);
  }
} // namespace stiction
