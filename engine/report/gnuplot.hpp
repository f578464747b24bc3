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

// A gnuplot script and the data files it plots by name. The script must not set terminal or output. The size
// is that of the layout, letters being 17 px high: at half of the default width they can still be read.
struct Plot {
    int width = 720, height = 500;  // [px]
    std::string script;
    std::vector<std::pair<std::string, std::string>> data;  // file name, contents
};

// Draws a PNG, SVG or PDF, by the extension of `file`: script and data go to a temporary folder beside it,
// `program` runs there without a shell, and the picture is renamed into place only when gnuplot ended without
// complaint. What the user has set for gnuplot (start-up files, environment) does not reach the picture.
Picture draw(const Plot& plot, const std::filesystem::path& file, const std::string& program = "gnuplot");

// In each of the formats (extensions, ".png"), beside each other; the first failure ends it.
Picture draw_formats(const Plot& plot, const std::filesystem::path& png,
                     const std::vector<std::string>& formats);

// What draw tells gnuplot before the script: terminal and output.
std::string header(const Plot& plot, const std::filesystem::path& output);

// The command that runs the script of that name.
std::vector<std::string> command(const std::string& program, const std::string& script);

// A key of `rows` lines, a column, below the axes: room for it is added to the plot's height.
std::string key_below(Plot& plot, std::size_t rows);

// A gnuplot string literal of any text.
std::string literal(std::string_view text);

// A gnuplot expression of a text that is broken into lines which fit into `width` [px] of letters of the
// usual size; of a text past four lines the end is left out.
std::string wrapped(std::string_view text, int width);
// The lines themselves.
std::vector<std::string> lines_of(std::string_view text, int width);

}  // namespace sandgraph::report
