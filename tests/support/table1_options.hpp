#pragma once
#include "dem/rve_options.hpp"

namespace sandgraph::support {

// The usual stepping with round figures for Table 1 grains, so that tests do not hang on dem::rve_options.
inline dem::RveOptions table1_options() {
    dem::RveOptions options;
    options.time_step = 1e-5;  // [s]
    options.modulus = 2e7;     // [Pa]
    return options;
}

}  // namespace sandgraph::support
