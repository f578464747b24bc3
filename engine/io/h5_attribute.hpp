#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/h5_group.hpp"

namespace sandgraph::io::h5 {

using Value = std::variant<double, std::int64_t, std::string>;

// Attributes of a group (object = ".") or of a member of it. Writing replaces.
void set_attribute(Group& group, std::string_view object, std::string_view name, const Value& value);

double get_real(const Group& group, std::string_view object, std::string_view name);
std::int64_t get_integer(const Group& group, std::string_view object, std::string_view name);
std::string get_text(const Group& group, std::string_view object, std::string_view name);
bool has_attribute(const Group& group, std::string_view object, std::string_view name);

struct Attribute {
    std::string name;
    Value value;
};
// All scalar attributes in alphabetical order.
std::vector<Attribute> attributes(const Group& group, std::string_view object);

}  // namespace sandgraph::io::h5
