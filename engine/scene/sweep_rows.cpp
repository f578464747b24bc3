#include "scene/sweep_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "base/csv.hpp"
#include "scene/scene_keys.hpp"
#include "scene/sweep_keys.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

constexpr std::size_t most_rows = 100'000;
constexpr std::size_t longest_name = 120;
constexpr const char* name_column = "name";

bool is_key(const KeyTable& keys, const std::string& name) {
    return std::ranges::any_of(keys.keys(), [&](const Key& key) { return key.full_name() == name; });
}

// Refuses what is no key of a scene, with the advice that scenes give.
void require_key(const std::string& key, const InputError::Where& where) {
    Scene scene;
    KeyTable keys = scene_keys(scene);
    if (key == "output.folder")
        throw InputError(where, "output.folder in a sweep", "it gives every run a folder of its own",
                         "leave it out");
    if (!is_key(keys, key)) {
        keys.read(parse_value(key, "0", where), where.file);
        throw InputError(where, "unknown key " + key, "it is a table", "write a key of it: section.key");
    }
}

// The value as the scene takes it: checked, and of a file with its folder.
SweepValue checked(const std::string& key, const SweepValue& value, const InputError::Where& where) {
    Scene scene;
    KeyTable keys = scene_keys(scene);
    keys.read(parse_value(key, value.toml, where), where.file);
    const Value& read = *keys.at(key).value;
    return read.names_file() ? SweepValue{read.shown(), value.text} : value;
}

// A key has one value in a row.
class KeysOnce {
  public:
    void take(const std::string& key, const InputError::Where& where) {
        require_key(key, where);
        const auto [first, fresh] = seen_.emplace(key, where);
        if (!fresh)
            throw InputError(where, key + " twice",
                             first->second.line > 0 ? fmt::format("line {} says it, too", first->second.line)
                                                    : "the table says it before",
                             "leave one of them out");
    }

  private:
    std::map<std::string, InputError::Where> seen_;
};

// Letters, digits and what stands in numbers: "7m", "0.5", "-1e-3".
std::string for_folder(const std::string& text) {
    std::string out;
    for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '+') out += c;
    return out;
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

// "width" where no other key ends so, else "anchor.width".
std::string short_name(const std::vector<std::string>& keys, const std::string& key) {
    const auto alike = [&](const std::string& other) { return last_part(other) == last_part(key); };
    return std::ranges::count_if(keys, alike) > 1 ? key : last_part(key);
}

std::string name_of(const SweepTable& table, const SweepRow& row) {
    std::string name;
    for (const std::size_t k : table.axes)
        name += fmt::format("{}{}={}", name.empty() ? "" : "_", short_name(table.keys, table.keys[k]),
                            for_folder(row.values[k].text));
    return name.empty() ? "all" : name;
}

SweepRow row_of(const std::vector<SweepAxis>& axes, const std::vector<std::size_t>& step) {
    SweepRow row;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        const auto& values = axes[a].steps[step[a]];
        row.values.insert(row.values.end(), values.begin(), values.end());
    }
    row.where = axes.empty() ? InputError::Where{} : axes.front().where;
    return row;
}

void require_few(double rows, const SweepSpec& spec) {
    if (rows * spec.samples > most_rows)
        throw InputError({spec.file, 0}, fmt::format("{:.0f} runs", rows * spec.samples),
                         fmt::format("a sweep has {} at most", most_rows), "part it into several tables");
}

// Like the digits of a counter: the last axis runs fastest.
bool advance(const std::vector<SweepAxis>& axes, std::vector<std::size_t>& step) {
    for (std::size_t a = axes.size(); a-- > 0;) {
        if (++step[a] < axes[a].steps.size()) return true;
        step[a] = 0;
    }
    return false;
}

void add_product(SweepTable& table) {
    const auto& axes = table.spec.axes;
    double rows = 1;
    for (const SweepAxis& axis : axes) rows *= static_cast<double>(axis.steps.size());
    require_few(rows, table.spec);
    std::vector<std::size_t> step(axes.size(), 0);
    do table.rows.push_back(row_of(axes, step));
    while (advance(axes, step));
}

void add_zipped(SweepTable& table) {
    const auto& axes = table.spec.axes;
    const std::size_t length = axes.empty() ? 1 : axes.front().steps.size();
    for (const SweepAxis& axis : axes)
        if (axis.steps.size() != length)
            throw InputError(axis.where,
                             fmt::format("{} with {} values", axis.keys.front(), axis.steps.size()),
                             fmt::format("{} has {}, and combine = \"zip\" takes them in step",
                                         axes.front().keys.front(), length),
                             "write as many, or combine = \"product\"");
    require_few(static_cast<double>(length), table.spec);
    for (std::size_t k = 0; k < length; ++k)
        table.rows.push_back(row_of(axes, std::vector<std::size_t>(axes.size(), k)));
}

