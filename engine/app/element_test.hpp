#pragma once
#include <string>
#include <vector>

#include "dem/element_test.hpp"
#include "scene/element_test_spec.hpp"

namespace sandgraph::app {

// Runs the test on the packing and writes the rows as CSV to `file` (dem/element_test_csv.hpp); `metadata` is
// its first line, a JSON object. Returns one line that sums the outcome up.
std::string run_element_test(const scene::ElementTestSpec& spec, const dem::Packing& packing,
                             const std::string& file, const std::string& metadata);

}  // namespace sandgraph::app
