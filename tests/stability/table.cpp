#include <fmt/format.h>

#include <algorithm>

#include "stability/suite.hpp"

namespace sandgraph::stability {
namespace {

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

}  // namespace

std::string markdown(std::span<const Outcome> outcomes) {
    std::string out = "| case | driven | checked | measured | bound | |\n|---|---|---|---|---|---|\n";
    for (const Outcome& o : outcomes)
        for (std::size_t k = 0; k < o.found.checks().size(); ++k) {
            const Check& c = o.found.checks()[k];
            out += k == 0 ? fmt::format("| {} ({:.0f} s) | {} |", o.name, o.seconds, in_cell(o.found.driven))
                          : "| | |";
            out += fmt::format(" {} | {:.4g} | {} | {} |\n", in_cell(c.what), c.value, bound(c), verdict(c));
        }
    return out;
}

std::string csv(std::span<const Outcome> outcomes) {
    std::string out = "case,driven,checked,measured,low,high,holds,seconds\n";
    for (const Outcome& o : outcomes)
        for (const Check& c : o.found.checks())
            out += fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{},{:.1f}\n", o.name, quoted(o.found.driven),
                               quoted(c.what), c.value, c.low, c.high,
                               c.bounded() ? c.holds() ? "yes" : "no" : "", o.seconds);
    return out;
}

}  // namespace sandgraph::stability
