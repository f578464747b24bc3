#pragma once
#include <cstddef>
#include <vector>

// Contracts: what a function's docstring promises, as code.
//   SG_EXPECT(dt > 0);                 what the caller owes (precondition)
//   SG_ENSURE(points.size() == n);     what the caller gets (postcondition)
// Where SANDGRAPH_CONTRACTS is 1 (Debug builds: the presets dev, asan-ubsan, tsan and fuzz) a broken contract
// prints file, line and condition and aborts, so that no handler can hide it. Elsewhere the condition is
// compiled but never evaluated. A contract is for mistakes of the program; bad input is an InputError.
#ifndef SANDGRAPH_CONTRACTS
#define SANDGRAPH_CONTRACTS 0
#endif

#define SG_CONTRACT_CHECKED(kind, ...)                     \
    (static_cast<bool>(__VA_ARGS__) ? static_cast<void>(0) \
                                    : ::sandgraph::broken_contract(kind, #__VA_ARGS__, __FILE__, __LINE__))
#define SG_CONTRACT_IGNORED(...) static_cast<void>(sizeof(static_cast<bool>(__VA_ARGS__)))

#if SANDGRAPH_CONTRACTS
#define SG_EXPECT(...) SG_CONTRACT_CHECKED("precondition", __VA_ARGS__)
#define SG_ENSURE(...) SG_CONTRACT_CHECKED("postcondition", __VA_ARGS__)
#else
#define SG_EXPECT(...) SG_CONTRACT_IGNORED(__VA_ARGS__)
#define SG_ENSURE(...) SG_CONTRACT_IGNORED(__VA_ARGS__)
#endif

namespace sandgraph {

// Prints "file:line: precondition broken: condition" to stderr and aborts (console.cpp).
[[noreturn]] void broken_contract(const char* kind, const char* condition, const char* file, int line);

// For contracts on lists of indices: each is in [0, end).
template <class Indices>
bool all_below(const Indices& indices, std::size_t end) {
    for (const auto index : indices)
        if (index < 0 || static_cast<std::size_t>(index) >= end) return false;
    return true;
}

// The same, and none comes twice.
template <class Indices>
bool distinct_below(const Indices& indices, std::size_t end) {
    std::vector<bool> seen(end, false);
    for (const auto index : indices) {
        if (index < 0 || static_cast<std::size_t>(index) >= end || seen[static_cast<std::size_t>(index)])
            return false;
        seen[static_cast<std::size_t>(index)] = true;
    }
    return true;
}

}  // namespace sandgraph
