#include "base/contracts.hpp"

#include <cstdio>
#include <cstdlib>

namespace sandgraph {

// Plain C: whatever is broken, this must still work.
void broken_contract(const char* kind, const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: %s broken: %s\n", file, line, kind, condition);
    std::fflush(stderr);
    std::abort();
}

}  // namespace sandgraph
