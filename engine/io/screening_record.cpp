#include "io/screening_record.hpp"

#include <fmt/format.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "base/contracts.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"

namespace sandgraph::io {
namespace {

using stress::AuditRow, stress::Switch;

// Enumerators are stored as their codes.
template <class T>
struct Stored {
    using type = T;
};
template <>
struct Stored<stress::Reason> {
    using type = std::uint8_t;
};

// What never happened is NaN in memory and -1, which no share can be, in the file.
constexpr double nothing = -1;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double stored(double value) { return std::isnan(value) ? nothing : value; }
double recalled(double value) { return value == nothing ? unknown : value; }

template <class T, class Row>
void write_column(h5::Group& group, const char* name, const std::vector<Row>& rows, T Row::*member,
                  const char* unit) {
    using Value = typename Stored<T>::type;
    std::vector<Value> column;
    for (const Row& row : rows) column.push_back(static_cast<Value>(row.*member));
    h5::write(group, name, std::span<const Value>(column), {column.size()}, unit, h5::Storage::growing);
}

template <class T, class Row>
void read_column(const h5::Group& group, const char* name, std::vector<Row>& rows, T Row::*member) {
    const auto column = h5::read<typename Stored<T>::type>(group, name);
    if (rows.empty()) rows.resize(column.size());
    if (column.size() != rows.size())
        h5::refuse(group, group.path_of(name) + " differs in length", "all columns must agree");
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].*member = static_cast<T>(column[k]);
}

// One list of columns serves both directions.
template <class Visit>
void visit_switches(Visit&& visit) {
    visit("step", &Switch::step, ""), visit("d_over_B", &Switch::d_over_B, "-");
    visit("point", &Switch::point, ""), visit("reason", &Switch::reason, "");
    visit("jump", &Switch::jump, "share of p"), visit("felt", &Switch::felt, "share of p");
    visit("ordinary", &Switch::ordinary, "share of p");
}

template <class Visit>
void visit_audits(Visit&& visit) {
    visit("d_over_B", &AuditRow::d_over_B, "-"), visit("points", &AuditRow::points, "");
    visit("population", &AuditRow::population, "");
    visit("stress_error_mean", &AuditRow::mean, "share of p");
    visit("ci95", &AuditRow::ci95, "share of p");
}

}  // namespace

void write_screening(h5::Group& root, const ScreeningRecord& record) {
    if (record.empty()) return;
    SG_EXPECT(std::ranges::all_of(record.switches, [&](const Switch& s) {
        return static_cast<std::size_t>(s.reason) < record.reasons.size();
    }));
    h5::Group switches = root.create("switches"), audit = root.create("audit");
    h5::set_attribute(switches, ".", "reasons", fmt::format("{}", fmt::join(record.reasons, "\n")));
    std::vector<Switch> rows = record.switches;
    for (Switch& row : rows) row.felt = stored(row.felt), row.ordinary = stored(row.ordinary);
    visit_switches([&](const char* name, auto member, const char* unit) {
        write_column(switches, name, rows, member, unit);
    });
    visit_audits([&](const char* name, auto member, const char* unit) {
        write_column(audit, name, record.audits, member, unit);
    });
}

ScreeningRecord read_screening(const h5::Group& root) {
    ScreeningRecord record;
    if (!root.has("switches")) return record;
    const h5::Group switches = root.open("switches"), audit = root.open("audit");
    std::istringstream reasons(h5::get_text(switches, ".", "reasons"));
    for (std::string line; std::getline(reasons, line);) record.reasons.push_back(line);
    visit_switches([&](const char* name, auto member, const char*) {
        if (switches.has(name)) read_column(switches, name, record.switches, member);
    });
    for (Switch& row : record.switches) row.felt = recalled(row.felt), row.ordinary = recalled(row.ordinary);
    visit_audits(
        [&](const char* name, auto member, const char*) { read_column(audit, name, record.audits, member); });
    return record;
}

}  // namespace sandgraph::io
