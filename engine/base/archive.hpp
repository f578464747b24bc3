#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace sandgraph {

// A place that named arrays go to (checkpoint written) or come from (checkpoint read), so that dem, mpm and
// graph can save their state without knowing HDF5. One function per type serves both directions:
//   void archive(Archive& a, Points& p) { a.field("points/x", p.x); ... }
// Reading throws InputError when a field is missing or damaged. Names may hold '/' for groups.
class Archive {
  public:
    virtual ~Archive() = default;
    virtual bool reading() const = 0;
    virtual void field(std::string_view name, std::vector<double>& values) = 0;
    virtual void field(std::string_view name, std::vector<std::int64_t>& values) = 0;
    virtual void field(std::string_view name, std::vector<std::uint8_t>& values) = 0;
};

// A field whose length is known before it is read; StateError when it comes with another.
template <class T>
void field_of_known_length(Archive& a, std::string_view name, std::vector<T>& values) {
    std::vector<T> read = values;
    a.field(name, read);
    require_state(read.size() == values.size(), std::string(name).c_str());
    values.swap(read);
}

}  // namespace sandgraph
