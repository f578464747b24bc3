#include "simulation/caveats.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "simulation/scene_spec.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kSuspectRate = 0.5;  // a load 2 to 3 % too high
constexpr double kFewestCells = 10;   // a plate width
constexpr double kFewestCellsOfBand = 2;
constexpr double kFewestGrains = 200;  // the angle of smaller packings scatters by 5 deg and more
constexpr double kSlack = 1e-6;        // for ratios that round-off moved

using Lines = std::vector<std::string>;

void add(Lines& out, bool doubtful, const std::string& line) {
    if (doubtful) out.push_back(line);
}

// Of a length of one cell the grid's own width is nearly all.
void add_band_width(const scene::Scene& s, Lines& out) {
    const double length = s.ground.internal_length, cells = length / s.domain.cell;
    add(out, length > 0 && cells < kFewestCellsOfBand - kSlack,
        fmt::format("ground.internal_length = {:.4g} m is {:.2g} cells: bands still hang on the mesh; take "
                    "domain.cell = {:.3g} m or less",
                    length, cells, length / kFewestCellsOfBand));
}

double rounded_up(double length, double cell) { return cell * std::ceil(length / cell - kSlack); }

// The block over a plate widens by phi on each side; with a wall inside it a side of the block carries
// nothing: at H/B = 4 and phi = 30 deg a domain 0.7 times as wide as the block loses 11 % of the load.
void horizontal_room(const scene::Scene& s, double phi, Lines& out) {
    const double reach = 0.5 * s.anchor.width + embedment(s.anchor) * std::tan(phi);
    add(out, s.domain.width < reach - kSlack,
        fmt::format(
            "domain.width = {:.4g} m cuts the failure off: at phi = {:.1f} deg it reaches {:.3g} m from the "
            "middle of the plate, and the load comes out low; take {:.4g} m or more",
            s.domain.width, phi * kDegrees, reach, rounded_up(reach, s.domain.cell)));
}

// Ahead a passive wedge of 45 + phi/2 to the vertical, behind an active one of 45 - phi/2.
void vertical_room(const scene::Scene& s, double phi, Lines& out) {
    const double H = embedment(s.anchor), half = 0.5 * s.anchor.thickness;
    const double ahead = H * std::tan(std::numbers::pi / 4 + phi / 2),
                 behind = H * std::tan(std::numbers::pi / 4 - phi / 2);
    const double needed = s.anchor.position + half + s.anchor.pull_to * s.anchor.width + ahead;
    add(out, s.domain.width < needed - kSlack,
        fmt::format("domain.width = {:.4g} m cuts the wedge ahead of the plate off: at phi = {:.1f} deg it "
                    "is {:.3g} m "
                    "long at the surface, and the load comes out wrong; take {:.4g} m or more",
                    s.domain.width, phi * kDegrees, ahead, rounded_up(needed, s.domain.cell)));
    add(out, s.anchor.position - half < behind - kSlack,
        fmt::format("anchor.position = {:.4g} m leaves too little ground behind the plate: the sand that "
                    "follows it comes "
                    "from {:.3g} m; take {:.4g} m or more",
                    s.anchor.position, behind, behind + half));
}

void add_cells(const scene::Scene& s, Lines& out) {
    const double cells = s.anchor.width / s.domain.cell;
    add(out, cells < kFewestCells - kSlack,
        fmt::format("{:.3g} cells a plate width: bands and loads past the peak are coarse with fewer than "
                    "{:g}; take domain.cell = {:.3g} m or less",
                    cells, kFewestCells, s.anchor.width / kFewestCells));
}

}  // namespace

double wave_load(const scene::Scene& scene, const packings::PreparedGround& ground,
                 const Simulation& simulation) {
    const double inertia = ground.density * scene.mpm.mass_scaling;
    const double impedance = std::sqrt(inertia * simulation.state().law->p_wave_modulus());
    return impedance * scene.anchor.pull_rate * scene.anchor.width;
}

double rate_share(const scene::Scene& scene, const packings::PreparedGround& ground,
                  const Simulation& simulation) {
    return wave_load(scene, ground, simulation) / unit_load(scene, ground);
}

Lines caveats(const scene::Scene& s, const packings::PreparedGround& ground, const Simulation& simulation) {
    Lines out;
    add_band_width(s, out);
    if (!s.loaded()) return out;
    add_cells(s, out);
    if (!s.anchor.present) return out;
    const bool horizontal = s.anchor.orientation == scene::Orientation::horizontal;
    if (ground.friction.mean > 0)
        (horizontal ? horizontal_room : vertical_room)(s, ground.friction.mean, out);
    const double rate = rate_share(s, ground, simulation);
    add(out, rate > kSuspectRate,
        fmt::format("anchor.pull_rate = {:.3g} m/s is fast here: the wave pressure rho c v is {:.2g} times "
                    "that on the "
                    "plate, and the load comes out some {:.0f} % high or more; take {:.2g} m/s or less",
                    s.anchor.pull_rate, rate, 5 * rate, s.anchor.pull_rate * kSuspectRate / rate));
    const auto& grains = ground.packings;
    const std::size_t count = grains.empty() ? 0 : grains.front().packing->grains->radius.size();
    add(out, count > 0 && static_cast<double>(count) < kFewestGrains,
        fmt::format("packings of {} grains: their strength scatters by several degrees; take grains.count = "
                    "{:g} or more",
                    count, kFewestGrains));
    return out;
}

}  // namespace sandgraph::simulation
