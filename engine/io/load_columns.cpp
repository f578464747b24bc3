#include "io/load_columns.hpp"

#include <fmt/format.h>

#include <array>

namespace sandgraph::io {
namespace {

constexpr std::array<LoadColumn, 16> columns{{
    {"d_over_B", "d_over_B", "-", &LoadRow::d_over_B},
    {"load", "load_N_per_m", "N/m", &LoadRow::load},
    {"top", "top_N_per_m", "N/m", &LoadRow::leading},
    {"bottom", "bottom_N_per_m", "N/m", &LoadRow::trailing},
    {"time", "time_s", "s", &LoadRow::time},
    {"kinetic_energy", "kinetic_energy_J_per_m", "J/m", &LoadRow::kinetic_energy},
    {"strain_work", "strain_work_J_per_m", "J/m", &LoadRow::strain_work},
    {"plate_work", "plate_work_J_per_m", "J/m", &LoadRow::plate_work},
    {"rve_active", "rve_active", "-", &LoadRow::rve_active},
    {"dem_steps", "dem_steps", "-", &LoadRow::dem_steps},
    {"damping_share", "damping_share", "-", &LoadRow::damping_share},
    {"pic_share", "pic_share", "-", &LoadRow::pic_share},
    {"inertia_share", "inertia_share", "-", &LoadRow::inertia_share},
    {"load_corrected", "load_corrected_N_per_m", "N/m", &LoadRow::corrected},
    {"load_low", "load_low_N_per_m", "N/m", &LoadRow::low},
    {"load_high", "load_high_N_per_m", "N/m", &LoadRow::high},
}};

constexpr std::size_t of_audits = 3;  // the last ones

}  // namespace

std::span<const LoadColumn> load_columns(bool audited) {
    return std::span(columns).first(columns.size() - (audited ? 0 : of_audits));
}

std::string load_csv_header(bool audited) {
    std::string text;
    for (const LoadColumn& c : load_columns(audited))
        text += fmt::format("{}{}", text.empty() ? "" : ",", c.header);
    return text;
}

std::string load_csv_line(const LoadRow& row, bool audited) {
    std::string text;
    for (const LoadColumn& c : load_columns(audited))
        text += fmt::format("{}{}", text.empty() ? "" : ",", row.*c.member);
    return text;
}

}  // namespace sandgraph::io
