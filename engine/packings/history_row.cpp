#include "packings/history_row.hpp"

namespace sandgraph::packings {
namespace {

io::HistoryDensity density_of(const std::string& name) {
    return name == "dense"   ? io::HistoryDensity::dense
           : name == "loose" ? io::HistoryDensity::loose
                             : io::HistoryDensity::custom;
}

}  // namespace

io::HistoryRow history_row(const dem::RveUpdate& u) {
    const Stress s = tension_positive(u.stress);
    const dem::Observables& seen = u.seen;
    const auto real = [](double value) { return static_cast<float>(value); };
    io::HistoryRow row;
    row.status = static_cast<io::HistoryStatus>(u.report.status);
    row.F_inc = u.F_inc, row.volume_ratio = u.volume_ratio, row.stress = u.stress;
    row.dem_steps = u.report.dem_steps, row.inertial_number = real(u.report.inertial_number);
    row.unbalanced = real(seen.unbalanced);
    row.p = real(mean_stress(s)), row.q = real(deviator(s));
    row.void_ratio = real(seen.porosity / (1 - seen.porosity));
    row.coordination = real(seen.coordination), row.sliding_fraction = real(seen.sliding_fraction);
    row.fabric = {real(seen.fabric(0, 0)), real(seen.fabric(1, 1)), real(seen.fabric(0, 1))};
    row.energy = {real(seen.elastic_normal), real(seen.elastic_tangential), real(seen.elastic_rolling),
                  real(seen.kinetic_translation + seen.kinetic_rotation)};
    return row;
}

io::HistoryPacking history_packing(const graph::RowPacking& row, const stress::PackingTraits& traits,
                                   const scene::Grains& grains) {
    return {dem::content_hash(*row.packing),
            static_cast<std::int64_t>(grains.seed),
            density_of(grains.density),
            grains.target_porosity,
            traits,
            row.packing->stress};
}

}  // namespace sandgraph::packings
