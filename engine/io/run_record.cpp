#include "io/run_record.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/content.hpp"
#include "io/frame.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"
#include "io/load_columns.hpp"

namespace sandgraph::io {
namespace {

constexpr std::int64_t schema = 1;

void write_info(h5::Group scene, const RunInfo& info) {
    h5::set_attribute(scene, ".", "text", info.scene_text);
    h5::set_attribute(scene, ".", "hash", info.scene_hash);
    h5::set_attribute(scene, ".", "version", info.version);
    h5::set_attribute(scene, ".", "git", info.git);
    h5::set_attribute(scene, ".", "mode", info.mode);
    h5::set_attribute(scene, ".", "threads", std::int64_t{info.threads});
}

RunInfo read_info(const h5::Group& scene) {
    return {h5::get_text(scene, ".", "text"),    h5::get_text(scene, ".", "hash"),
            h5::get_text(scene, ".", "version"), h5::get_text(scene, ".", "git"),
            h5::get_text(scene, ".", "mode"),    static_cast<int>(h5::get_integer(scene, ".", "threads"))};
}

void write_load(h5::Group group, const std::vector<LoadRow>& rows, bool audited) {
    for (const LoadColumn& c : load_columns(audited)) {
        std::vector<double> column;
        for (const LoadRow& row : rows) column.push_back(row.*c.member);
        h5::write(group, c.dataset, std::span<const double>(column), {column.size()}, c.unit,
                  h5::Storage::growing);
    }
}

bool load_audited(const h5::Group& group) { return group.has(load_columns(true).back().dataset); }

std::vector<LoadRow> read_load(const h5::Group& group) {
    const auto columns = load_columns(load_audited(group));
    std::vector<LoadRow> rows(h5::read<double>(group, columns.front().dataset).size());
    for (const LoadColumn& c : columns) {
        const auto column = h5::read<double>(group, c.dataset);
        if (column.size() != rows.size())
            h5::refuse(group, group.path_of(c.dataset) + " differs in length", "all load columns must agree");
        for (std::size_t k = 0; k < rows.size(); ++k) rows[k].*c.member = column[k];
    }
    return rows;
}

void write_scalars(h5::Group group, const std::map<std::string, double>& values, const char* unit) {
    for (const auto& [name, value] : values) h5::write(group, name, std::span(&value, 1), {1}, unit);
}

std::map<std::string, double> read_scalars(const h5::Group& group) {
    std::map<std::string, double> values;
    for (const std::string& name : group.names()) {
        const auto value = h5::read<double>(group, name);
        if (value.size() != 1)
            h5::refuse(group, group.path_of(name) + " is not one number", "a scalar is expected");
        values[name] = value[0];
    }
    return values;
}

}  // namespace

void write_run_groups(h5::Group root, const RunRecord& record) {
    mark_content(root, "run", schema);
    write_info(root.create("scene"), record.info);
    write_load(root.create("load"), record.load, record.load_audited);
    write_scalars(root.create("timing"), record.timing, "s");
    write_scalars(root.create("rve"), record.counters, "-");
    write_screening(root, record.screening);
    write_regions(root, record.regions);
    root.create("frames");
}

RunRecord read_run(const std::filesystem::path& run_h5) {
    const h5::File file = h5::File::open(run_h5);
    const h5::Group root = file.root();
    require_content(root, "run", schema);
    return {read_info(root.open("scene")),
            read_load(root.open("load")),
            read_scalars(root.open("timing")),
            read_scalars(root.open("rve")),
            root.open("frames").names().size(),
            read_screening(root),
            read_regions(root),
            load_audited(root.open("load"))};
}

Frame read_run_frame(const std::filesystem::path& run_h5, std::size_t index) {
    const h5::File file = h5::File::open(run_h5);
    const h5::Group root = file.root();
    require_content(root, "run", schema);
    const h5::Group frames = root.open("frames");
    const std::size_t count = frames.names().size();
    if (index >= count)
        throw InputError({run_h5.string()}, fmt::format("no frame {}", index),
                         fmt::format("the run has {} frames", count), "ask for an earlier one");
    return read_frame(frames.open(frame_name(index)));
}

}  // namespace sandgraph::io
