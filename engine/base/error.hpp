#pragma once
#include <stdexcept>
#include <string>

namespace sandgraph {

// Bad input, told in one line: `file:line: problem (why); suggestion`. The command line exits with 2 on it.
class InputError : public std::runtime_error {
  public:
    struct Where {
        std::string file;
        int line = 0;  // 0: the whole file
    };
    InputError(const Where& where, const std::string& problem, const std::string& why,
               const std::string& suggestion);
};

// What an archive brought is not a state of this object: another program wrote it, or it was damaged behind
// its seal.
class StateError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// `what` names the part that does not fit.
inline void require_state(bool fits, const char* what) {
    if (!fits) throw StateError(std::string(what) + " do not fit");
}

// Every one of `indices` is in [0, end).
template <class Indices>
void require_indices(const Indices& indices, std::size_t end, const char* what) {
    for (const auto index : indices) require_state(index >= 0 && static_cast<std::size_t>(index) < end, what);
}

}  // namespace sandgraph
