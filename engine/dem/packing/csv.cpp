#include "dem/packing/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>

#include "base/csv.hpp"
#include "dem/packing/packing.hpp"

namespace sandgraph::dem {
namespace {

constexpr std::array<std::string_view, 4> columns = {"id", "x", "y", "r"};

struct Grain {
    std::int64_t id;
    double x, y, r;
    int line;
};

void expect_comment(CsvReader& in, const char* what) {
    if (!in.next() || !in.comment())
        in.refuse(fmt::format("{} is missing", what), "a packing starts with three '#' lines",
                  "begin with '# {json}', '# cell ...', '# hxx hxy hyx hyy'");
}

// The words behind the '#', parted by blanks or by the commas that spreadsheets put there.
std::vector<std::string> words_of(const CsvReader& in) {
    std::string line = in.text().substr(1);
    std::ranges::replace(line, ',', ' ');
    std::istringstream text(line);
    return {std::istream_iterator<std::string>(text), {}};
}

Mat2 read_cell(CsvReader& in) {
    expect_comment(in, "the '# hxx hxy hyx hyy' line");
    const std::vector<std::string> words = words_of(in);
    if (words.size() != 4)
        in.refuse(fmt::format("{} numbers for the cell", words.size()), "hxx hxy hyx hyy are four",
                  "write '# hxx hxy hyx hyy' in m");
    Mat2 H;
    for (int k = 0; k < 4; ++k) H(k / 2, k % 2) = in.number(words[static_cast<std::size_t>(k)]);
    return H;
}

Grain read_grain(const CsvReader& in) {
    const auto cells = in.cells();
    if (cells.size() != 4)
        in.refuse(fmt::format("{} columns", cells.size()), "a grain has four", "write id,x,y,r");
    return {in.integer(cells[0]), in.number(cells[1]), in.number(cells[2]), in.number(cells[3]), in.line()};
}

std::vector<Grain> read_grains(CsvReader& in) {
    if (!in.next_row() || !std::ranges::equal(in.cells(), columns))
        in.refuse("the column line is missing", "the line behind the cell names the columns",
                  "write 'id,x,y,r'");
    std::vector<Grain> grains;
    std::map<std::int64_t, int> first;
    while (in.next_row()) {
        grains.push_back(read_grain(in));
        const auto [seen, is_new] = first.emplace(grains.back().id, in.line());
        if (!is_new)
            in.refuse(fmt::format("duplicate id {}", grains.back().id),
                      fmt::format("first used in line {}", seen->second), "number the grains 0, 1, 2, ...");
    }
    std::ranges::sort(grains, {}, &Grain::id);
    return grains;
}

}  // namespace

Packing read_packing_csv(const std::filesystem::path& file) {
    CsvReader in(file);
    expect_comment(in, "the '# {json}' line");
    expect_comment(in, "the '# cell' line");
    Packing p;
    p.H = read_cell(in);
    const int cell_line = in.line();
    std::vector<int> at;
    for (const Grain& g : read_grains(in)) {
        p.x.push_back(g.x), p.y.push_back(g.y), p.r.push_back(g.r);
        at.push_back(g.line);
    }
    check_packing(p, {file.string(), cell_line, at});
    return p;
}

void write_packing_csv(const std::filesystem::path& file, const Packing& p, const std::string& metadata) {
    std::string text = fmt::format(
        "# {}\n# cell hSize (columns = base vectors) [m]: hxx hxy hyx hyy\n"
        "# {:.17g} {:.17g} {:.17g} {:.17g}\n{}\n",
        metadata, p.H(0, 0), p.H(0, 1), p.H(1, 0), p.H(1, 1), "id,x,y,r");
    for (std::size_t g = 0; g < p.size(); ++g)
        text += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", g, p.x[g], p.y[g], p.r[g]);
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace sandgraph::dem
