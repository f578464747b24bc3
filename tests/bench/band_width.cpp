// What ground.internal_length does: a plate (H/B = 3) pulled out of Mohr-Coulomb sand that softens from 43 to
// 33 deg over a shear of 0.3, or of another amount (1e9: it does not soften), on several meshes. Load
// factors, width at half height and angle of the band above the plate's edge, energy. Usage: bench_band_width
// LENGTH_IN_B SHEAR CELLS_A_WIDTH... [-- KEY=VALUE...]
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <map>
#include <numbers>

#include "scene/read_scene.hpp"
#include "simulation/scene_spec.hpp"
#include "tests/support/softening_sand.hpp"

namespace {

using namespace sandgraph;
constexpr double kDegrees = std::numbers::pi / 180;
constexpr const char* kScene = R"(
[domain]
width = "4.5 m"
depth = "4.5 m"
[anchor]
thickness = "0.25 m"
pull_to = 0.22
[ground]
law = "mohr_coulomb"
)";

struct Sand {
    std::unique_ptr<simulation::Simulation> model;
    const support::SofteningSand* law = nullptr;
    double unit = 1;  // load of a factor of 1, of the half model [N/m]
};

Sand make(const scene::Scene& scene, double shear) {
    const packings::PreparedGround ground = packings::prepare_ground(scene);
    simulation::Spec spec = simulation::spec_of(scene, ground);
    Sand sand;
    spec.law = [&](const mpm::Points& points) {
        std::vector<Stress> initial;
        for (const auto row : points.row) {
            const double s = -ground.row_pressure[static_cast<std::size_t>(row)];
            initial.push_back({s, s, 0});
        }
        support::SofteningConstants c;
        c.peak.friction_angle = 43 * kDegrees, c.peak.dilation_angle = 12 * kDegrees;
        c.residual.friction_angle = 33 * kDegrees, c.shear = shear;
        auto law = std::make_unique<support::SofteningSand>(c, std::move(initial));
        sand.law = law.get();
        return law;
    };
    sand.model = std::make_unique<simulation::Simulation>(spec);
    sand.unit = simulation::unit_load(scene, ground) / simulation::whole_plate_factor(scene);
    return sand;
}

// Of a row of points the greatest shear, where it is, and the width at half of it; to the right of x = 0.
struct Across {
    double x = 0, width = 0;
};
Across across(const std::vector<std::pair<double, double>>& row) {
    std::size_t top = 0;
    for (std::size_t k = 0; k < row.size(); ++k)
        if (row[k].second > row[top].second) top = k;
    const double half = 0.5 * row[top].second;
    const auto edge = [&](int step) {
        std::size_t k = top;
        while (row[k].second > half) {
            const std::size_t next = k + static_cast<std::size_t>(step);
            if (next >= row.size()) return row[k].first;
            if (row[next].second <= half)
                return row[k].first + (row[next].first - row[k].first) * (row[k].second - half) /
                                          (row[k].second - row[next].second);
            k = next;
        }
        return row[k].first;
    };
    return {row[top].first, edge(1) - edge(-1)};
}

// The band between a third and two thirds of the way from the plate to the surface: width across it [B],
// angle to the vertical [deg].
void tell_band(const Sand& sand) {
    const mpm::Points& points = sand.model->state().points;
    std::map<std::int32_t, std::vector<std::pair<double, double>>> rows;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double depth = (points.row[p] + 0.5) * 2 * points.half;
        if (depth > 1 && depth < 2) rows[points.row[p]].emplace_back(points.x[p], sand.law->shear()[p]);
    }
    double n = 0, x = 0, y = 0, xy = 0, yy = 0, width = 0;
    for (const auto& [row, profile] : rows) {
        const Across a = across(profile);
        const double h = -row * 2 * points.half;
        n += 1, x += a.x, y += h, xy += a.x * h, yy += h * h, width += a.width;
    }
    const double angle = std::atan((n * xy - x * y) / (n * yy - y * y));
    fmt::print(" width {:.3f} angle {:5.1f}", width / n * std::cos(angle), angle / kDegrees);
}

struct Energy {
    double kinetic = 0, height = 0;
};
Energy energy(const mpm::Points& p) {
    Energy e;
    for (std::size_t k = 0; k < p.size(); ++k) {
        e.kinetic += 0.5 * p.mass[k] * (p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k]);
        e.height += 9.81 * p.mass[k] * p.y[k];
    }
    return e;
}

void run(const std::string& length, double shear, int cells, std::vector<std::string> set) {
    set.push_back(fmt::format("domain.cell={:.17g} m", 1.0 / cells));
    set.push_back("ground.internal_length=" + length + " m");
    const scene::Scene scene = scene::parse_scene(kScene, "band", set);
    const Sand sand = make(scene, shear);
    simulation::Simulation& model = *sand.model;
    const double start = energy(model.state().points).height, end = scene.anchor.pull_to;
    double peak = 0, work = 0, steps = 0;
    std::array<double, 3> at = {0.05, 0.1, 0.2}, sum{}, count{};
    const auto clock = std::chrono::steady_clock::now();
    while (model.d_over_B() < end) {
        const double before = model.d_over_B();
        model.step(), ++steps;
        const double N = model.load() / sand.unit, d = model.d_over_B();
        work += model.load() * (d - before), peak = std::max(peak, N);
        for (std::size_t k = 0; k < 3; ++k)
            if (std::fabs(d - at[k]) < 0.01) sum[k] += N, count[k] += 1;
    }
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
    const Energy last = energy(model.state().points);
    fmt::print("l {} B/h {:2} peak {:.3f} N(0.05) {:.3f} N(0.1) {:.3f} N(0.2) {:.3f}", length, cells, peak,
               sum[0] / count[0], sum[1] / count[1], sum[2] / count[2]);
    tell_band(sand);
    fmt::print(" lost {:.1f} % us a step {:.0f}\n",
               100 * (work - model.state().stress_work - (last.height - start) - last.kinetic) / work,
               1e6 * wall / steps);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return fmt::print(stderr, "bench_band_width LENGTH_IN_B SHEAR CELLS_A_WIDTH...\n"), 2;
    std::vector<std::string> set;
    int last = 3;
    while (last < argc && std::strcmp(argv[last], "--") != 0) ++last;
    for (int k = last + 1; k < argc; ++k) set.emplace_back(argv[k]);
    for (int k = 3; k < last; ++k) run(argv[1], std::atof(argv[2]), std::atoi(argv[k]), set);
}
