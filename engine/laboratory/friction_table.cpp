#include "laboratory/friction_table.hpp"

#include <fmt/format.h>

namespace sandgraph::laboratory {
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
