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

}  // namespace sandgraph
