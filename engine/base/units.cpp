#include "base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/text.hpp"

namespace sandgraph {
namespace {

// SI = number * numerator / denominator: "7 mm" and "23 deg" give the very bits of 0.007 and 23 pi / 180.
struct Unit {
    std::string_view name, dimension;
    double numerator, denominator;
};

constexpr std::array units = {
    Unit{"m", "length", 1, 1},        Unit{"cm", "length", 1, 100},
    Unit{"mm", "length", 1, 1000},    Unit{"um", "length", 1, 1e6},
    Unit{"Pa", "pressure", 1, 1},     Unit{"kPa", "pressure", 1e3, 1},
    Unit{"MPa", "pressure", 1e6, 1},  Unit{"GPa", "pressure", 1e9, 1},
    Unit{"rad", "angle", 1, 1},       Unit{"deg", "angle", std::numbers::pi, 180},
    Unit{"s", "time", 1, 1},          Unit{"ms", "time", 1, 1000},
    Unit{"us", "time", 1, 1e6},       Unit{"min", "time", 60, 1},
    Unit{"h", "time", 3600, 1},       Unit{"m/s", "velocity", 1, 1},
    Unit{"mm/s", "velocity", 1, 1e3}, Unit{"m/s2", "acceleration", 1, 1},
    Unit{"1/s", "rate", 1, 1},        Unit{"kg/m3", "density", 1, 1},
    Unit{"g/cm3", "density", 1e3, 1}, Unit{"t/m3", "density", 1e3, 1},
    Unit{"MB", "size", 1e6, 1},       Unit{"GB", "size", 1e9, 1},
};

const Unit* find_unit(std::string_view name) {
    const auto* found = std::ranges::find(units, name, &Unit::name);
    return found == units.end() ? nullptr : found;
}

// Units of the wanted dimension first, so that a tie of the edit distance suggests one that fits.
std::string nearest_unit(std::string_view name, std::string_view dimension) {
    std::vector<std::string> known;
    for (const bool fitting : {true, false})
        for (const Unit& unit : units)
            if ((unit.dimension == dimension) == fitting) known.emplace_back(unit.name);
    return nearest_name(name, known);
}

// A quantity being read: who it belongs to and how it was written, for the error messages.
struct Reader {
    const InputError::Where& where;
    std::string_view name, text;

    [[noreturn]] void refuse(const std::string& why, const std::string& suggestion) const {
        throw InputError(where, fmt::format("{} = \"{}\"", name, text), why, suggestion);
    }
    const Unit& unit_of(std::string_view unit, std::string_view number, const Unit& wanted) const {
        const std::string example = fmt::format("write \"{} {}\"", number, wanted.name);
        if (unit.empty()) refuse("no unit", example);
        const Unit* known = find_unit(unit);
        if (!known)
            refuse(fmt::format("unknown unit \"{}\"", unit),
                   fmt::format("did you mean \"{}\"?", nearest_unit(unit, wanted.dimension)));
        if (known->dimension != wanted.dimension)
            refuse(fmt::format("\"{}\" is a unit of {}, not of {}", unit, known->dimension, wanted.dimension),
                   example);
        return *known;
    }
};

}  // namespace

double parse_quantity(const InputError::Where& where, std::string_view name, std::string_view text,
                      std::string_view like) {
    const Reader reader{where, name, text};
    std::string_view body = trimmed(text);
    if (body.starts_with('+')) body.remove_prefix(1);
    double number = 0;
    const auto [end, status] = std::from_chars(body.data(), body.data() + body.size(), number);
    const Unit& wanted = *find_unit(like);
    if (status != std::errc{})
        reader.refuse("does not start with a number",
                      fmt::format("write a number and a unit, as \"1 {}\"", like));
    if (!std::isfinite(number)) reader.refuse("not a finite number", "write a finite number");
    const auto digits = static_cast<std::size_t>(end - body.data());
    const Unit& unit = reader.unit_of(trimmed(body.substr(digits)), body.substr(0, digits), wanted);
    return number * unit.numerator / unit.denominator;
}

std::string format_quantity(double si, std::string_view unit) {
    if (unit.empty()) return fmt::format("{:.12g}", si);
    const Unit& known = *find_unit(unit);
    return fmt::format("{:.12g} {}", si * known.denominator / known.numerator, unit);
}

}  // namespace sandgraph
