#pragma once
#include <map>
#include <stdexcept>
#include <string>
#include <variant>

#include "base/archive.hpp"

namespace sandgraph::support {

// A checkpoint in memory: written first, then read.
class MemoryArchive final : public Archive {
  public:
    bool reading() const override { return reading_; }
    void read_from_now_on() { reading_ = true; }
    bool same_as(const MemoryArchive& other) const { return fields_ == other.fields_; }
    void field(std::string_view name, std::vector<double>& v) override { pass(name, v); }
    void field(std::string_view name, std::vector<std::int64_t>& v) override { pass(name, v); }
    void field(std::string_view name, std::vector<std::uint8_t>& v) override { pass(name, v); }

  private:
    template <class T>
    void pass(std::string_view name, T& values) {
        if (reading_)
            values = std::get<T>(fields_.at(std::string(name)));
        else if (!fields_.emplace(name, values).second)
            throw std::logic_error("field written twice: " + std::string(name));
    }
    bool reading_ = false;
    std::map<std::string,
             std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint8_t>>>
        fields_;
};

}  // namespace sandgraph::support
