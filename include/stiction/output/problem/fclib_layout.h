#pragma once

// HDF5's C interface: deal.II's wrapper checks what HDF5 returns in debug mode
// only, and a user's file may hold anything. libfclib itself stands on the
// serial HDF5, which cannot live in one program with the parallel one of
// deal.II.
#include <hdf5.h>

#include <Eigen/Core>

#include <string>

namespace stiction
{
  /// What writing and reading FCLIB's files share: where things stand in them,
  /// and HDF5's objects as objects. Includes HDF5: for the two source files
  /// only.
  namespace fclib
  {
    inline const std::string group       = "/fclib_local";
    inline const std::string matrix      = group + "/W";
    inline const std::string given_bound = group + "/given_slip_bound";
    inline const std::string areas       = group + "/areas";
    inline const std::string positions   = group + "/positions";

    // How many numbers pass through a buffer at a time.
    constexpr Eigen::Index batch = 1 << 16;

    /// FCLIB's unknown k, component k % 3 of node k / 3, in our blocks.
    inline Eigen::Index in_blocks(const Eigen::Index k, const Eigen::Index n)
    {
      return k % 3 * (n / 3) + k / 3;
    }

    /// While it lives, HDF5 prints no error stack: the sentence is ours.
    class Silence
    {
    public:
      Silence()
      {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
      }

      ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

      Silence(const Silence &)            = delete;
      Silence &operator=(const Silence &) = delete;

    private:
      H5E_auto2_t function_ = nullptr;
      void *data_           = nullptr;
    };

    /// An object of HDF5, closed at the end. Negative: there is none.
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

      Handle(const Handle &)            = delete;
      Handle &operator=(const Handle &) = delete;
      Handle &operator=(Handle &&)      = delete;

      operator hid_t() const { return id_; }

    private:
      hid_t id_;
      herr_t (*close_)(hid_t);
    };
  } // namespace fclib
} // namespace stiction
