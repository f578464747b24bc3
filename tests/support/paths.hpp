// Where the tests find the source tree and the program. Their values are compiled once, so that no other test
// file depends on the folder that it was built in.
#pragma once
#include <string>

namespace sandgraph::test {

// `relative` begins with a slash and is below the top of the source tree.
std::string source_file(const std::string& relative);
// The same, below tests/data.
std::string test_data(const std::string& relative);
// The program as built beside the tests.
std::string program();

}  // namespace sandgraph::test
