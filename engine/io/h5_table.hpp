#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"

// Tables of structs, one growing dataset a member. The columns of a struct are stated once, in a
//   template <class Visit> void columns(std::type_identity<Row>, Visit&& visit)
// that calls visit(name, unit, &Row::member) for each, with further member pointers for a member's member.
// Members: numbers that h5::write takes, enumerations (stored as uint8, their names in the attribute
// "values"), std::array of numbers, and Mat2 (row by row).
namespace sandgraph::io::h5 {

// How a member lies in its dataset.
template <class T>
struct Cells {  // a number
    using Stored = T;
    static constexpr std::size_t count = 1;
    static void put(const T& value, Stored* cells) { cells[0] = value; }
    static void take(const Stored* cells, T& value) { value = cells[0]; }
};
template <class T>
requires std::is_enum_v<T>
struct Cells<T> {
    using Stored = std::uint8_t;
    static constexpr std::size_t count = 1;
    static void put(const T& value, Stored* cells) { cells[0] = static_cast<Stored>(value); }
    static void take(const Stored* cells, T& value) { value = static_cast<T>(cells[0]); }
};
template <class T, std::size_t N>
struct Cells<std::array<T, N>> {
    using Stored = T;
    static constexpr std::size_t count = N;
    static void put(const std::array<T, N>& value, Stored* cells) { std::copy_n(value.begin(), N, cells); }
    static void take(const Stored* cells, std::array<T, N>& value) { std::copy_n(cells, N, value.begin()); }
};
template <>
struct Cells<Mat2> {
    using Stored = double;
    static constexpr std::size_t count = 4;
    static void put(const Mat2& m, double* cells) {
        for (int k = 0; k < 4; ++k) cells[k] = m(k / 2, k % 2);
    }
    static void take(const double* cells, Mat2& m) {
        for (int k = 0; k < 4; ++k) m(k / 2, k % 2) = cells[k];
    }
};

template <class Row, class First, class... Rest>
auto& member_of(Row& row, First first, Rest... rest) {
    if constexpr (sizeof...(rest) == 0)
        return row.*first;
    else
        return member_of(row.*first, rest...);
}

// Of an enumeration, parted by blanks.
inline std::string joined(std::span<const char* const> names) {
    return fmt::format("{}", fmt::join(names, " "));
}

template <class T>
void write_value_names(Group& group, const char* name) {
    if constexpr (std::is_enum_v<T>) {
        set_attribute(group, name, "values", joined(names(T{})));
    }
}

// Another list of names means other meanings of the numbers (a shorter one is an older file's: names are only
// added at the end); a number without a name has none.
template <class T>
void check_values(const Group& group, const char* name, const std::vector<typename Cells<T>::Stored>& cells) {
    if constexpr (std::is_enum_v<T>) {
        const std::string text = joined(names(T{}));
        if (!(text + " ").starts_with(get_text(group, name, "values") + " "))
            refuse(group, fmt::format("the values of {} differ", group.path_of(name)), "expected: " + text);
        for (const auto cell : cells)
            if (cell >= names(T{}).size())
                refuse(group, fmt::format("{} holds {}", group.path_of(name), cell), "expected: " + text);
    } else if constexpr (std::is_floating_point_v<typename Cells<T>::Stored>) {
        for (std::size_t k = 0; k < cells.size(); ++k)
            if (!std::isfinite(cells[k]))
                refuse(group, fmt::format("{} holds {}", group.path_of(name), cells[k]),
                       fmt::format("row {} is not a finite number", k / Cells<T>::count));
    }
}

template <class Row>
void create_table(Group& group) {
    columns(std::type_identity<Row>{}, [&](const char* name, const char* unit, auto... path) {
        Row row{};
        using T = std::remove_cvref_t<decltype(member_of(row, path...))>;
        using Stored = typename Cells<T>::Stored;
        Shape shape{0};
        if (Cells<T>::count > 1) shape.push_back(Cells<T>::count);
        write(group, name, std::span<const Stored>(), shape, unit, Storage::growing);
        write_value_names<T>(group, name);
    });
}

template <class Row>
void append_table(Group& group, std::span<const Row> rows) {
    columns(std::type_identity<Row>{}, [&](const char* name, const char*, auto... path) {
        using T = std::remove_cvref_t<decltype(member_of(rows[0], path...))>;
        std::vector<typename Cells<T>::Stored> cells(rows.size() * Cells<T>::count);
        for (std::size_t k = 0; k < rows.size(); ++k)
            Cells<T>::put(member_of(rows[k], path...), &cells[k * Cells<T>::count]);
        append(group, name, std::span<const typename Cells<T>::Stored>(cells));
    });
}

// InputError on missing columns, columns of other shape or type or of different length, numbers that are not
// finite, enumerations whose names are not those of this version.
template <class Row>
std::vector<Row> read_table(const Group& group) {
    std::vector<Row> rows;
    bool first = true;
    columns(std::type_identity<Row>{}, [&](const char* name, const char*, auto... path) {
        using T = std::remove_cvref_t<decltype(member_of(rows[0], path...))>;
        constexpr std::size_t count = Cells<T>::count;
        const auto cells = read<typename Cells<T>::Stored>(group, name);
        const Shape extent = shape(group, name);
        const bool right_rank = extent.size() == (count > 1 ? 2 : 1);
        if (first && right_rank) rows.resize(extent[0]);
        first = false;
        if (!right_rank || cells.size() != count * rows.size())
            refuse(group, fmt::format("{} differs in shape", group.path_of(name)),
                   fmt::format("{} rows of {} expected", rows.size(), count));
        check_values<T>(group, name, cells);
        for (std::size_t k = 0; k < rows.size(); ++k)
            Cells<T>::take(&cells[k * count], member_of(rows[k], path...));
    });
    return rows;
}

}  // namespace sandgraph::io::h5
