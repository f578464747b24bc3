#include "report/gnuplot.hpp"

#include <fmt/format.h>

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

std::string header(const Plot& plot) {
    return fmt::format(
        "set encoding utf8\nset terminal pngcairo size {},{} font 'DejaVu Sans,13' background 'white'\n"
        "set output 'picture.png'\n",
        plot.width, plot.height);
}

std::string first_lines(const fs::path& path) {
    std::ifstream in(path);
    std::string text, line;
    while (text.size() < 300 && std::getline(in, line))
        if (line.find_first_not_of(" ^\t") != std::string::npos) text += (text.empty() ? "" : " ") + line;
    return text;
}

Picture draw_in(const WorkFolder& folder, const Plot& plot, const fs::path& png, const std::string& program) {
    write(folder / "plot.gp", header(plot) + plot.script);
    for (const auto& [name, contents] : plot.data) write(folder / name, contents);
    const int status = run_program({program, "plot.gp"}, folder.path(), folder / "messages");
    if (status == program_missing)
        return {false, fmt::format("{}: no picture: {} is not installed; install gnuplot-nox", png.string(),
                                   program)};
    const std::string complaint = first_lines(folder / "messages");
    if (status != 0 || !fs::exists(folder / "picture.png"))
        return {false, fmt::format("{}: no picture: {} failed: {}", png.string(), program, complaint)};
    fs::rename(folder / "picture.png", png);
    return {true, complaint};
}

}  // namespace

Picture draw(const Plot& plot, const fs::path& png, const std::string& program) {
    try {
        return draw_in(WorkFolder(png), plot, png, program);
    } catch (const std::exception& error) {
        return {false, fmt::format("{}: no picture: {}", png.string(), error.what())};
    }
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

}  // namespace sandgraph::report
