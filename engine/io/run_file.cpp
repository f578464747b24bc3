#include "io/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "base/contracts.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/checkpoint.hpp"
#include "io/frame.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_file.hpp"
#include "io/history_journal.hpp"
#include "io/xdmf.hpp"

namespace sandgraph::io {
namespace fs = std::filesystem;
namespace {

constexpr std::array kBesideRun{"summary.json", "fields.xdmf", "history.h5", "regions.csv"};

void remove_kind(const fs::path& folder, const char* extension) {
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == extension) fs::remove(entry.path());
}

// Whatever an earlier run has left: a report would take it for this one's.
void remove_stale(const fs::path& folder) {
    remove_restart_files(folder);
    if (!fs::exists(folder / "run.h5")) return;  // pictures and packings of somebody else
    remove_kind(folder / "packings", ".h5"), remove_kind(folder / "pictures", ".png");
    remove_kind(folder / "pictures", ".svg"), remove_kind(folder / "pictures", ".pdf");
    for (const char* name : kBesideRun) fs::remove(folder / name);
    fs::remove(folder / "run.h5");  // last: it tells whose the others are
}

bool is_run(const fs::path& file) try {
    const h5::File opened = h5::File::open(file);
    const h5::Group root = opened.root();
    return h5::has_attribute(root, ".", "content") && h5::get_text(root, ".", "content") == "run";
} catch (const InputError&) {
    return false;
}

[[noreturn]] void refuse_foreign(const fs::path& file) {
    throw InputError({file.string()}, "is not of a run of this program", "a run here would write over it",
                     "move it away, or give another folder with -o");
}

bool is_load_csv(const fs::path& file) {
    std::string header;
    std::getline(std::ifstream(file), header);
    return header.empty() || header.starts_with("d_over_B,load_N_per_m");
}

// Unpacked and packed again: H5Ocopy of HDF5 1.10 crashes when the disk is full.
void copy_frames(const fs::path& from, h5::Group& to, std::size_t count) {
    if (count == 0) return;
    const h5::File file = h5::File::open(from);
    const h5::Group source = file.root().open("frames");
    for (std::size_t k = 0; k < count; ++k)
        write_frame(to.create(frame_name(k)), read_frame(source.open(frame_name(k))));
}

std::size_t archived_count(Archive& a, std::string_view name, std::size_t count) {
    std::vector<std::int64_t> value{static_cast<std::int64_t>(count)};
    field_of_known_length(a, name, value);
    require_state(value.front() >= 0, "counts of rows");
    return static_cast<std::size_t>(value.front());
}

}  // namespace

void remove_restart_files(const fs::path& folder) {
    remove_checkpoints(folder / checkpoint_name);
    fs::remove(folder / journal_name);
}

void require_own_outputs(const fs::path& folder) {
    if (fs::exists(folder / "load.csv") && !is_load_csv(folder / "load.csv"))
        refuse_foreign(folder / "load.csv");
    const fs::path run = folder / "run.h5";
    if (fs::exists(run)) return is_run(run) ? void() : refuse_foreign(run);
    for (const char* name : kBesideRun)
        if (fs::exists(folder / name)) refuse_foreign(folder / name);
}

RunFile::RunFile(fs::path folder, RunRecord record)
    : folder_(std::move(folder)), record_(std::move(record)) {}

RunFile RunFile::create(const fs::path& folder, const RunInfo& info, bool load_audited) {
    fs::create_directories(folder);
    remove_stale(folder);
    RunFile run(folder, {info, {}, {}, {}, 0, {}, {}, load_audited});
    run.commit();
    run.rewrite_csv();
    return run;
}

RunFile RunFile::resume(const fs::path& folder, const RunInfo& info) {
    RunRecord record = read_run(folder / "run.h5");
    if (record.info.scene_hash != info.scene_hash)
        throw InputError({(folder / "run.h5").string()}, "the folder holds a run of another scene",
                         fmt::format("scene hash {} instead of {}", record.info.scene_hash, info.scene_hash),
                         "resume with the unchanged scene, or start anew in another folder");
    record.info = info;
    return RunFile(folder, std::move(record));
}

fs::path RunFile::path() const { return folder_ / "run.h5"; }

void RunFile::append(const LoadRow& row) {
    if (!csv_) rewrite_csv();
    record_.load.push_back(row);
    csv_->append(row);
}

void RunFile::append(const Frame& frame) {
    pending_.push_back(frame);
    commit();
}

void RunFile::follow(const std::vector<RegionSeries>& regions) {
    const auto same = [](const RegionSeries& a, const RegionSeries& b) {
        return a.name == b.name && a.points == b.points;
    };
    if (record_.load.empty() && record_.regions.empty())
        record_.regions = regions;
    else if (!std::ranges::equal(record_.regions, regions, same))
        throw InputError({path().string()}, "the run to resume follows other regions",
                         fmt::format("{} regions, {} now", record_.regions.size(), regions.size()),
                         "resume with the [[region]] tables it was started with");
}

void RunFile::append(const std::vector<RegionRow>& rows) {
    SG_EXPECT(rows.size() == record_.regions.size());
    for (std::size_t k = 0; k < rows.size(); ++k) record_.regions[k].rows.push_back(rows[k]);
}

void RunFile::commit() {
    AtomicFile target(path());
    h5::File file = h5::File::create(target.temporary());
    write_run_groups(file.root(), record_);
    h5::Group frames = file.root().open("frames");
    copy_frames(path(), frames, record_.frames);
    for (std::size_t k = 0; k < pending_.size(); ++k)
        write_frame(frames.create(frame_name(record_.frames + k)), pending_[k]);
    write_point_ids(file.root());
    file.close();
    target.commit();
    record_.frames += pending_.size();
    pending_.clear();
    SG_ENSURE(fs::exists(path()));
    write_xdmf(folder_ / "fields.xdmf", path());
    if (!record_.regions.empty()) write_text(folder_ / "regions.csv", region_csv(record_.regions));
}

void RunFile::archive(Archive& a) {
    if (!a.reading()) commit();
    // Regions have one row each at a time.
    const std::size_t held = record_.regions.empty() ? 0 : record_.regions.front().rows.size();
    const Extent extent{archived_count(a, "run/load_rows", record_.load.size()),
                        archived_count(a, "run/frames", record_.frames),
                        record_.regions.empty() ? 0 : archived_count(a, "run/region_rows", held)};
    if (a.reading()) cut_back(extent, {record_.load.size(), record_.frames, held});
}

void RunFile::rewrite_csv() { csv_.emplace(folder_ / "load.csv", record_.load, record_.load_audited); }

void RunFile::cut_back(const Extent& to, const Extent& from) {
    if (to.load > from.load || to.frames > from.frames || to.regions > from.regions)
        throw InputError({path().string()}, "run.h5 ends before the checkpoint",
                         fmt::format("{} load rows, {} frames and {} rows of regions, {}, {} and {} needed",
                                     from.load, from.frames, from.regions, to.load, to.frames, to.regions),
                         "start the run anew, without --resume");
    fs::remove(folder_ / "summary.json");  // of an earlier end: a run that goes on has not ended
    record_.load.resize(to.load);
    record_.frames = to.frames;
    for (RegionSeries& region : record_.regions) region.rows.resize(to.regions);
    commit();
    rewrite_csv();
}

}  // namespace sandgraph::io
