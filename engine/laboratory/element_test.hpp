#pragma once
#include <string>
#include <vector>

#include "dem/element_test/element_test.hpp"
#include "scene/element_test_spec.hpp"

namespace sandgraph::laboratory {

struct ElementOutcome {
    std::string csv;   // the rows (dem/element_test_csv.hpp)
    std::string told;  // one line that sums them up
};

// Runs the test on the packing; `metadata`, a JSON object, is the first line of the CSV.
ElementOutcome run_element_test(const scene::ElementTestSpec& spec, const dem::Packing& packing,
                                const std::string& metadata);

}  // namespace sandgraph::laboratory
