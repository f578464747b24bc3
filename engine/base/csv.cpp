#include "base/csv.hpp"

#include <fmt/format.h>

#include <charconv>

#include "base/text.hpp"

namespace sandgraph {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// 7, " 7" and "7" in quotes, as spreadsheets write texts.
std::string_view bare(std::string_view cell) {
    cell = trimmed(cell);
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    return trimmed(cell);
}

// from_chars knows no plus sign.
template <class Number>
bool parse(std::string_view cell, Number& value) {
    if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);
    const auto [end, status] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return status == std::errc{} && end == cell.data() + cell.size();
}

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& file) : name_(file.string()), stream_(file) {
    if (std::filesystem::is_directory(file))
        throw InputError({name_, 0}, "cannot be read", "it is a folder", "give the name of a file");
    if (!stream_)
        throw InputError({name_, 0}, "cannot be opened", "no such file or no permission", "check the path");
}

bool CsvReader::next() {
    while (std::getline(stream_, text_)) {
        if (++line_ == 1 && text_.starts_with(byte_order_mark)) text_.erase(0, byte_order_mark.size());
        text_ = std::string(trimmed(text_));
        if (!text_.empty()) return true;
    }
    return false;
}

bool CsvReader::next_row() {
    while (next())
        if (!comment()) return true;
    return false;
}

std::vector<std::string_view> CsvReader::cells() const {
    std::vector<std::string_view> cells;
    const std::string_view all = text_;
    for (std::size_t from = 0;;) {
        const std::size_t to = all.find(',', from);
        cells.push_back(bare(all.substr(from, to - from)));
        if (to == std::string_view::npos) return cells;
        from = to + 1;
    }
}

void CsvReader::refuse(const std::string& problem, const std::string& why,
                       const std::string& suggestion) const {
    throw InputError(where(), problem, why, suggestion);
}

double CsvReader::number(std::string_view cell) const {
    double value = 0;
    if (!parse(cell, value))
        refuse(fmt::format("'{}' is not a number", cell), "a plain number is needed here",
               "write e.g. 0.005");
    return value;
}

std::int64_t CsvReader::integer(std::string_view cell) const {
    std::int64_t value = 0;
    if (!parse(cell, value))
        refuse(fmt::format("'{}' is not a number", cell), "a whole number is needed here", "write e.g. 7");
    return value;
}

}  // namespace sandgraph
