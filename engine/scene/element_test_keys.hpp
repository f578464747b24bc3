#pragma once
#include "scene/element_test_spec.hpp"
#include "scene/key_table.hpp"

namespace sandgraph::scene {

// In the order of TestKind.
std::vector<std::string> test_kind_names();

// The keys that a test of `spec.kind` has; a key of another kind is unknown, so nothing is silently ignored.
KeyTable element_test_keys(ElementTestSpec& spec);

}  // namespace sandgraph::scene
