#include "base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>
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
    // length
    Unit{"m", "length", 1, 1},
    Unit{"cm", "length", 1, 100},
    Unit{"mm", "length", 1, 1000},
    Unit{"um", "length", 1, 1e6},
    Unit{"km", "length", 1000, 1},
    // pressure
    Unit{"Pa", "pressure", 1, 1},
    Unit{"hPa", "pressure", 100, 1},
    Unit{"kPa", "pressure", 1e3, 1},
    Unit{"MPa", "pressure", 1e6, 1},
    Unit{"GPa", "pressure", 1e9, 1},
    Unit{"N/m2", "pressure", 1, 1},
    Unit{"kN/m2", "pressure", 1e3, 1},
    Unit{"MN/m2", "pressure", 1e6, 1},
    Unit{"N/mm2", "pressure", 1e6, 1},
    Unit{"N/cm2", "pressure", 1e4, 1},
    Unit{"kN/cm2", "pressure", 1e7, 1},
    Unit{"kN/mm2", "pressure", 1e9, 1},
    Unit{"bar", "pressure", 1e5, 1},
    Unit{"mbar", "pressure", 100, 1},
    // angle
    Unit{"rad", "angle", 1, 1},
    Unit{"deg", "angle", std::numbers::pi, 180},
    Unit{"degree", "angle", std::numbers::pi, 180},
    Unit{"degrees", "angle", std::numbers::pi, 180},
    Unit{"\xC2\xB0", "angle", std::numbers::pi, 180},
    // time
    Unit{"s", "time", 1, 1},
    Unit{"ms", "time", 1, 1000},
    Unit{"us", "time", 1, 1e6},
    Unit{"min", "time", 60, 1},
    Unit{"h", "time", 3600, 1},
    Unit{"d", "time", 86400, 1},
    Unit{"day", "time", 86400, 1},
    // velocity
    Unit{"m/s", "velocity", 1, 1},
    Unit{"cm/s", "velocity", 1, 100},
    Unit{"mm/s", "velocity", 1, 1e3},
    Unit{"um/s", "velocity", 1, 1e6},
    Unit{"m/min", "velocity", 1, 60},
    Unit{"cm/min", "velocity", 1, 6000},
    Unit{"mm/min", "velocity", 1, 60e3},
    Unit{"m/h", "velocity", 1, 3600},
    Unit{"cm/h", "velocity", 1, 360e3},
    Unit{"mm/h", "velocity", 1, 3600e3},
    Unit{"mm/d", "velocity", 1, 86400e3},
    Unit{"mm/day", "velocity", 1, 86400e3},
    // acceleration
    Unit{"m/s2", "acceleration", 1, 1},
    Unit{"cm/s2", "acceleration", 1, 100},
    Unit{"mm/s2", "acceleration", 1, 1000},
    Unit{"N/kg", "acceleration", 1, 1},
    // rate
    Unit{"1/s", "rate", 1, 1},
    Unit{"s-1", "rate", 1, 1},
    Unit{"1/min", "rate", 1, 60},
    Unit{"1/h", "rate", 1, 3600},
    Unit{"%/s", "rate", 1, 100},
    Unit{"%/min", "rate", 1, 6000},
    Unit{"%/h", "rate", 1, 360e3},
    // density
    Unit{"kg/m3", "density", 1, 1},
    Unit{"g/cm3", "density", 1e3, 1},
    Unit{"kg/dm3", "density", 1e3, 1},
    Unit{"t/m3", "density", 1e3, 1},
    Unit{"Mg/m3", "density", 1e3, 1},
    // unit weight, and pressure a length
    Unit{"N/m3", "unit weight", 1, 1},
    Unit{"kN/m3", "unit weight", 1e3, 1},
    Unit{"MN/m3", "unit weight", 1e6, 1},
    Unit{"Pa/m", "unit weight", 1, 1},
    Unit{"kPa/m", "unit weight", 1e3, 1},
    Unit{"MPa/m", "unit weight", 1e6, 1},
    // force, and force a length
    Unit{"N", "force", 1, 1},
    Unit{"kN", "force", 1e3, 1},
    Unit{"MN", "force", 1e6, 1},
    Unit{"N/m", "force a length", 1, 1},
    Unit{"kN/m", "force a length", 1e3, 1},
    Unit{"MN/m", "force a length", 1e6, 1},
    // size
    Unit{"B", "size", 1, 1},
    Unit{"kB", "size", 1e3, 1},
    Unit{"MB", "size", 1e6, 1},
    Unit{"GB", "size", 1e9, 1},
    Unit{"TB", "size", 1e12, 1},
};

