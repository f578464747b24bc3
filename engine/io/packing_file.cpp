#include "io/packing_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "dem/packing/packing.hpp"
#include "io/atomic_file.hpp"
#include "io/content.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"

namespace sandgraph::io {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& problem, const std::string& why) {
    throw InputError({file}, problem, why, "make the packing again with 'sandgraph rve prepare'");
}

void check_length(const std::string& file, const char* name, std::size_t length, std::size_t grains) {
    if (length != grains)
        refuse(file, fmt::format("/grains/{} has {} entries", name, length),
               fmt::format("/grains/x has {}", grains));
}

void check_velocity(const std::string& file, const char* name, const std::vector<double>& v,
                    std::size_t grains) {
    if (v.empty()) return;  // at rest
    check_length(file, name, v.size(), grains);
    for (std::size_t g = 0; g < grains; ++g)
        if (!std::isfinite(v[g]))
            refuse(file, fmt::format("/grains/{} of grain {} is not finite", name, g), "NaN or infinity");
}

void check_contact(const std::string& file, std::size_t c, const dem::Contact& contact, std::size_t grains) {
    const auto inside = [&](std::int32_t g) { return g >= 0 && static_cast<std::size_t>(g) < grains; };
    if (!inside(contact.i) || !inside(contact.j))
        refuse(file, fmt::format("contact {} joins grains {} and {}", c, contact.i, contact.j),
               fmt::format("there are grains 0 to {}", static_cast<long>(grains) - 1));
    if (contact.i == contact.j && contact.cell_x == 0 && contact.cell_y == 0)
        refuse(file, fmt::format("contact {} joins grain {} to itself", c, contact.i),
               "no periodic image between");
    if (!std::isfinite(contact.tangential) || !std::isfinite(contact.moment))
        refuse(file, fmt::format("the history of contact {} is not finite", c), "NaN or infinity");
}

// Throws InputError unless lengths agree, contacts lie inside and dem::check_packing accepts the packing.
void check_stored_packing(const dem::Packing& p, const std::string& file) {
    const std::size_t grains = p.size();
    check_length(file, "y", p.y.size(), grains);
    check_length(file, "r", p.r.size(), grains);
    check_velocity(file, "vx", p.vx, grains);
    check_velocity(file, "vy", p.vy, grains);
    check_velocity(file, "spin", p.spin, grains);
    if (!p.L.allFinite()) refuse(file, "/cell/L is not finite", "NaN or infinity");
    dem::check_packing(p, {file, 0, {}});
    for (std::size_t c = 0; c < p.contacts.size(); ++c) check_contact(file, c, p.contacts[c], grains);
}

template <class T>
void write_member(h5::Group& group, const char* name, const char* unit,
                  const std::vector<dem::Contact>& contacts, T dem::Contact::*member) {
    std::vector<T> column;
    column.reserve(contacts.size());
    for (const dem::Contact& c : contacts) column.push_back(c.*member);
    h5::write(group, name, std::span<const T>(column), {column.size()}, unit);
}

template <class T>
void read_member(const h5::Group& group, const char* name, std::vector<dem::Contact>& contacts,
                 T dem::Contact::*member) {
    const std::vector<T> column = h5::read<T>(group, name);
    if (column.size() != contacts.size())
        h5::refuse(group, fmt::format("{} has {} entries", group.path_of(name), column.size()),
                   fmt::format("there are {} contacts", contacts.size()));
    for (std::size_t c = 0; c < column.size(); ++c) contacts[c].*member = column[c];
}

void write_contacts(h5::Group group, const std::vector<dem::Contact>& contacts) {
    write_member(group, "i", "", contacts, &dem::Contact::i);
    write_member(group, "j", "", contacts, &dem::Contact::j);
    write_member(group, "cell_x", "", contacts, &dem::Contact::cell_x);
    write_member(group, "cell_y", "", contacts, &dem::Contact::cell_y);
    write_member(group, "tangential", "N", contacts, &dem::Contact::tangential);
    write_member(group, "moment", "N m", contacts, &dem::Contact::moment);
}

std::vector<dem::Contact> read_contacts(const h5::Group& group) {
    std::vector<dem::Contact> contacts(h5::read<std::int32_t>(group, "i").size());
    read_member(group, "i", contacts, &dem::Contact::i);
    read_member(group, "j", contacts, &dem::Contact::j);
    read_member(group, "cell_x", contacts, &dem::Contact::cell_x);
    read_member(group, "cell_y", contacts, &dem::Contact::cell_y);
    read_member(group, "tangential", contacts, &dem::Contact::tangential);
    read_member(group, "moment", contacts, &dem::Contact::moment);
    return contacts;
}

struct Parameter {
    const char* name;
    double dem::Material::*member;
    bool may_be_zero;
    double limit;  // below which it must lie
};

