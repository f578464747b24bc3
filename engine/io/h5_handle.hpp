#pragma once
#include <hdf5.h>

#include <string>
#include <utility>

// A thin RAII layer over the HDF5 C API; one thread at a time, for not every build of HDF5 is thread-safe.
namespace sandgraph::io::h5 {

// Owns one HDF5 identifier.
class Handle {
  public:
    using Close = herr_t (*)(hid_t);
    Handle() = default;
    Handle(hid_t id, Close close) : id_(id), close_(close) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    // A file that was closed took what was open of it along; to close that again is an error, whose words
    // HDF5 would keep for the thread and forget with it.
    ~Handle() {
        if (id_ >= 0 && H5Iis_valid(id_) > 0) close_(id_);
    }
    hid_t get() const { return id_; }

  private:
    hid_t id_ = H5I_INVALID_HID;
    Close close_ = nullptr;
};

// Stops the library from printing its error stack; called by everything that opens a file.
void silence();

// Throws std::runtime_error `file: cannot ACTION (HDF5's own words)` when status < 0.
void check(long long status, const std::string& file, const std::string& action);

// The innermost message of the library's error stack, in one line; clears the stack.
std::string last_error();

// As Handle's constructor, with check().
Handle own(hid_t id, Handle::Close close, const std::string& file, const std::string& action);

}  // namespace sandgraph::io::h5
