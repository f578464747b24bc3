#include "report/region_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/colour_scale.hpp"

namespace sandgraph::report {
namespace {

constexpr double degree = 180 / std::numbers::pi;
constexpr double K_shown = 5;  // beyond it a coefficient tells of vanishing vertical stress only
// F_a past 1 is that of a packing whose few contacts carry nothing.

struct Panel {
    const char* label;
    io::Spread io::RegionRow::*member;
    double scale;
    const char* range;
};
constexpr Panel panels[] = {{"equivalent strain ε_{eq}", &io::RegionRow::strain, 1, "[0:*]"},
                            {"porosity n", &io::RegionRow::porosity, 1, "[*:*]"},
                            {"fabric anisotropy F_a", &io::RegionRow::anisotropy, 1, "[0:*<1]"},
                            {"deviator q [kPa]", &io::RegionRow::q, 1e-3, "[0:*]"},
                            {"K = σ_{xx}/σ_{yy}", &io::RegionRow::K, 1, "[0:*]"},
                            {"rotation θ [deg], anticlockwise +", &io::RegionRow::rotation, degree, "[*:*]"}};

std::string rows(const io::RegionSeries& region, const Panel& panel, bool by_time) {
    const bool is_K = panel.member == &io::RegionRow::K;
    const auto shown = [&](double v) { return (is_K ? std::min(v, K_shown) : v) * panel.scale; };
    std::string text;
    for (const io::RegionRow& row : region.rows) {
        const io::Spread& s = row.*panel.member;
        if (std::isfinite(s.mean) && std::isfinite(s.min))
            text += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", by_time ? row.time : row.d_over_B,
                                shown(s.mean), shown(s.min), shown(s.max));
    }
    return text;
}

std::string name_of(std::size_t panel, std::size_t region) {
    return fmt::format("p{}r{}.txt", panel, region);
}

std::string label_of(const io::RegionSeries& region) {
    return fmt::format("{} ({} point{})", region.name, region.points, region.points == 1 ? "" : "s");
}

std::string panel_script(const RegionPicture& picture, std::size_t k, Plot& plot) {
    std::string shadows, lines;
    for (std::size_t r = 0; r < picture.regions.size(); ++r) {
        std::string data = rows(picture.regions[r], panels[k], picture.by_time);
        if (data.empty()) continue;
        plot.data.emplace_back(name_of(k, r), std::move(data));
        shadows += fmt::format(
            "'{}' using 1:3:4 with filledcurves fs transparent solid 0.15 noborder lc rgb '{}' "
            "notitle, ",
            name_of(k, r), series_colour(r));
        lines += fmt::format("'{}' using 1:2 with lines lw 2 lc rgb '{}' title {}, ", name_of(k, r),
                             series_colour(r), literal(label_of(picture.regions[r])));
    }
    const std::string items = shadows + lines;
    if (items.empty())
        return fmt::format("set ylabel '{}: not known'\nplot [0:1][0:1] NaN notitle\n", panels[k].label);
    return fmt::format("set ylabel '{}'\nset yrange {}\n{}\nplot {}\n", panels[k].label, panels[k].range,
                       k == 0 ? "set key top left noenhanced" : "unset key",
                       items.substr(0, items.size() - 2));
}

}  // namespace

Plot region_plot(const RegionPicture& picture) {
    Plot plot;
    plot.width = 1500, plot.height = 900;
    plot.script = fmt::format(
        "set multiplot layout 2,3 title {} noenhanced\nset grid lt 1 lw 0.6 lc rgb '#e4e4e4'\nset xlabel "
        "'{}'\nset xrange [0:*]\n",
        wrapped(picture.title + ": regions, mean and range", plot.width),
        picture.by_time ? "time [s]" : "displacement d/B");
    for (std::size_t k = 0; k < std::size(panels); ++k) plot.script += panel_script(picture, k, plot);
    plot.script += "unset multiplot\n";
    return plot;
}

Picture draw_region_picture(const RegionPicture& picture, const std::filesystem::path& png) {
    return draw(region_plot(picture), png);
}

}  // namespace sandgraph::report
