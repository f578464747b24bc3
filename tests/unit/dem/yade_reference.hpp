#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/csv.hpp"
#include "dem/packing/packing.hpp"
#include "support/paths.hpp"

namespace sandgraph::dem::test {

inline std::string yade_file(const std::string& name) { return sandgraph::test::test_data("/yade/") + name; }

// A reference CSV: '#' lines skipped, a header, rows of numbers (words become 0).
struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<double>> rows;

    std::size_t column(const std::string& name) const {
        for (std::size_t k = 0; k < columns.size(); ++k)
            if (columns[k] == name) return k;
        ADD_FAILURE() << "no column " << name;
        return 0;
    }
    double at(std::size_t row, const std::string& name) const { return rows[row][column(name)]; }
    Mat2 tensor(std::size_t row, const std::string& s) const {
        return (Mat2() << at(row, s + "xx"), at(row, s + "xy"), at(row, s + "yx"), at(row, s + "yy"))
            .finished();
    }
};

inline double number_or_zero(const std::string& text) {
    try {
        return std::stod(text);
    } catch (const std::invalid_argument&) {
        return 0;
    }
}

inline Table read_csv(const std::string& path) {
    CsvReader in(path);
    Table table;
    if (in.next_row())
        for (const std::string_view name : in.cells()) table.columns.emplace_back(name);
    while (in.next_row()) {
        table.rows.emplace_back();
        for (const std::string_view cell : in.cells())
            table.rows.back().push_back(number_or_zero(std::string(cell)));
    }
    return table;
}
inline Table read_table(const std::string& name) { return read_csv(yade_file(name)); }

}  // namespace sandgraph::dem::test