// Each value once, though a product has it in many rows.
void check_axes(SweepSpec& spec) {
    for (SweepAxis& axis : spec.axes)
        for (std::vector<SweepValue>& step : axis.steps)
            for (std::size_t k = 0; k < step.size(); ++k)
                step[k] = checked(axis.keys[k], step[k], axis.where);
}

void add_axes(SweepTable& table, KeysOnce& once) {
    for (const SweepAxis& axis : table.spec.axes) {
        table.axes.push_back(table.keys.size());
        for (const std::string& key : axis.keys) once.take(key, axis.where), table.keys.push_back(key);
    }
    check_axes(table.spec);
    table.spec.combine == Combine::zip ? add_zipped(table) : add_product(table);
    for (SweepRow& row : table.rows) row.name = name_of(table, row);
}

struct Head {
    std::vector<std::string> columns;
};

Head read_head(CsvReader& in, SweepTable& table, KeysOnce& once) {
    Head head;
    if (!in.next_row())
        throw InputError({table.spec.rows, 0}, "no rows", "the file is empty",
                         "write a head and a line a row");
    for (const std::string_view cell : in.cells()) {
        head.columns.emplace_back(cell);
        if (cell == name_column) continue;
        once.take(head.columns.back(), in.where());
        table.axes.push_back(table.keys.size());
        table.keys.emplace_back(cell);
    }
    return head;
}

std::string name_in(const CsvReader& in, std::string_view cell) {
    const std::string name(cell);
    const auto allowed = [](unsigned char c) {
        return std::isalnum(c) ||
               std::string_view("._=+-").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (name.empty() || name.front() == '.' || !std::ranges::all_of(name, allowed))
        in.refuse(fmt::format("name \"{}\"", name), "it names a folder",
                  "write letters, digits, _ = + - or a point inside");
    return name;
}

SweepRow read_row(const CsvReader& in, const Head& head) {
    const auto cells = in.cells();
    if (cells.size() != head.columns.size())
        in.refuse(fmt::format("{} cells", cells.size()), fmt::format("the head has {}", head.columns.size()),
                  "write one for each column");
    SweepRow row;
    row.where = in.where();
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const std::string text(cells[k]), &column = head.columns[k];
        if (column == name_column)
            row.name = name_in(in, text);
        else
            row.values.push_back(checked(column, {text, text}, row.where));
    }
    return row;
}

void add_csv(SweepTable& table, KeysOnce& once) {
    CsvReader in(table.spec.rows);
    const Head head = read_head(in, table, once);
    while (in.next_row()) {
        table.rows.push_back(read_row(in, head));
        if (table.rows.back().name.empty()) table.rows.back().name = name_of(table, table.rows.back());
        require_few(static_cast<double>(table.rows.size()), table.spec);
    }
    if (table.rows.empty())
        throw InputError({table.spec.rows, 0}, "no rows", "there is a head only", "write a line a row");
}

void require_folders(const SweepTable& table) {
    std::map<std::string, std::size_t> seen;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const SweepRow& row = table.rows[k];
        if (row.name.size() > longest_name)
            throw InputError(row.where,
                             fmt::format("row {} with a name of {} letters", k + 1, row.name.size()),
                             fmt::format("it is a folder's, {} at most", longest_name),
                             "give the rows names: rows = \"FILE.csv\" with a column name");
        const auto [first, fresh] = seen.emplace(row.name, k);
        if (!fresh)
            throw InputError(row.where, fmt::format("rows {} and {}", first->second + 1, k + 1),
                             fmt::format("both would have the folder {}", row.name),
                             "leave out what is there twice");
    }
}

void check_settings(SweepSpec& spec, KeysOnce& once) {
    if (spec.mode != SweepMode::scene) once.take("mode", spec.where("mode"));
    for (SweepSetting& one : spec.set) {
        once.take(one.key, one.where);
        one.value = checked(one.key, one.value, one.where);
    }
}

}  // namespace

std::vector<std::string> SweepTable::overrides(const SweepRow& row) const {
    std::vector<std::string> out;
    for (const SweepSetting& one : spec.set) out.push_back(one.key + "=" + one.value.toml);
    for (std::size_t k = 0; k < keys.size(); ++k) out.push_back(keys[k] + "=" + row.values[k].toml);
    return out;
}

SweepTable read_sweep_table(const std::string& file) {
    SweepTable table;
    table.spec = read_sweep(file);
    KeysOnce once;
    check_settings(table.spec, once);
    table.spec.rows.empty() ? add_axes(table, once) : add_csv(table, once);
    require_folders(table);
    return table;
}

}  // namespace sandgraph::scene
