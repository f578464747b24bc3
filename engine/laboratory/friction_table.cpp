#include "laboratory/friction_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/element_test/element_test.hpp"

namespace sandgraph::laboratory {
namespace {

constexpr double late_from = 0.15, degree = std::numbers::pi / 180;

void add_late(FrictionRow& row, const std::vector<dem::BiaxialRow>& test) {
    double sin_phi = 0, porosity = 0, anisotropy = 0, count = 0;
    for (const dem::BiaxialRow& seen : test) {
        if (seen.axial_strain < late_from) continue;
        sin_phi += seen.sin_phi, porosity += seen.seen.porosity, anisotropy += seen.seen.anisotropy;
        ++count;
    }
    count *= static_cast<double>(dem::confining_pressures.size());
    row.late_sin_phi += sin_phi / count;
    row.late_porosity += porosity / count;
    row.late_anisotropy += anisotropy / count;
}

}  // namespace

FrictionRow friction_row(const Specimen& specimen) {
    FrictionRow row{specimen.density, specimen.seed, specimen.porosity, specimen.coordination};
    std::vector<dem::PeakFriction> peaks;
    for (std::size_t k = 0; k < specimen.tests.size(); ++k) {
        peaks.push_back(dem::peak_friction(specimen.tests[k]));
        row.peak[k] = peaks.back().friction_angle;
        add_late(row, specimen.tests[k]);
    }
    row.line = dem::friction_angle(peaks);
    return row;
}

Figures figures(const FrictionRow& r) {
    return {r.porosity,      r.coordination, r.peak[0] / degree, r.peak[1] / degree, r.peak[2] / degree,
            r.line / degree, r.late_sin_phi, r.late_porosity,    r.late_anisotropy};
}

Spread spread(std::span<const FrictionRow> rows) {
    Spread s;
    const double n = static_cast<double>(rows.size());
    for (std::size_t k = 0; k < kFigures.size(); ++k) {
        std::vector<double> values;
        for (const FrictionRow& row : rows) values.push_back(figures(row)[k]);
        for (const double v : values) s.mean[k] += v / n;
        for (const double v : values) s.deviation[k] += (v - s.mean[k]) * (v - s.mean[k]);
        s.deviation[k] = n > 1 ? std::sqrt(s.deviation[k] / (n - 1)) : 0;
        s.least[k] = *std::ranges::min_element(values), s.largest[k] = *std::ranges::max_element(values);
    }
    return s;
}

namespace {

// Peak by the line through the origin [deg]: Liang et al. (2021), Fig. 2, and three YADE packings each.
struct Published {
    const char *paper, *yade;
};
Published published(const std::string& density) {
    return density == "dense" ? Published{"30.2", "29.9 to 33.6"} : Published{"20.9", "21.7 to 24.6"};
}
constexpr const char* kLate =
    "late values published: paper (critical state) sin phi 0.36, n 0.206, F_a 0.32; YADE 0.348, 0.195, "
    "0.28\n";

std::string line(const std::string& name, const Figures& values) {
    std::string text = fmt::format("{:<12}", name);
    for (std::size_t k = 0; k < values.size(); ++k)
        text += fmt::format("{:>9.{}f}", values[k], kFigures[k].decimals);
    return text + "\n";
}

std::string csv_line(const std::string& density, const std::string& seed, const Figures& values) {
    std::string text = density + "," + seed;
    for (const double v : values) text += fmt::format(",{:.6g}", v);
    return text + "\n";
}

std::string headings() {
    std::string text = fmt::format("{:<12}{:>18}{:>36}{:>27}\n{:<12}", "", "packing",
                                   "peak friction angle [deg]", "15 to 20 % strain", "seed");
    for (const Figure& f : kFigures) text += fmt::format("{:>9}", f.heading);
    return text + "\n";
}

std::vector<FrictionRow> of_density(std::span<const FrictionRow> rows, const std::string& density) {
    std::vector<FrictionRow> chosen;
    for (const FrictionRow& row : rows)
        if (row.density == density) chosen.push_back(row);
    return chosen;
}

std::string section(std::span<const FrictionRow> rows) {
    const std::string& density = rows.front().density;
    std::string text;
    for (const FrictionRow& row : rows) text += line(fmt::format("{} {}", density, row.seed), figures(row));
    const Spread s = spread(rows);
    text += line("mean", s.mean) + line("sd", s.deviation) + line("min", s.least) + line("max", s.largest);
    const Published p = published(density);
    return text +
           fmt::format("line through the origin published: paper {} deg, YADE {} deg\n\n", p.paper, p.yade);
}

}  // namespace

std::string friction_table(std::span<const FrictionRow> rows) {
    std::string text = headings();
    for (const char* density : kDensities)
        if (const auto chosen = of_density(rows, density); !chosen.empty()) text += section(chosen);
    return text + kLate;
}

std::string friction_csv(std::span<const FrictionRow> rows) {
    std::string text = "density,seed";
    for (const Figure& f : kFigures) text += std::string(",") + f.name;
    text += "\n";
    for (const FrictionRow& row : rows)
        text += csv_line(row.density, fmt::format("{}", row.seed), figures(row));
    for (const char* density : kDensities) {
        const auto chosen = of_density(rows, density);
        if (chosen.empty()) continue;
        const Spread s = spread(chosen);
        text += csv_line(density, "mean", s.mean) + csv_line(density, "sd", s.deviation) +
                csv_line(density, "min", s.least) + csv_line(density, "max", s.largest);
    }
    return text;
}

}  // namespace sandgraph::laboratory
