#include "scene/region_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "base/units.hpp"
#include "scene/key_table.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

struct Place {
    std::array<double, 2> value{0, 0};
    bool absolute = false;
};

// Two numbers in plate widths, or two lengths as text.
class PlaceValue : public Value {
  public:
    explicit PlaceValue(Place& place) : place_(place) {}
    void read(const Entry& entry) override {
        const toml::array* pair = entry.node.as_array();
        if (!pair || pair->size() != 2) refuse(entry);
        for (std::size_t k = 0; k < 2; ++k) read_item(entry, (*pair)[k], k);
    }
    std::string shown() const override { return ""; }
    std::string canonical() const override { return ""; }

  private:
    [[noreturn]] static void refuse(const Entry& entry) {
        entry.refuse("neither two numbers nor two lengths",
                     "write [-0.5, 0.5] (plate widths from the plate's centre) or [\"2 m\", \"3 m\"]");
    }
    void read_item(const Entry& entry, const toml::node& item, std::size_t k) {
        const auto text = item.value_exact<std::string>();
        if (!text && !item.is_number()) refuse(entry);
        if (k > 0 && text.has_value() != place_.absolute) refuse(entry);
        place_.absolute = text.has_value();
        place_.value[k] = text ? parse_quantity(entry.where, entry.name, *text, "m") : *item.value<double>();
        if (!std::isfinite(place_.value[k])) refuse(entry);
    }
    Place& place_;
};

bool names_a_file(const std::string& name) {
    const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
    return !name.empty() && name.size() <= 40 && std::ranges::all_of(name, allowed);
}

// Reads one [[region]]; the places decide what it is.
class RegionReader {
  public:
    RegionReader(const toml::table& table, const std::string& file)
        : where_{file, file == override_file ? 0 : static_cast<int>(table.source().begin.line)} {
        auto top = keys_.section("");
        top.text("name", region_.name, "");
        top.add("x", std::make_unique<PlaceValue>(x_), "");
        top.add("y", std::make_unique<PlaceValue>(y_), "");
        top.add("at", std::make_unique<PlaceValue>(at_), "");
        top.add("packings", std::make_unique<RisingReals>(region_.packings, at_least(0)), "");
        keys_.read(table, file);
    }
    Region region() {
        if (!names_a_file(region_.name))
            refuse(fmt::format("name = \"{}\"", region_.name), "it names files and columns",
                   "write up to 40 letters, digits, _ or -");
        region_.where = where_;
        keys_.at("at").given ? place_point() : place_rectangle();
        return region_;
    }

  private:
    [[noreturn]] void refuse(const std::string& what, const std::string& why,
                             const std::string& advice) const {
        throw InputError(where_, "[[region]] " + what, why, advice);
    }
    void place_point() {
        if (keys_.at("x").given || keys_.at("y").given)
            refuse("with at beside x or y", "a tracked point has no extent",
                   "leave out the one or the other");
        region_.tracked_point = true, region_.absolute = at_.absolute;
        region_.x.fill(at_.value[0]), region_.y.fill(at_.value[1]);
    }
    void place_rectangle() {
        if (!keys_.at("x").given || !keys_.at("y").given)
            refuse("without a place", "x and y, or at, say where it is",
                   "write x = [-0.5, 0.5] and y = [0, 1]");
        if (x_.absolute != y_.absolute)
            refuse("with one side in metres", "the other is in plate widths", "write both alike");
        if (!(x_.value[0] < x_.value[1]) || !(y_.value[0] < y_.value[1]))
            refuse("without extent", "its low side is not below its high side",
                   "write the lower number first");
        region_.absolute = x_.absolute, region_.x = x_.value, region_.y = y_.value;
    }

    InputError::Where where_;
    Region region_;
    Place x_, y_, at_;
    KeyTable keys_;
};

}  // namespace

void RegionTables::read(const Entry& entry) {
    const toml::array* tables = entry.node.as_array();
    if (!tables || (!tables->empty() && !tables->is_homogeneous(toml::node_type::table)))
        entry.refuse("not a list of tables", "write [[region]] once for every region");
    regions_.clear();
    for (const toml::node& table : *tables) {
        Region region = RegionReader(*table.as_table(), entry.where.file).region();
        if (std::ranges::find(regions_, region.name, &Region::name) != regions_.end())
            entry.refuse(fmt::format("two regions called \"{}\"", region.name),
                         "give each a name of its own");
        regions_.push_back(std::move(region));
    }
}

std::string RegionTables::allowed() const { return "[[region]] tables: name, x and y or at, packings"; }

}  // namespace sandgraph::scene