constexpr double none = std::numeric_limits<double>::infinity();
constexpr std::array<Parameter, 8> parameters{{
    {"density", &dem::Material::density, false, none},
    {"young", &dem::Material::young, false, none},
    {"stiffness_ratio", &dem::Material::stiffness_ratio, true, none},
    {"friction_angle", &dem::Material::friction_angle, true, std::numbers::pi / 2},
    {"rolling_stiffness", &dem::Material::rolling_stiffness, true, none},
    {"rolling_limit", &dem::Material::rolling_limit, true, none},
    {"damping", &dem::Material::damping, true, 1},
    {"depth", &dem::Material::depth, false, none},
}};

void check(const h5::Group& group, const Parameter& p, double value) {
    const bool above = p.may_be_zero ? value >= 0 : value > 0;
    if (!above || !(value < p.limit))
        h5::refuse(
            group, fmt::format("material {} = {:g}", p.name, value),
            fmt::format("it must be {} 0 and below {:g}", p.may_be_zero ? "at least" : "above", p.limit));
}

void write_material(h5::Group group, const dem::Material& material) {
    for (const Parameter& p : parameters) h5::set_attribute(group, ".", p.name, material.*p.member);
    const bool total = material.rolling_form == dem::RollingForm::total;
    h5::set_attribute(group, ".", "rolling_form", std::string(total ? "total" : "incremental"));
}

dem::Material read_material(const h5::Group& group) {
    dem::Material material;
    for (const Parameter& p : parameters) {
        material.*p.member = h5::get_real(group, ".", p.name);
        check(group, p, material.*p.member);
    }
    const std::string form = h5::get_text(group, ".", "rolling_form");
    if (form != "total" && form != "incremental")
        h5::refuse(group, "rolling_form = " + form, "known: incremental, total");
    material.rolling_form = form == "total" ? dem::RollingForm::total : dem::RollingForm::incremental;
    return material;
}

constexpr std::int64_t schema = 1;

void write_matrix(h5::Group& group, const char* name, const Mat2& m, const char* unit) {
    const double rows[] = {m(0, 0), m(0, 1), m(1, 0), m(1, 1)};
    h5::write(group, name, std::span<const double>(rows), {2, 2}, unit);
}

Mat2 read_matrix(const h5::Group& group, const char* name) {
    const auto rows = h5::read<double>(group, name);
    if (rows.size() != 4)
        h5::refuse(group, group.path_of(name) + " is not a 2x2 matrix", "4 numbers expected");
    return (Mat2() << rows[0], rows[1], rows[2], rows[3]).finished();
}

void write_column(h5::Group& group, const char* name, const std::vector<double>& values, const char* unit) {
    h5::write(group, name, std::span<const double>(values), {values.size()}, unit);
}

void write_grains(h5::Group group, const dem::Packing& p) {
    write_column(group, "x", p.x, "m");
    write_column(group, "y", p.y, "m");
    write_column(group, "r", p.r, "m");
    write_column(group, "vx", p.vx, "m/s");
    write_column(group, "vy", p.vy, "m/s");
    write_column(group, "spin", p.spin, "rad/s");
}

void read_grains(const h5::Group& group, dem::Packing& p) {
    p.x = h5::read<double>(group, "x");
    p.y = h5::read<double>(group, "y");
    p.r = h5::read<double>(group, "r");
    p.vx = h5::read<double>(group, "vx");
    p.vy = h5::read<double>(group, "vy");
    p.spin = h5::read<double>(group, "spin");
}

}  // namespace

void write_packing(const std::filesystem::path& path, const PackingRecord& record) {
    SG_EXPECT(record.packing.r.size() == record.packing.size());
    AtomicFile target(path);
    h5::File file = h5::File::create(target.temporary());
    h5::Group root = file.root(), cell = root.create("cell");
    mark_content(root, "packing", schema);
    h5::set_attribute(root, ".", "recipe", record.recipe);
    h5::set_attribute(root, ".", "porosity", dem::porosity(record.packing));
    write_matrix(cell, "H", record.packing.H, "m");
    write_matrix(cell, "L", record.packing.L, "1/s");
    write_grains(root.create("grains"), record.packing);
    write_contacts(root.create("contacts"), record.packing.contacts);
    write_material(root.create("material"), record.material);
    file.close();
    target.commit();
}

PackingRecord read_packing(const std::filesystem::path& path) {
    const h5::File file = h5::File::open(path);
    const h5::Group root = file.root();
    require_content(root, "packing", schema);
    const h5::Group cell = root.open("cell");
    PackingRecord record;
    record.recipe = h5::get_text(root, ".", "recipe");
    record.packing.H = read_matrix(cell, "H");
    record.packing.L = read_matrix(cell, "L");
    read_grains(root.open("grains"), record.packing);
    record.packing.contacts = read_contacts(root.open("contacts"));
    record.material = read_material(root.open("material"));
    check_stored_packing(record.packing, path.string());
    return record;
}

}  // namespace sandgraph::io
