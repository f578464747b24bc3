#include "scene/body_tables.hpp"

#include <fmt/format.h>

#include "base/units.hpp"
#include "scene/key_table.hpp"
#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

// Two quantities as text: along x and y.
class Pair : public Value {
  public:
    Pair(std::array<double, 2>& value, std::string unit) : value_(value), unit_(std::move(unit)) {}
    void read(const Entry& entry) override {
        const toml::array* pair = entry.node.as_array();
        if (!pair || pair->size() != 2) refuse(entry);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto text = (*pair)[k].value_exact<std::string>();
            if (!text) refuse(entry);
            value_[k] = parse_quantity(entry.where, entry.name, *text, unit_);
        }
    }
    std::string shown() const override { return ""; }
    std::string canonical() const override { return ""; }

  private:
    [[noreturn]] void refuse(const Entry& entry) const {
        entry.refuse("not two quantities as text, along x and y",
                     fmt::format("write [\"0 {}\", \"1 {}\"]", unit_, unit_));
    }
    std::array<double, 2>& value_;
    std::string unit_;
};

// Reads one [[body]].
class BodyReader {
  public:
    BodyReader(const toml::table& table, const std::string& file)
        : where_{file, file == override_file ? 0 : static_cast<int>(table.source().begin.line)} {
        auto top = keys_.section("");
        top.choice("shape", body_.shape, {"rectangle", "circle"}, "");
        top.add("centre", std::make_unique<Pair>(body_.centre, "m"), "");
        top.add("size", std::make_unique<Pair>(body_.size, "m"), "");
        top.real("radius", radius_, "m", above(0), "");
        top.real("angle", angle_, "deg", within(0, 2 * std::numbers::pi), "");
        top.real("friction_angle", body_.friction_angle, "deg", within(0, std::numbers::pi / 2), "");
        top.add("velocity", std::make_unique<Pair>(body_.velocity, "m/s"), "");
        top.real("travel", body_.travel, "m", above(0), "");
        top.real("ramp", body_.ramp, "", within(0, 0.9), "");
        keys_.read(table, file);
    }
    Body body() {
        body_.where = where_;
        need("centre", "nothing says where it is", "write centre = [\"0 m\", \"3 m\"]");
        if (keys_.at("angle").given && angle_ != 0)
            refuse("with an angle", "bodies stand along x and y so far", "leave the angle out");
        body_.shape == Shape::circle ? size_circle() : size_rectangle();
        drive();
        return body_;
    }

  private:
    [[noreturn]] void refuse(const std::string& what, const std::string& why,
                             const std::string& advice) const {
        throw InputError(where_, "[[body]] " + what, why, advice);
    }
    void need(const char* key, const char* why, const char* advice) const {
        if (!keys_.at(key).given) refuse(fmt::format("without {}", key), why, advice);
    }
    void size_circle() {
        need("radius", "nothing says how large the circle is", "write radius = \"0.5 m\"");
        if (keys_.at("size").given) refuse("with size", "a circle has a radius", "leave size out");
        body_.size = {2 * radius_, 2 * radius_};
    }
    void size_rectangle() {
        need("size", "nothing says how large the rectangle is", "write size = [\"1 m\", \"0.2 m\"]");
        if (keys_.at("radius").given)
            refuse("with radius", "a rectangle has a size", "leave radius out, or write shape = \"circle\"");
        if (!(body_.size[0] > 0) || !(body_.size[1] > 0))
            refuse("without extent", "its size is not above 0", "write size = [\"1 m\", \"0.2 m\"]");
    }
    void drive() {
        if (body_.velocity[0] != 0 && body_.velocity[1] != 0)
            refuse("with a slanting velocity", "bodies move along x or y so far",
                   "make one of the two 0 m/s");
        if (body_.moves()) need("travel", "nothing says when it stops", "write travel = \"0.05 m\"");
        if (!body_.moves() && keys_.at("travel").given)
            refuse("with travel", "it does not move", "leave travel out, or write a velocity");
    }

    InputError::Where where_;
    Body body_;
    double radius_ = 0, angle_ = 0;
    KeyTable keys_;
};

}  // namespace

void BodyTables::read(const Entry& entry) {
    const toml::array* tables = entry.node.as_array();
    if (!tables || (!tables->empty() && !tables->is_homogeneous(toml::node_type::table)))
        entry.refuse("not a list of tables", "write [[body]] once for every body");
    bodies_.clear();
    for (const toml::node& table : *tables)
        bodies_.push_back(BodyReader(*table.as_table(), entry.where.file).body());
}

std::string BodyTables::canonical() const {
    std::string out;
    for (const Body& b : bodies_)
        out += fmt::format("({} {:.14g} {:.14g} {:.14g} {:.14g} {:.14g} {:.14g} {:.14g} {:.14g} {:.14g})",
                           static_cast<int>(b.shape), b.centre[0], b.centre[1], b.size[0], b.size[1],
                           b.friction_angle, b.velocity[0], b.velocity[1], b.travel, b.ramp);
    return out;
}

std::string BodyTables::allowed() const {
    return "tables of shape, centre, size or radius, velocity, travel";
}

}  // namespace sandgraph::scene
