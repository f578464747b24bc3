#include "stability/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace sandgraph::stability {
namespace {

constexpr const char* columns = "case,driven,checked,measured,low,high,holds,why,seconds,revision";

std::string bound(const Check& c) {
    if (!c.bounded()) return "";
    if (c.low == c.high) return fmt::format("= {:.4g}", c.low);
    if (!c.bounded_above()) return fmt::format(">= {:.4g}", c.low);
    if (c.low == -c.high) return fmt::format("+- {:.4g}", c.high);
    return c.low < -1e300 ? fmt::format("<= {:.4g}", c.high) : fmt::format("{:.4g} to {:.4g}", c.low, c.high);
}

const char* verdict(const Check& c) { return !c.bounded() ? "" : c.holds() ? "holds" : "DOES NOT HOLD"; }

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
}

std::string in_cell(std::string text) {
    std::ranges::replace(text, '|', '/');
    std::ranges::replace(text, '\n', ' ');
    return text;
}

// The cells of a line of the CSV.
std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> out(1);
    bool inside = false;
    for (const char c : line) {
        if (c == '"' && !inside && !out.back().empty()) out.back() += c;  // the second of a doubled quote
        if (c == '"')
            inside = !inside;
        else if (c == ',' && !inside)
            out.emplace_back();
        else
            out.back() += c;
    }
    return out;
}

std::string summary(const std::string& command, std::span<const Outcome> outcomes) {
    std::size_t bounds = 0, broken = 0;
    std::set<std::string> revisions;
    std::string broken_ones, measured_at;
    for (const Outcome& o : outcomes) {
        revisions.insert(o.revision);
        for (const Check& c : o.found.checks()) {
            bounds += c.bounded(), broken += !c.holds();
            if (!c.holds()) broken_ones += fmt::format("- {}: {}: {:.4g}\n", o.name, c.what, c.value);
        }
    }
    for (const std::string& r : revisions) measured_at += (measured_at.empty() ? "" : ", ") + r;
    return fmt::format(
        "# The stability suite\n\nWritten by `{}`. Behind each case: its wall time and the revision it was "
        "measured at.\n\n{} cases at {}; {} bounds, of which {} do not hold{}\n{}\n",
        command, outcomes.size(), measured_at, bounds, broken, broken ? ":\n" : ".", broken_ones);
}

// An interrupted run leaves the old file or the new one.
void replace(const std::string& file, const std::string& text) {
    std::ofstream(file + ".new") << text;
    std::filesystem::rename(file + ".new", file);
}

}  // namespace

std::string markdown(std::span<const Outcome> outcomes) {
    std::string out = "| case | driven | checked | measured | bound | |\n|---|---|---|---|---|---|\n";
    for (const Outcome& o : outcomes)
        for (std::size_t k = 0; k < o.found.checks().size(); ++k) {
            const Check& c = o.found.checks()[k];
            out += k == 0 ? fmt::format("| {} ({:.0f} s, {}) | {} |", o.name, o.seconds, o.revision,
                                        in_cell(o.found.driven))
                          : "| | |";
            out += fmt::format(" {} | {:.4g} | {}{} | {} |\n", in_cell(c.what), c.value, bound(c),
                               c.why.empty() ? "" : ": " + in_cell(c.why), verdict(c));
        }
    return out;
}

std::string csv(std::span<const Outcome> outcomes) {
    std::string out = std::string(columns) + "\n";
    for (const Outcome& o : outcomes)
        for (const Check& c : o.found.checks())
            out += fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{},{},{:.1f},{}\n", o.name,
                               quoted(o.found.driven), quoted(c.what), c.value, c.low, c.high,
                               c.bounded() ? c.holds() ? "yes" : "no" : "", quoted(c.why), o.seconds,
                               o.revision);
    return out;
}

std::vector<Outcome> read_csv(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    std::vector<Outcome> out;
    if (!std::getline(in, line) || line != columns)
        throw std::runtime_error(file.string() + " is no table of this suite");
    while (std::getline(in, line)) {
        const std::vector<std::string> cell = cells(line);
        if (out.empty() || out.back().name != cell.at(0))
            out.push_back(
                {.name = cell[0], .found = {}, .seconds = std::stod(cell.at(8)), .revision = cell.at(9)});
        out.back().found.driven = cell[1];
        out.back().found.add({cell[2], std::stod(cell[3]), std::stod(cell[4]), std::stod(cell[5]), cell[7]});
    }
    return out;
}

void write_tables(const std::string& file, const std::string& command, std::span<const Outcome> outcomes) {
    replace(file + ".csv", csv(outcomes));
    replace(file + ".md", summary(command, outcomes) + markdown(outcomes));
}

}  // namespace sandgraph::stability
