#pragma once
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace sandgraph {

// `text` ("30 kPa", "23 deg", "0.1 1/s") in SI. `like` is a unit of the wanted dimension ("Pa"), in which a
// suggestion is written; `name` is what the value belongs to, for the error. Refuses with InputError: no
// number, NaN or infinity, no unit, an unknown unit (naming the nearest), a unit of another dimension. `like`
// must be a known unit.
// Known are the SI units that scenes use with their usual prefixes and products, and deg for angles.
double parse_quantity(const InputError::Where& where, std::string_view name, std::string_view text,
                      std::string_view like);

// `si` written in `unit` ("" for a pure number) to 12 digits, no more than needed: "30 kPa", "0.5".
std::string format_quantity(double si, std::string_view unit);

}  // namespace sandgraph
