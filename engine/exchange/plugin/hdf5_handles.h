/// Owners of HDF5's handles: each is closed once, on every path out.
#pragma once

#include <hdf5.h>

#include <utility>

namespace trocar::exchange::hdf5 {

template <herr_t (*close)(hid_t)>
class Handle {
 public:
  /// Takes what a function of HDF5 returned; negative: it failed.
  explicit Handle(hid_t id = H5I_INVALID_HID) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { reset(); }

  explicit operator bool() const { return id_ >= 0; }
  hid_t get() const { return id_; }
  /// False if it could not be closed, which for a file means that not all of it was written.
  bool reset() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id < 0 || close(id) >= 0;
  }

 private:
  hid_t id_;
};

using File = Handle<H5Fclose>;
using Object = Handle<H5Oclose>;  ///< A group, an array or a named type.
using Array = Handle<H5Dclose>;
using AttributeHandle = Handle<H5Aclose>;
using Type = Handle<H5Tclose>;
using Space = Handle<H5Sclose>;
using Properties = Handle<H5Pclose>;

}  // namespace trocar::exchange::hdf5
