#include "scene/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"

namespace sandgraph::scene {
namespace {

double bare_number(const Entry& entry, const toml::node& node) {
    const auto number = node.is_number() ? node.value<double>() : std::nullopt;
    if (!number) entry.refuse("not a number", "write a number without quotes or unit");
    if (!std::isfinite(*number)) entry.refuse("not a finite number", "write a finite number");
    return *number;
}

}  // namespace

double Real::quantity(const Entry& entry) const {
    if (unit_.empty()) return bare_number(entry, entry.node);
    if (entry.node.is_number()) entry.refuse("no unit", fmt::format("write \"{} {}\"", entry.text(), unit_));
    const auto text = entry.node.value_exact<std::string>();
    if (!text) entry.refuse("not a quantity", fmt::format("write a number and a unit, as {}", shown()));
    return parse_quantity(entry.where, entry.name, *text, unit_);
}

void Real::read(const Entry& entry) {
    const double value = quantity(entry);
    if (!range_.contains(value))
        entry.refuse("out of range", fmt::format("write a value {}", range_.text(unit_)));
    value_ = value;
    unit_weight_ = is_unit_weight(entry.node.value_or(std::string{}));
}

std::string Real::shown() const { return shown(value_); }

std::string Real::shown(double value) const {
    const std::string text = format_quantity(value, unit_);
    return unit_.empty() ? text : fmt::format("\"{}\"", text);
}
std::string Real::canonical() const { return fmt::format("{:.14g}", value_); }

void RisingReals::read(const Entry& entry) {
    const toml::array* array = entry.node.as_array();
    if (!array) entry.refuse("not a list", "write numbers in brackets, as [0, 0.1]");
    std::vector<double> values;
    for (const toml::node& item : *array) values.push_back(bare_number(entry, item));
    const auto inside = [this](double value) { return range_.contains(value); };
    if (!std::ranges::all_of(values, inside) ||
        std::ranges::adjacent_find(values, std::greater_equal{}) != values.end())
        entry.refuse("not " + allowed(), "write the numbers in rising order, each once");
    values_ = values;
}

std::string RisingReals::shown() const { return fmt::format("[{:.6g}]", fmt::join(values_, ", ")); }
std::string RisingReals::canonical() const { return fmt::format("[{:.14g}]", fmt::join(values_, ",")); }

template <class Int>
void Integer<Int>::read(const Entry& entry) {
    const auto value = entry.node.value_exact<std::int64_t>();
    if (!value) entry.refuse("not a whole number", "write a whole number without quotes");
    const bool listed = only_.empty() || std::ranges::find(only_, *value) != only_.end();
    if (*value < low_ || !listed || !std::in_range<Int>(*value))
        entry.refuse("out of range", fmt::format("write {}", allowed()));
    value_ = static_cast<Int>(*value);
}

template <class Int>
std::string Integer<Int>::allowed() const {
    return only_.empty() ? fmt::format(">= {}", low_) : fmt::format("one of {}", fmt::join(only_, ", "));
}

template class Integer<int>;
template class Integer<std::int64_t>;
template class Integer<std::uint64_t>;

}  // namespace sandgraph::scene
