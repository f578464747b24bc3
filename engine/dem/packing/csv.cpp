#include "dem/packing/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <string_view>

#include "base/error.hpp"
#include "dem/packing/check.hpp"

namespace sandgraph::dem {
namespace {

constexpr std::string_view header = "id,x,y,r";

struct Grain {
    std::int64_t id;
    double x, y, r;
    int line;
};

// Lines of the file with their numbers, ends trimmed.
class Lines {
  public:
    explicit Lines(const std::filesystem::path& file) : name_(file.string()), stream_(file) {
        if (!stream_)
            throw InputError({name_, 0}, "cannot be opened", "no such file or no permission",
                             "check the path");
    }
    bool next() {
        if (!std::getline(stream_, text_)) return false;
        ++number_;
        text_.erase(text_.find_last_not_of(" \t\r") + 1);
        return true;
    }
    const std::string& text() const { return text_; }
    InputError::Where where() const { return {name_, number_}; }
    int number() const { return number_; }

  private:
    std::string name_;
    std::ifstream stream_;
    std::string text_;
    int number_ = 0;
};

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> words;
    for (std::size_t from = 0;;) {
        const std::size_t to = text.find(separator, from);
        if (const auto word = text.substr(from, to - from); separator == ',' || !word.empty())
            words.push_back(word);
        if (to == std::string_view::npos) return words;
        from = to + 1;
    }
}

template <class Number>
Number parse(std::string_view word, const InputError::Where& where) {
    const std::size_t blank = std::min(word.find_first_not_of(" \t"), word.size());
    word.remove_prefix(blank);
    while (!word.empty() && word.back() == ' ') word.remove_suffix(1);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
        throw InputError(where, fmt::format("'{}' is not a number", word), "a plain number is needed here",
                         "write e.g. 0.005");
    return value;
}

void expect_comment(Lines& lines, const char* what) {
    if (!lines.next() || !lines.text().starts_with("#"))
        throw InputError(lines.where(), fmt::format("{} is missing", what),
                         "a packing starts with three '#' lines",
                         "begin with '# {json}', '# cell ...', '# hxx hxy hyx hyy'");
}

Mat2 read_cell(Lines& lines) {
    expect_comment(lines, "the '# hxx hxy hyx hyy' line");
    const auto words = split(std::string_view(lines.text()).substr(1), ' ');
    if (words.size() != 4)
        throw InputError(lines.where(), fmt::format("{} numbers for the cell", words.size()),
                         "hxx hxy hyx hyy are four", "write '# hxx hxy hyx hyy' in m");
    Mat2 H;
    for (int k = 0; k < 4; ++k)
        H(k / 2, k % 2) = parse<double>(words[static_cast<std::size_t>(k)], lines.where());
    return H;
}

Grain read_grain(const Lines& lines) {
    const auto words = split(lines.text(), ',');
    if (words.size() != 4)
        throw InputError(lines.where(), fmt::format("{} columns", words.size()), "a grain has four",
                         "write id,x,y,r");
    const auto where = lines.where();
    return {parse<std::int64_t>(words[0], where), parse<double>(words[1], where),
            parse<double>(words[2], where), parse<double>(words[3], where), lines.number()};
}

std::vector<Grain> read_grains(Lines& lines) {
    if (!lines.next() || lines.text() != header)
        throw InputError(lines.where(), "the column line is missing", "the fourth line names the columns",
                         "write 'id,x,y,r'");
    std::vector<Grain> grains;
    std::map<std::int64_t, int> first;
    while (lines.next()) {
        if (lines.text().empty()) continue;
        grains.push_back(read_grain(lines));
        const auto [seen, is_new] = first.emplace(grains.back().id, lines.number());
        if (!is_new)
            throw InputError(lines.where(), fmt::format("duplicate id {}", grains.back().id),
                             fmt::format("first used in line {}", seen->second),
                             "number the grains 0, 1, 2, ...");
    }
    std::ranges::sort(grains, {}, &Grain::id);
    return grains;
}

}  // namespace

Packing read_packing_csv(const std::filesystem::path& file) {
    Lines lines(file);
    expect_comment(lines, "the '# {json}' line");
    expect_comment(lines, "the '# cell' line");
    Packing p;
    p.H = read_cell(lines);
    const int cell_line = lines.number();
    std::vector<int> at;
    for (const Grain& g : read_grains(lines)) {
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
        metadata, p.H(0, 0), p.H(0, 1), p.H(1, 0), p.H(1, 1), header);
    for (std::size_t g = 0; g < p.size(); ++g)
        text += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", g, p.x[g], p.y[g], p.r[g]);
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace sandgraph::dem
