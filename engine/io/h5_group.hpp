#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/h5_handle.hpp"

namespace sandgraph::io::h5 {

enum class Kind { group, dataset, other };

// A group of an open file (the root included) and its attributes. Reading what is missing or has another type
// throws InputError; failing to write throws std::runtime_error.
class Group {
  public:
    Group(Handle id, std::string file, std::string path);

    Group create(std::string_view name);      // with the groups in between
    Group open(std::string_view name) const;  // InputError when missing
    bool has(std::string_view name) const;
    void remove(std::string_view name);
    std::vector<std::string> names() const;  // in alphabetical order
    Kind kind(std::string_view name) const;

    const std::string& file() const { return file_; }
    const std::string& path() const { return path_; }
    std::string path_of(std::string_view name) const;
    hid_t id() const { return id_.get(); }

  private:
    Handle id_;
    std::string file_, path_;
};

// InputError about `what` in the group's file.
[[noreturn]] void refuse(const Group& group, const std::string& what, const std::string& why);

}  // namespace sandgraph::io::h5
