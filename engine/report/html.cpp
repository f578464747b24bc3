#include "report/html.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <sstream>

#include "base/text.hpp"

namespace sandgraph::report {
namespace {

constexpr std::string_view style = R"(
:root { --ink: #1d2733; --soft: #5b6875; --line: #d9dfe5; --paper: #ffffff; --accent: #0072b2; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1180px; padding: 2rem 1.5rem 5rem; background: var(--paper); color: var(--ink);
       font: 16px/1.55 system-ui, 'DejaVu Sans', sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.35rem; margin: 3rem 0 .6rem; padding-top: 1rem; border-top: 2px solid var(--ink); }
h3 { font-size: 1.05rem; margin: 1.8rem 0 .5rem; }
p.lead { color: var(--soft); margin: 0 0 1.5rem; }
.scroll { overflow-x: auto; margin-bottom: 1.2rem; }
table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; }
th, td { padding: .32rem .8rem .32rem 0; border-bottom: 1px solid var(--line); text-align: left; white-space: nowrap; }
th { color: var(--soft); font-weight: 600; }
table.numbers th:not(:first-child), table.numbers td:not(:first-child) { text-align: right; padding: .32rem 0 .32rem 1.2rem; }
.grid { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(520px, 100%), 1fr)); gap: 1.2rem; }
figure { margin: 0; }
figure img { width: 100%; height: auto; border: 1px solid var(--line); }
figcaption { color: var(--soft); font-size: .88rem; margin-top: .25rem; }
details { margin: 1rem 0; }
summary { cursor: pointer; color: var(--accent); }
pre { overflow-x: auto; background: #f4f6f8; padding: .9rem 1rem; font-size: .85rem; line-height: 1.4; }
a { color: var(--accent); }
.missing { color: var(--soft); font-style: italic; }
@media print { details > *:not(summary) { display: none; } h2 { break-before: page; } }
)";

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream out;
    if (in) out << in.rdbuf();
    return out.str();
}

std::string cells(const Row& row, const char* tag) {
    std::string text = "<tr>";
    for (const std::string& cell : row) text += fmt::format("<{0}>{1}</{0}>", tag, xml_escaped(cell));
    return text + "</tr>\n";
}

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - k);
        std::uint32_t group = 0;
        for (std::size_t i = 0; i < 3; ++i)
            group = group << 8 | (i < n ? static_cast<unsigned char>(bytes[k + i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i) out += i <= n ? digits[group >> (18 - 6 * i) & 63] : '=';
    }
    return out;
}

std::string table(const std::vector<Row>& rows, bool numbers) {
    std::string text = fmt::format("<div class=\"scroll\"><table{}>\n", numbers ? " class=\"numbers\"" : "");
    for (std::size_t k = 0; k < rows.size(); ++k) text += cells(rows[k], k == 0 ? "th" : "td");
    return text + "</table></div>\n";
}

std::string figure(const std::filesystem::path& png, std::string_view caption) {
    const std::string bytes = bytes_of(png);
    if (bytes.empty()) return fmt::format("<p class=\"missing\">no picture: {}</p>\n", xml_escaped(caption));
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
        xml_escaped(caption), base64(bytes));
}

std::string details(std::string_view summary, std::string_view inner_html) {
    return fmt::format("<details><summary>{}</summary>\n{}</details>\n", xml_escaped(summary), inner_html);
}

std::string page(std::string_view title, std::string_view body) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>{}</title>"
        "<style>{}</style></head>\n<body>\n{}</body></html>\n",
        xml_escaped(title), style, body);
}

}  // namespace sandgraph::report
