#pragma once

#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <Eigen/Core>

#include <mpi.h>

#include <vector>

namespace stiction
{
  /// Passage between distributed vectors, of which every rank owns a range, and
  /// the whole on rank 0.
  class HostVector
  {
  public:
    /// For all vectors laid out like this one. Collective.
    explicit HostVector(const LA::Vector &v);

    /// The whole vector on rank 0, an empty one elsewhere. Collective.
    Eigen::VectorXd gather(const LA::Vector &v) const;

    /// The way back; whole counts on rank 0. Collective.
    void scatter(const Eigen::VectorXd &whole, LA::Vector &v) const;

  private:
    MPI_Comm communicator_;
    bool is_host_;
    int local_size_;
    std::vector<int> counts_, offsets_;
  };
} // namespace stiction
