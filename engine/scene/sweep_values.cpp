#include "scene/sweep_values.hpp"

#include <fmt/format.h>

#include <functional>

namespace sandgraph::scene {
namespace {

// Of the keys that go along: a list each.
struct Companion {
    std::string key;
    std::vector<SweepValue> values;
    InputError::Where where;
};

InputError::Where where_of(const toml::node& node, const std::string& file) {
    return {file, static_cast<int>(node.source().begin.line)};
}

// In single quotes nothing is special to TOML.
SweepValue value_of(const Entry& entry) {
    if (entry.node.is_table()) entry.refuse("not a value", "write a number, a text or a list");
    const auto text = entry.node.value_exact<std::string>();
    if (!text) return {entry.text(), entry.text()};
    if (text->find_first_of("'\n") != std::string::npos)
        entry.refuse("a quote in it", "write the text without quotes of its own");
    return {"'" + *text + "'", *text};
}

std::vector<SweepValue> list_of(const Entry& entry) {
    const toml::array* list = entry.node.as_array();
    if (!list) entry.refuse("not a list", "write the values in brackets, as [2, 3, 5]");
    if (list->empty()) entry.refuse("an axis without values", "write one value at least, as [2, 3, 5]");
    std::vector<SweepValue> values;
    for (const toml::node& item : *list) values.push_back(value_of({item, entry.where, entry.name}));
    return values;
}

// "anchor.width" of [anchor] width as of "anchor.width".
void each_key(const toml::table& table, const std::string& prefix, const std::string& file,
              const std::function<void(const Entry&)>& visit) {
    for (const auto& [key, node] : table) {
        const std::string name = prefix + std::string(key.str());
        if (node.is_table())
            each_key(*node.as_table(), name + ".", file, visit);
        else
            visit({node, where_of(node, file), name});
    }
}

class ListValue : public Value {
  public:
    explicit ListValue(std::vector<SweepValue>& values) : values_(values) {}
    void read(const Entry& entry) override { values_ = list_of(entry); }
    std::string shown() const override { return ""; }
    std::string canonical() const override { return ""; }

  private:
    std::vector<SweepValue>& values_;
};

class CompanionTable : public Value {
  public:
    explicit CompanionTable(std::vector<Companion>& companions) : companions_(companions) {}
    void read(const Entry& entry) override {
        if (!entry.node.is_table())
            entry.refuse("not a table", "write with = { \"domain.depth\" = [\"7 m\", \"8 m\"] }");
        each_key(*entry.node.as_table(), "", entry.where.file, [this](const Entry& one) {
            companions_.push_back({one.name, list_of(one), one.where});
        });
    }
    std::string shown() const override { return ""; }
    std::string canonical() const override { return ""; }

  private:
    std::vector<Companion>& companions_;
};

void append(SweepAxis& axis, const std::string& key, const std::vector<SweepValue>& values) {
    axis.keys.push_back(key);
    for (std::size_t k = 0; k < values.size(); ++k) axis.steps[k].push_back(values[k]);
}

SweepAxis read_axis(const toml::table& table, const std::string& file) {
    std::string key;
    std::vector<SweepValue> values;
    std::vector<Companion> companions;
    KeyTable keys;
    auto top = keys.section("");
    top.text("key", key, "");
    top.add("values", std::make_unique<ListValue>(values), "");
    top.add("with", std::make_unique<CompanionTable>(companions), "");
    keys.read(table, file);
    const InputError::Where where = where_of(table, file);
    for (const char* needed : {"key", "values"})
        if (!keys.at(needed).given)
            throw InputError(where, fmt::format("[[axis]] without {}", needed), "both are needed",
                             "write key = \"anchor.embedment_ratio\" and values = [2, 3, 5]");
    SweepAxis axis{.keys = {}, .steps = std::vector<std::vector<SweepValue>>(values.size()), .where = where};
    append(axis, key, values);
    for (const Companion& c : companions) {
        if (c.values.size() != values.size())
            throw InputError(c.where, fmt::format("{} with {} values", c.key, c.values.size()),
                             fmt::format("{} has {}, and they go together", key, values.size()),
                             "write one for each");
        append(axis, c.key, c.values);
    }
    return axis;
}

}  // namespace

void SettingsTable::read(const Entry& entry) {
    if (!entry.node.is_table()) entry.refuse("not a table", "write [set] and below it grains.count = 200");
    settings_.clear();
    each_key(*entry.node.as_table(), "", entry.where.file, [this](const Entry& one) {
        settings_.push_back({one.name, value_of(one), one.where});
    });
}

void AxisTables::read(const Entry& entry) {
    const toml::array* tables = entry.node.as_array();
    if (!tables || (!tables->empty() && !tables->is_homogeneous(toml::node_type::table)))
        entry.refuse("not a list of tables", "write [[axis]] once for every axis");
    axes_.clear();
    for (const toml::node& table : *tables) axes_.push_back(read_axis(*table.as_table(), entry.where.file));
}

}  // namespace sandgraph::scene
