#include "scene/segments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/csv.hpp"
#include "scene/key_table.hpp"

namespace sandgraph::scene {
namespace {

constexpr const char* csv_header = "Lxx,Lxy,Lyx,Lyy,steps";

// velocity_gradient = [[xx, xy], [yx, yy]], row by row.
class Matrix : public Value {
  public:
    explicit Matrix(Mat2& matrix) : matrix_(matrix) {}
    void read(const Entry& entry) override {
        const toml::array* rows = entry.node.as_array();
        if (!rows || rows->size() != 2) refuse(entry);
        for (int i = 0; i < 2; ++i) read_row(entry, rows->get_as<toml::array>(i), i);
    }
    std::string shown() const override { return ""; }
    std::string canonical() const override { return ""; }

  private:
    [[noreturn]] static void refuse(const Entry& entry) {
        entry.refuse("not a 2 x 2 matrix of finite numbers in 1/s", "write [[0.1, 0.0], [0.0, -0.1]]");
    }
    void read_row(const Entry& entry, const toml::array* row, int i) {
        if (!row || row->size() != 2) refuse(entry);
        for (int j = 0; j < 2; ++j) {
            const toml::node& item = (*row)[static_cast<std::size_t>(j)];
            const double value = item.is_number() ? *item.value<double>() : std::nan("");
            if (!std::isfinite(value)) refuse(entry);
            matrix_(i, j) = value;
        }
    }
    Mat2& matrix_;
};

dem::PathSegment read_segment(const toml::table& table, const std::string& file) {
    dem::PathSegment segment;
    KeyTable keys;
    auto top = keys.section("");
    top.add("velocity_gradient", std::make_unique<Matrix>(segment.velocity_gradient), "");
    top.integer("steps", segment.steps, 1, "");
    keys.read(table, file);
    for (const Key& key : keys.keys())
        if (!key.given)
            throw InputError({file, static_cast<int>(table.source().begin.line)},
                             fmt::format("[[segment]] without {}", key.name), "both keys are needed",
                             "write velocity_gradient = [[...], [...]] and steps");
    return segment;
}

dem::PathSegment read_row(const CsvReader& in) {
    const auto cells = in.cells();
    if (cells.size() != 5)
        in.refuse(fmt::format("\"{}\"", in.text()), "not five finite numbers",
                  fmt::format("write {}", csv_header));
    double values[5];
    for (std::size_t k = 0; k < 5; ++k)
        if (values[k] = in.number(cells[k]); !std::isfinite(values[k]))
            in.refuse(fmt::format("'{}' is not a finite number", cells[k]), "not five finite numbers",
                      fmt::format("write {}", csv_header));
    if (values[4] < 1 || values[4] != std::floor(values[4]) || values[4] > 1e15)
        in.refuse(fmt::format("steps = {:.12g}", values[4]), "not a whole number of steps",
                  "write 1 or more");
    dem::PathSegment segment;
    segment.velocity_gradient << values[0], values[1], values[2], values[3];
    segment.steps = static_cast<std::int64_t>(values[4]);
    return segment;
}

std::vector<dem::PathSegment> read_segments(const std::string& file) {
    CsvReader in(file);
    std::vector<dem::PathSegment> segments;
    if (in.next_row() && fmt::format("{}", fmt::join(in.cells(), ",")) != csv_header)
        in.refuse(fmt::format("\"{}\"", in.text()), "not the header of a segments file",
                  fmt::format("write {}", csv_header));
    while (in.next_row()) segments.push_back(read_row(in));
    if (segments.empty()) throw InputError({file, 0}, "no segments", "a path needs one at least", csv_header);
    return segments;
}

}  // namespace

void SegmentTables::read(const Entry& entry) {
    const toml::array* tables = entry.node.as_array();
    if (!tables || tables->empty() || !tables->is_homogeneous(toml::node_type::table))
        entry.refuse("not a list of tables", "write [[segment]] once for every segment");
    segments_.clear();
    for (const toml::node& table : *tables)
        segments_.push_back(read_segment(*table.as_table(), entry.where.file));
}

std::string SegmentTables::canonical() const {
    std::string text;
    for (const dem::PathSegment& s : segments_)
        text += fmt::format("{:.14g},{:.14g},{:.14g},{:.14g},{};", s.velocity_gradient(0, 0),
                            s.velocity_gradient(0, 1), s.velocity_gradient(1, 0), s.velocity_gradient(1, 1),
                            s.steps);
    return text;
}

void SegmentFile::read(const Entry& entry) {
    std::string file;
    InputFile(file).read(entry);
    segments_ = read_segments(file);
}

}  // namespace sandgraph::scene
