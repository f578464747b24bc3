#pragma once
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace sandgraph {

// `text` ("30 kPa", "23 deg", "0.1 1/s") in SI. `like` is a unit of the wanted dimension ("Pa"), in which a
// suggestion is written; `name` is what the value belongs to, for the error. Refuses with InputError: no
// number, NaN or infinity, no unit, an unknown unit (naming the nearest), a unit of another dimension. `like`
// must be a known unit.
// Known are the SI units of soil mechanics with their usual prefixes, products and spellings ("kN/m2",
// "m/s^2", "mm/min", "t/m3"), bar, and degrees for angles. Others that people write ("ft", "psi") are told to
// be none.
double parse_quantity(const InputError::Where& where, std::string_view name, std::string_view text,
                      std::string_view like);

// A unit weight ("20 kN/m3") where a density is asked for is divided by standard gravity; `is_unit_weight`
// tells such a text, whose density is another one under another gravity.
inline constexpr double standard_gravity = 9.81;  // [m/s2]
bool is_unit_weight(std::string_view text);

// `si` written in `unit` ("" for a pure number) to 12 digits, no more than needed: "30 kPa", "0.5".
std::string format_quantity(double si, std::string_view unit);

}  // namespace sandgraph
