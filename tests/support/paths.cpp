#include "support/paths.hpp"

namespace sandgraph::test {

std::string source_file(const std::string& relative) { return SANDGRAPH_SOURCE + relative; }

std::string test_data(const std::string& relative) { return source_file("/tests/data" + relative); }

std::string program() { return SANDGRAPH_BINARY; }

}  // namespace sandgraph::test
