#include <stiction/elasticity/linear_algebra/host_vector.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/la_parallel_vector.h>

namespace stiction
{
  HostVector::HostVector(const LA::Vector &v)
    : communicator_(v.get_mpi_communicator())
    , is_host_(dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
    , local_size_(static_cast<int>(v.locally_owned_size()))
    , counts_(dealii::Utilities::MPI::gather(communicator_, local_size_, 0))
    , offsets_(counts_.size(), 0)
  {
    for (std::size_t r = 1; r < counts_.size(); ++r)
      offsets_[r] = offsets_[r - 1] + counts_[r - 1];
  }

  Eigen::VectorXd HostVector::gather(const LA::Vector &v) const
  {
    Eigen::VectorXd whole(is_host_ ? v.size() : 0);
    MPI_Gatherv(v.begin(), local_size_, MPI_DOUBLE, whole.data(), counts_.data(),
                offsets_.data(), MPI_DOUBLE, 0, communicator_);
    return whole;
  }

  void HostVector::scatter(const Eigen::VectorXd &whole, LA::Vector &v) const
  {
    MPI_Scatterv(whole.data(), counts_.data(), offsets_.data(), MPI_DOUBLE, v.begin(),
                 local_size_, MPI_DOUBLE, 0, communicator_);
  }
} // namespace stiction
