#include "report/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <system_error>

#include "base/process.hpp"

namespace sandgraph::report {
namespace fs = std::filesystem;
namespace {

// A fresh folder beside the picture (so that renaming stays on one file system), removed at the end.
class WorkFolder {
  public:
    explicit WorkFolder(const fs::path& beside) {
        const fs::path parent = beside.has_parent_path() ? beside.parent_path() : fs::path(".");
        std::string name = (fs::absolute(parent) / ".plot-XXXXXX").string();
        if (!::mkdtemp(name.data()))
            throw std::system_error(errno, std::generic_category(),
                                    parent.string() + ": cannot create a folder");
        path_ = name;
    }
    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    fs::path operator/(const std::string& name) const { return path_ / name; }
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

void write(const fs::path& path, const std::string& text) {
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error(path.string() + ": cannot write");
}

// Bitmaps have more pixels than the layout, for print and for sharp screens.
double density(const Plot& plot) { return plot.width > 1000 ? 1.5 : 2; }

constexpr double pixels_per_inch = 96;

std::string terminal(const Plot& plot, const std::string& format) {
    if (format == ".svg")
        return fmt::format("svg size {},{} dynamic font 'DejaVu Sans,16' background 'white'", plot.width,
                           plot.height);
    if (format == ".pdf")
        return fmt::format("pdfcairo size {},{} font 'DejaVu Sans,13' fontscale 0.75 background 'white'",
                           plot.width / pixels_per_inch, plot.height / pixels_per_inch);
    const double k = density(plot);
    return fmt::format(
        "pngcairo size {:.0f},{:.0f} font 'DejaVu Sans,13' fontscale {} linewidth {} pointscale {} "
        "background "
        "'white'",
        k * plot.width, k * plot.height, k, k, k);
}

// What a user may have set: GNUTERM of a terminal that is not there ends gnuplot before our first line.
constexpr std::array private_settings{"GNUTERM",
                                      "GNUPLOT_DRIVER_DIR",
                                      "GNUPLOT_LIB",
                                      "GNUPLOT_FONTPATH",
                                      "GDFONTPATH",
                                      "GNUPLOT_DEFAULT_GDFONT",
                                      "GNUPLOT_COLORSEQUENCE",
                                      "GNUPLOT_PS_DIR",
                                      "GNUPLOT_LUA_DIR",
                                      "FIT_SCRIPT",
                                      "FIT_LOG"};

constexpr double letter_width = 9.4;  // [px], of DejaVu Sans, a little more than the mean
constexpr std::size_t most_lines = 4;

std::size_t letters(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

// The first `count` letters, in bytes.
std::size_t bytes_of(std::string_view text, std::size_t count) {
    std::size_t k = 0;
    while (k < text.size() && letters(text.substr(0, k + 1)) <= count) ++k;
    return k;
}

std::string first_lines(const fs::path& path) {
    std::ifstream in(path);
    std::string text, line;
    while (text.size() < 300 && std::getline(in, line))
        if (line.find_first_not_of(" ^\t") != std::string::npos) text += (text.empty() ? "" : " ") + line;
    return text;
}

Picture draw_in(const WorkFolder& folder, const Plot& plot, const fs::path& file,
                const std::string& program) {
    const std::string output = "picture" + file.extension().string();
    write(folder / "plot.gp", header(plot, output) + plot.script);
    for (const auto& [name, contents] : plot.data) write(folder / name, contents);
    const int status = run_program(command(program, "plot.gp"), folder.path(), folder / "messages");
    if (status == program_missing)
        return {false, fmt::format("{}: no picture: {} is not installed; install gnuplot-nox", file.string(),
                                   program)};
    const std::string complaint = first_lines(folder / "messages");
    if (status != 0 || !fs::exists(folder / output))
        return {false, fmt::format("{}: no picture: {} failed: {}", file.string(), program, complaint)};
    fs::rename(folder / output, file);
    return {true, complaint};
}

}  // namespace

std::string header(const Plot& plot, const fs::path& output) {
    return fmt::format("set encoding utf8\nset terminal {}\nset output {}\n",
                       terminal(plot, output.extension().string()), literal(output.string()));
}

std::vector<std::string> command(const std::string& program, const std::string& script) {
    std::vector<std::string> words{"env"};
    for (const char* name : private_settings) words.insert(words.end(), {"-u", name});
    words.insert(words.end(), {program, "-d", script});  // -d: no start-up file, of user or system
    return words;
}

Picture draw_formats(const Plot& plot, const fs::path& png, const std::vector<std::string>& formats) {
    Picture picture{true, ""};
    for (const std::string& format : formats)
        if (picture.drawn) picture = draw(plot, fs::path(png).replace_extension(format));
    return picture;
}

Picture draw(const Plot& plot, const fs::path& file, const std::string& program) {
    try {
        return draw_in(WorkFolder(file), plot, file, program);
    } catch (const std::exception& error) {
        return {false, fmt::format("{}: no picture: {}", file.string(), error.what())};
    }
}

std::string key_below(Plot& plot, std::size_t rows) {
    constexpr double row = 22, axis = 62;  // [px]: a line of the key, the axis with its numbers and label
    const double key = row * static_cast<double>(rows) + 8;
    plot.height += static_cast<int>(key);
    return fmt::format(
        "set bmargin at screen {}\nset key at screen {}, screen {} left top vertical Left reverse maxcols 1 "
        "maxrows {} samplen 2 noenhanced\n",
        (key + axis) / plot.height, 90.0 / plot.width, key / plot.height, rows);
}

std::string literal(std::string_view text) {
    // In gnuplot's single quotes only the quote itself is special, and doubled.
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'') result += '\'';
        result += c == '\n' || c == '\r' ? ' ' : c;
    }
    return result + "'";
}

std::vector<std::string> lines_of(std::string_view text, int width) {
    const auto most = static_cast<std::size_t>(std::max(8.0, width / letter_width));
    std::vector<std::string> lines;
    while (!text.empty() && lines.size() < most_lines) {
        std::size_t end = bytes_of(text, most);
        if (end < text.size())
            if (const std::size_t blank = text.rfind(' ', end); blank != std::string_view::npos && blank > 0)
                end = blank;
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(text.size(), text.find_first_not_of(' ', end)));
    }
    if (!text.empty()) lines.back() += " ...";
    return lines;
}

std::string wrapped(std::string_view text, int width) {
    std::string result;
    for (const std::string& line : lines_of(text, width))
        result += (result.empty() ? "" : ".\"\\n\".") + literal(line);
    return result.empty() ? "''" : result;
}

}  // namespace sandgraph::report
