#include "io/packing_file.hpp"

#include "base/contracts.hpp"
#include "io/atomic_file.hpp"
#include "io/contact_columns.hpp"
#include "io/content.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"
#include "io/material_group.hpp"
#include "io/packing_valid.hpp"

namespace sandgraph::io {
namespace {

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
    SG_EXPECT(record.packing.y.size() == record.packing.size());
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
