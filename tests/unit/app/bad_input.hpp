#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/subprocess.hpp"

namespace sandgraph::app {

// Sixteen disks on a square lattice that just touch: an elastic solid with a known answer, as packing CSV.
inline std::string lattice() {
    std::string text = "# {}\n# cell\n# 0.08 0 0 0.08\nid,x,y,r\n";
    for (int id = 0; id < 16; ++id)
        text += fmt::format("{},{},{},0.01\n", id, 0.01 + 0.02 * (id % 4), 0.01 + 0.02 * (id / 4));
    return text;
}

// Exit code 2, exactly one line on stderr that starts with `where` and holds `problem`, a reason and a
// suggestion.
inline void expect_bad_input(const Shell::Outcome& outcome, const std::string& where,
                             const std::string& problem) {
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind(where + ": ", 0), 0u) << outcome.err;
    EXPECT_NE(outcome.err.find(problem), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(" ("), std::string::npos) << "no reason: " << outcome.err;
    EXPECT_NE(outcome.err.find("; "), std::string::npos) << "no suggestion: " << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

}  // namespace sandgraph::app
