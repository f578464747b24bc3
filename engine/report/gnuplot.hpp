#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sandgraph::report {

// What became of a picture. Pictures are an extra: no run stops for one, so failure is a value, not a throw.
struct Picture {
    bool drawn = false;
    std::string message;  // why not, in one line
};

// A gnuplot script and the data files it plots by name. The script must not set terminal or output.
struct Plot {
    int width = 1100, height = 750;  // [px]
    std::string script;
    std::vector<std::pair<std::string, std::string>> data;  // file name, contents
};

// Draws a PNG: script and data go to a temporary folder beside it, `program` runs there without a shell, and
// the picture is renamed into place only when gnuplot ended without complaint.
Picture draw(const Plot& plot, const std::filesystem::path& png, const std::string& program = "gnuplot");

// A gnuplot string literal of any text.
std::string literal(std::string_view text);

}  // namespace sandgraph::report