// Units that people write and that are no SI; a nearest SI name would be another quantity.
constexpr std::string_view foreign =
    " ft foot feet in inch inches yd yard yards mi mile miles psi ksi psf ksf pcf lb lbs lbf kip kips tsf "
    "atm at "
    "torr mmHg kgf kp kgf/cm2 kp/cm2 kg/cm2 t/m2 kp/m2 kgf/m2 tf tf/m2 tf/m3 ft/s ft/min in/s in/min in/h "
    "ft/s2 "
    "lb/ft3 lbf/ft2 lbf/in2 lb/in3 slug slug/ft3 gon grad turn rev mph knot year yr ";

// "m/s^2", "kN/m\u00B2", "kN/m**2", "kN / m2" and "kg*m-3" are the same people writing.
std::string plain(std::string_view written) {
    std::string out;
    for (const char c : written)
        if (c != ' ' && c != '^') out += c;
    const std::pair<std::string_view, std::string_view> spellings[] = {
        {"\xC2\xB2", "2"}, {"\xC2\xB3", "3"}, {"**", ""}, {"\xC2\xB5", "u"}, {"\xCE\xBC", "u"}, {"sec", "s"}};
    for (const auto& [from, to] : spellings)
        for (std::size_t at = 0; (at = out.find(from)) != std::string::npos;)
            out.replace(at, from.size(), to);
    return out;
}

const Unit* find_unit(std::string_view name) {
    const auto* found = std::ranges::find(units, name, &Unit::name);
    return found == units.end() ? nullptr : found;
}

bool is_foreign(const std::string& name) { return foreign.find(" " + name + " ") != std::string_view::npos; }

// Units of the wanted dimension first, so that a tie of the edit distance suggests one that fits.
std::string nearest_unit(std::string_view name, std::string_view dimension) {
    std::vector<std::string> known;
    for (const bool fitting : {true, false})
        for (const Unit& unit : units)
            if ((unit.dimension == dimension) == fitting) known.emplace_back(unit.name);
    return nearest_name(name, known);
}

// A weight of so much a volume is a mass at standard gravity.
double weight_to_mass(const Unit& unit, const Unit& wanted) {
    return unit.dimension == "unit weight" && wanted.dimension == "density" ? standard_gravity : 1;
}

// A quantity being read: who it belongs to and how it was written, for the error messages.
struct Reader {
    const InputError::Where& where;
    std::string_view name, text;

    [[noreturn]] void refuse(const std::string& why, const std::string& suggestion) const {
        throw InputError(where, fmt::format("{} = \"{}\"", name, text), why, suggestion);
    }
    [[noreturn]] void refuse_unknown(std::string_view unit, const Unit& wanted) const {
        if (is_foreign(plain(unit)))
            refuse(fmt::format("\"{}\" is no SI unit", unit),
                   fmt::format("convert it and write it in {}", wanted.name));
        refuse(fmt::format("unknown unit \"{}\"", unit),
               fmt::format("did you mean \"{}\"?", nearest_unit(unit, wanted.dimension)));
    }
    const Unit& unit_of(std::string_view unit, std::string_view number, const Unit& wanted) const {
        const std::string example = fmt::format("write \"{} {}\"", number, wanted.name);
        if (unit.empty()) refuse("no unit", example);
        const Unit* known = find_unit(plain(unit));
        if (!known) refuse_unknown(unit, wanted);
        if (known->dimension != wanted.dimension && weight_to_mass(*known, wanted) == 1)
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
    return number * unit.numerator / unit.denominator / weight_to_mass(unit, wanted);
}

bool is_unit_weight(std::string_view text) {
    const std::size_t letters = text.find_first_not_of("+-0123456789.eE ");
    if (letters == std::string_view::npos) return false;
    const Unit* unit = find_unit(plain(trimmed(text.substr(letters))));
    return unit && unit->dimension == "unit weight";
}

std::string format_quantity(double si, std::string_view unit) {
    if (unit.empty()) return fmt::format("{:.12g}", si);
    const Unit& known = *find_unit(unit);
    return fmt::format("{:.12g} {}", si * known.denominator / known.numerator, unit);
}

}  // namespace sandgraph
