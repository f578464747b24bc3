#include "report/html.hpp"

#include <fmt/format.h>

#include <cctype>
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
th, td { padding: .32rem .8rem .32rem 0; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { color: var(--soft); font-weight: 600; }
table.pairs { width: 100%; }
table.numbers th:not(:first-child), table.numbers td:not(:first-child) { text-align: right; padding: .32rem 0 .32rem 1.2rem; }
table.wide { font-size: .86rem; }
table.wide td:first-child, table.wide td:nth-child(2) { min-width: 7rem; }
table.wide.numbers th:not(:first-child), table.wide.numbers td:not(:first-child) { padding-left: .9rem; }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(460px, 100%), 1fr)); gap: 1.2rem 1.8rem; }
.grid > *, .grid figure { min-width: 0; }
figure { margin: 0 0 1.2rem; max-width: 900px; }
.grid figure { margin: 0; }
.pan { overflow-x: auto; border: 1px solid var(--line); }
figure img { display: block; width: 100%; height: auto; }
figcaption { color: var(--soft); font-size: .88rem; margin-top: .25rem; }
h1, h2, p, td:first-child, figcaption { overflow-wrap: anywhere; }
details { margin: 1rem 0; }
summary { cursor: pointer; color: var(--accent); }
pre { overflow-x: auto; background: #f4f6f8; padding: .9rem 1rem; font-size: .85rem; line-height: 1.4; }
a { color: var(--accent); }
.missing { color: var(--soft); font-style: italic; }
@media screen and (max-width: 640px) {
  body { padding: 1.1rem .9rem 3rem; font-size: 15px; }
  h1 { font-size: 1.5rem; }
  h2 { font-size: 1.2rem; margin-top: 2rem; }
  table.wide, table.wide tbody, table.wide tr, table.wide td { display: block; }
  table.wide tr:first-child { display: none; }
  table.wide tr { border-bottom: 2px solid var(--ink); padding: .5rem 0; }
  table.wide td, table.wide.numbers td:not(:first-child) { display: flex; justify-content: space-between; gap: 1rem;
       white-space: normal; text-align: right; padding: .2rem 0; border: 0; }
  table.wide td::before { content: attr(data-label); color: var(--soft); text-align: left; flex: none; max-width: 55%; }
  figure img.broad { width: 760px; max-width: none; }
}
@page { size: A4; margin: 11mm 12mm; }
@media print {
  body { max-width: none; padding: 0; font-size: 9pt; line-height: 1.35; }
  h1 { font-size: 15pt; }
  h2 { font-size: 12pt; margin: 5mm 0 1mm; padding-top: 2mm; border-top-width: 1pt; }
  h3 { font-size: 10pt; margin: 2mm 0 1mm; }
  h2, h3, p.lead { break-after: avoid; }
  p.lead { margin-bottom: 2mm; }
  .scroll { overflow: visible; margin-bottom: 2mm; }
  .pan { overflow: visible; border: 0; }
  table { font-size: 8pt; }
  th, td, table.numbers th:not(:first-child), table.numbers td:not(:first-child) { padding-top: .25mm; padding-bottom: .25mm; }
  table.wide { font-size: 7pt; width: 100%; }
  table.wide th, table.wide td, table.wide.numbers th:not(:first-child), table.wide.numbers td:not(:first-child) {
       white-space: normal; padding-left: 1mm; }
  table.wide td:first-child, table.wide td:nth-child(2) { min-width: 18mm; }
  .grid { grid-template-columns: 1fr 1fr; gap: 2mm 5mm; }
  figure { break-inside: avoid; margin-bottom: 2mm; }
  figure img { max-height: 115mm; object-fit: contain; }
  .grid figure img { max-height: 56mm; }
  .fields figcaption { display: none; }
  figcaption { font-size: 7.5pt; margin: 0; }
  tr, .pairs { break-inside: avoid; }
  a { color: inherit; text-decoration: none; }
  h3 + .grid { break-before: avoid; }
  details, .screen-only { display: none; }
}
)";

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream out;
    if (in) out << in.rdbuf();
    return out.str();
}

std::string head(const Row& row) {
    std::string text = "<tr>";
    for (const std::string& cell : row) text += fmt::format("<th>{}</th>", xml_escaped(cell));
    return text + "</tr>\n";
}

// Each cell with its column's name, for the cards of a phone.
std::string cells(const Row& row, const Row& names, const std::string& link) {
    std::string text = "<tr>";
    for (std::size_t k = 0; k < row.size(); ++k) {
        std::string inner = xml_escaped(row[k]);
        if (k == 0 && !link.empty()) inner = fmt::format("<a href=\"{}\">{}</a>", xml_escaped(link), inner);
        const std::string name = k < names.size() ? xml_escaped(names[k]) : "";
        text += fmt::format("<td data-label=\"{}\">{}</td>", name, inner);
    }
    return text + "</tr>\n";
}

constexpr std::size_t widest_pairs = 3;  // columns
constexpr int usual_width = 1500;        // of a PNG [px]

// From the PNG's header; 0 if it is none.
int width_of(std::string_view png) {
    if (png.size() < 20 || png.substr(1, 3) != "PNG") return 0;
    int width = 0;
    for (std::size_t k = 16; k < 20; ++k) width = width * 256 + static_cast<unsigned char>(png[k]);
    return width;
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

std::string table(const std::vector<Row>& rows, bool numbers, const std::vector<std::string>& links) {
    if (rows.empty()) return "";
    std::string text =
        fmt::format("<div class=\"scroll\"><table class=\"{}{}\">\n",
                    rows.front().size() > widest_pairs ? "wide" : "pairs", numbers ? " numbers" : "");
    text += head(rows.front());
    for (std::size_t k = 1; k < rows.size(); ++k)
        text += cells(rows[k], rows.front(), k < links.size() ? links[k] : "");
    return text + "</table></div>\n";
}

std::string figure(const std::filesystem::path& png, std::string_view caption) {
    const std::string bytes = bytes_of(png);
    if (bytes.empty()) return fmt::format("<p class=\"missing\">no picture: {}</p>\n", xml_escaped(caption));
    return fmt::format(
        "<figure><div class=\"pan\"><img alt=\"{0}\"{1} src=\"data:image/png;base64,{2}\"></div>"
        "<figcaption>{0}</figcaption></figure>\n",
        xml_escaped(caption), width_of(bytes) > usual_width ? " class=\"broad\"" : "", base64(bytes));
}

std::string link_to(std::string_view id) {
    std::string text = "#";
    for (const char c : id)
        if (std::isalnum(static_cast<unsigned char>(c)) ||
            std::string_view("-._~/").find(c) != std::string_view::npos)
            text += c;
        else
            text += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    return text;
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
