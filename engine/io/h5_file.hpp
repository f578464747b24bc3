#pragma once
#include <filesystem>

#include "io/h5_group.hpp"

namespace sandgraph::io::h5 {

enum class Access { read, edit };

// An open HDF5 file. `user_block` bytes (0 or 512 * 2^k) stay free in front of it.
class File {
  public:
    static File create(const std::filesystem::path& path, unsigned user_block = 0);
    // InputError when the file is missing, not HDF5, or truncated.
    static File open(const std::filesystem::path& path, Access access = Access::read);

    Group root() const;
    const std::string& name() const { return name_; }
    // Closes and reports a failing write; the destructor can only swallow it.
    void close();

  private:
    File(Handle id, std::string name) : id_(std::move(id)), name_(std::move(name)) {}
    Handle id_;
    std::string name_;
};

}  // namespace sandgraph::io::h5
