#include "io/region_series.hpp"

#include <fmt/format.h>

#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"

namespace sandgraph::io {
namespace {

constexpr const char* file_group = "regions";

void write_columns(h5::Group group, const RegionSeries& region) {
    h5::set_attribute(group, ".", "points", std::int64_t{region.points});
    std::vector<double> d, time;
    for (const RegionRow& row : region.rows) d.push_back(row.d_over_B), time.push_back(row.time);
    h5::write(group, "d_over_B", std::span<const double>(d), {d.size()}, "-", h5::Storage::growing);
    h5::write(group, "time", std::span<const double>(time), {d.size()}, "s", h5::Storage::growing);
    for (const RegionColumn& c : region_columns()) {
        std::vector<double> cells;
        for (const RegionRow& row : region.rows) {
            const Spread& s = row.*c.member;
            cells.insert(cells.end(), {s.mean, s.min, s.max});
        }
        h5::write(group, c.name, std::span<const double>(cells), {d.size(), 3}, c.unit, h5::Storage::growing);
    }
}

RegionSeries read_columns(const h5::Group& group, const std::string& name) {
    RegionSeries region{name, static_cast<int>(h5::get_integer(group, ".", "points")), {}};
    const auto d = h5::read<double>(group, "d_over_B");
    region.rows.resize(d.size());
    for (std::size_t k = 0; k < d.size(); ++k) region.rows[k].d_over_B = d[k];
    const auto time =
        group.has("time") ? h5::read<double>(group, "time") : std::vector<double>();  // once none
    for (std::size_t k = 0; k < std::min(d.size(), time.size()); ++k) region.rows[k].time = time[k];
    for (const RegionColumn& c : region_columns()) {
        const auto cells = h5::read<double>(group, c.name);
        if (cells.size() != 3 * d.size())
            h5::refuse(group, group.path_of(c.name) + " differs in length",
                       "mean, min and max a row expected");
        for (std::size_t k = 0; k < d.size(); ++k)
            region.rows[k].*c.member = {cells[3 * k], cells[3 * k + 1], cells[3 * k + 2]};
    }
    return region;
}

}  // namespace

std::span<const RegionColumn> region_columns() {
    static constexpr RegionColumn columns[] = {{"p", "Pa", &RegionRow::p},
                                               {"q", "Pa", &RegionRow::q},
                                               {"sigma_xx", "Pa", &RegionRow::sigma_xx},
                                               {"sigma_yy", "Pa", &RegionRow::sigma_yy},
                                               {"sigma_xy", "Pa", &RegionRow::sigma_xy},
                                               {"K", "-", &RegionRow::K},
                                               {"porosity", "-", &RegionRow::porosity},
                                               {"anisotropy", "-", &RegionRow::anisotropy},
                                               {"coordination", "-", &RegionRow::coordination},
                                               {"strain", "-", &RegionRow::strain},
                                               {"volume_strain", "-", &RegionRow::volume_strain},
                                               {"rotation", "rad", &RegionRow::rotation},
                                               {"x", "m", &RegionRow::x},
                                               {"y", "m", &RegionRow::y}};
    return columns;
}

void write_regions(h5::Group& root, const std::vector<RegionSeries>& regions) {
    if (regions.empty()) return;
    h5::Group group = root.create(file_group);
    for (const RegionSeries& region : regions) write_columns(group.create(region.name), region);
}

std::vector<RegionSeries> read_regions(const h5::Group& root) {
    std::vector<RegionSeries> regions;
    if (!root.has(file_group)) return regions;
    const h5::Group group = root.open(file_group);
    for (const std::string& name : group.names()) regions.push_back(read_columns(group.open(name), name));
    return regions;
}

std::string region_csv(const std::vector<RegionSeries>& regions) {
    std::string text = "region,points,d_over_B";
    for (const RegionColumn& c : region_columns())
        for (const char* statistic : {"mean", "min", "max"}) text += fmt::format(",{}_{}", c.name, statistic);
    text += ",time_s\n";
    for (const RegionSeries& region : regions)
        for (const RegionRow& row : region.rows) {
            text += fmt::format("{},{},{:.6g}", region.name, region.points, row.d_over_B);
            for (const RegionColumn& c : region_columns()) {
                const Spread& s = row.*c.member;
                text += fmt::format(",{:.6g},{:.6g},{:.6g}", s.mean, s.min, s.max);
            }
            text += fmt::format(",{:.6g}\n", row.time);
        }
    return text;
}

}  // namespace sandgraph::io
