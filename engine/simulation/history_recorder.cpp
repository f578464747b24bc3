#include "simulation/history_recorder.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/revision.hpp"
#include "dem/rve.hpp"
#include "io/history_file.hpp"
#include "packings/history_row.hpp"
#include "packings/samples.hpp"
#include "simulation/history_points.hpp"

namespace sandgraph::simulation {
namespace {

constexpr std::size_t kBlock = 2048;  // rows handed to the writer at once

std::vector<io::HistoryPacking> packings_of(const scene::Scene& scene,
                                            const packings::PreparedGround& ground) {
    std::vector<io::HistoryPacking> out;
    const scene::Grains& grains = scene.ground.grains;
    const auto samples = static_cast<std::size_t>(grains.samples);
    for (std::size_t k = 0; k < ground.packings.size(); ++k)
        out.push_back(packings::history_packing(ground.packings[k], ground.traits[k],
                                                packings::sample_recipe(grains, int(k % samples))));
    return out;
}

}  // namespace

std::vector<std::int32_t> watch_history(Simulation& simulation, const scene::Scene& scene) {
    const graph::GroundState& s = simulation.state();
    if (s.law->answers() == stress::Answers::formula)
        throw InputError(scene.where("output.history"), "output.history = true",
                         "a ground without grains has no DEM updates",
                         "run with ground.law = \"rve\", or leave history out");
    const auto plate = s.bodies.empty() ? std::nullopt : std::optional(s.bodies.front().plate.rectangle());
    return s.law->watch(history_points(s.points, plate, scene.anchor.width, scene.output.history_points,
                                       scene.ground.grains.seed));
}

HistoryRecorder::HistoryRecorder(const scene::Scene& scene, const packings::PreparedGround& ground,
                                 Simulation& simulation, std::filesystem::path folder, bool resume)
    : folder_(std::move(folder)),
      source_{"run", scene.text, version(), revision()},
      packings_(packings_of(scene, ground)),
      rows_max_(
          static_cast<std::size_t>(scene.output.history_max / double(io::HistoryJournal::row_bytes()))) {
    const mpm::Points& points = simulation.state().points;
    const std::vector<std::int32_t> chosen = watch_history(simulation, scene);
    const std::vector<std::int32_t> dealt = packings::deal(points.row, scene.ground.grains);
    if (scene.mode == scene::Mode::screening) mode_ = io::HistoryMode::audit;
    history_of_.assign(points.size(), -1);
    for (const std::int32_t point : chosen) {
        const auto p = static_cast<std::size_t>(point);
        history_of_[p] = static_cast<std::int32_t>(histories_.size());
        histories_.push_back({.packing = dealt[p], .point = point, .x = points.x[p], .y = points.y[p]});
    }
    length_.assign(histories_.size(), 0);
    last_time_.assign(histories_.size(), 0);
    if (!resume) journal_.emplace(journal_path(), 0);
}

void HistoryRecorder::after_step(const Simulation& simulation, BackgroundWriter& writer) {
    simulation.state().law->each_watched_update(
        [&](const dem::RveUpdate& update) { log(update, simulation.time()); });
    if (pending_.size() >= kBlock) hand_over(writer);
}

// A history that loses one row is over, so logging ends for all at once.
void HistoryRecorder::log(const dem::RveUpdate& update, double time) {
    full_ = full_ || logged_ == rows_max_;
    if (full_) return;
    const std::int32_t history = history_of_[static_cast<std::size_t>(update.point)];
    const auto h = static_cast<std::size_t>(history);
    io::HistoryRow row = packings::history_row(update);
    row.mode = mode_, row.history = history, row.sequence = static_cast<std::int32_t>(length_[h]++);
    row.dt = time - last_time_[h];
    last_time_[h] = time;
    pending_.push_back(row);
    ++logged_;
}

void HistoryRecorder::hand_over(BackgroundWriter& writer) {
    auto rows = std::make_shared<std::vector<io::HistoryRow>>(std::move(pending_));
    pending_.clear();
    writer.post([this, rows] { journal_->append(*rows); });
}

void HistoryRecorder::archive(Archive& a) {
    std::vector<std::int64_t> counts{static_cast<std::int64_t>(logged_), full_};
    if (!a.reading()) {
        journal_->append(pending_), pending_.clear();
        journal_->sync();
    }
    field_of_known_length(a, "history/counts", counts), a.field("history/length", length_);
    a.field("history/time", last_time_);
    if (!a.reading()) return;
    if (length_.size() != histories_.size() || last_time_.size() != histories_.size())
        throw InputError({folder_.string()}, "the run to resume logs other points",
                         fmt::format("{} histories, {} now", length_.size(), histories_.size()),
                         "resume with the history_points it was started with");
    require_state(counts[0] >= 0, "history/counts");
    logged_ = static_cast<std::size_t>(counts[0]), full_ = counts[1] != 0;
    journal_.emplace(journal_path(), logged_);
}

void HistoryRecorder::write() {
    journal_->append(pending_), pending_.clear();
    io::HistoryWriter writer(folder_ / "history.h5", source_, packings_, histories_);
    journal_->read([&](std::span<const io::HistoryRow> rows) { writer.append(rows); });
    writer.commit();
}

}  // namespace sandgraph::simulation
