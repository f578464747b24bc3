#pragma once
#include <toml++/toml.h>

#include <cstdint>
#include <string>

#include "base/error.hpp"

namespace sandgraph::scene {

// Must the files that are named be there? Not for what is kept of a run that is over.
enum class NamedFiles : std::uint8_t { exist, may_be_gone };

// One `name = value` as it stands in a file.
struct Entry {
    const toml::node& node;
    InputError::Where where;
    std::string name;  // with its table: "anchor.width"
    NamedFiles files = NamedFiles::exist;

    std::string text() const;  // the value as written
    [[noreturn]] void refuse(const std::string& why, const std::string& suggestion) const;
};

// Where a key's value lives, and how it is read from TOML, checked and written again.
class Value {
  public:
    virtual ~Value() = default;
    virtual void read(const Entry& entry) = 0;
    virtual std::string shown() const = 0;      // as in a file: "30 kPa" with its quotes
    virtual std::string canonical() const = 0;  // for the hash: SI, 14 digits so that 7 mm is 0.7 cm
    virtual std::string allowed() const { return ""; }
    virtual bool unit_weight() const { return false; }  // was a density written as weight?
    virtual bool names_file() const { return false; }   // read() makes its path one from anywhere
};

}  // namespace sandgraph::scene
