#include "simulation/region_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/console.hpp"
#include "base/error.hpp"
#include "dem/rve.hpp"
#include "io/packing_file.hpp"
#include "mpm/kinematics.hpp"
#include "simulation/make_frame.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kReached = 1e-9;  // slack on d/B marks and edges

// A region in the domain's coordinates [m].
mpm::Rectangle place_of(const scene::Scene& scene, const scene::Region& r,
                        const std::vector<graph::Body>& bodies) {
    if (r.absolute) return {r.x[0], r.y[0], r.x[1], r.y[1]};
    if (bodies.empty())
        throw InputError({scene.file}, fmt::format("[[region]] {} in plate widths", r.name),
                         "there is no plate (anchor.present = false)",
                         "give its place in metres: x = [\"1 m\", \"2 m\"]");
    const mpm::RigidPlate& plate = bodies.front().plate;
    const double B = scene.anchor.width;
    return {plate.x + B * r.x[0], plate.y + B * r.y[0], plate.x + B * r.x[1], plate.y + B * r.y[1]};
}

std::size_t nearest(const mpm::Points& points, double x, double y) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double distance = std::hypot(points.x[p] - x, points.y[p] - y);
        if (distance < least - kReached) least = distance, best = p;
    }
    return best;
}

std::vector<std::size_t> inside(const mpm::Points& points, const mpm::Rectangle& place) {
    std::vector<std::size_t> found;
    for (std::size_t p = 0; p < points.size(); ++p)
        if (inflated(place, kReached).contains(points.x[p], points.y[p])) found.push_back(p);
    return found;
}

class SpreadSum {
  public:
    void add(double value) {
        sum_ += value, ++count_;
        low_ = std::min(low_, value), high_ = std::max(high_, value);
    }
    io::Spread spread() const { return count_ ? io::Spread{sum_ / count_, low_, high_} : io::Spread{}; }

  private:
    double sum_ = 0, low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
    int count_ = 0;
};

template <class Value>
io::Spread spread(const std::vector<std::size_t>& points, Value value) {
    SpreadSum sum;
    for (const std::size_t p : points) sum.add(value(p));
    return sum.spread();
}

double ratio(double sigma_xx, double sigma_yy) {
    return sigma_yy > 0 ? sigma_xx / sigma_yy : io::Spread::unknown;
}

io::Spread lateral_pressure(const std::vector<std::size_t>& points, const std::vector<Stress>& stress,
                            const io::RegionRow& row) {
    SpreadSum sum;
    for (const std::size_t p : points)
        if (const double K = ratio(-stress[p].xx, -stress[p].yy); std::isfinite(K)) sum.add(K);
    io::Spread out = sum.spread();
    out.mean = ratio(row.sigma_xx.mean, row.sigma_yy.mean);
    return out;
}

// Of full fidelity only: in a screening run few points have a packing of their own.
void add_packings(const graph::GroundState& s, const dem::Material& material,
                  const std::vector<std::size_t>& points, io::RegionRow& row) {
    SpreadSum anisotropy, coordination;
    for (const std::size_t p : points) {
        if (s.law->answers() != stress::Answers::grains) break;
        const dem::Observables seen = dem::observe(*s.law->observe(p).packing, material);
        anisotropy.add(seen.anisotropy), coordination.add(seen.coordination);
    }
    row.anisotropy = anisotropy.spread(), row.coordination = coordination.spread();
}

// 0020 for 0.02, 0000.4 for 0.0004.
std::string thousandths(double mark) {
    const double value = std::round(1e4 * mark) / 10;
    return value == std::round(value) ? fmt::format("{:04.0f}", value) : fmt::format("{:06.1f}", value);
}

std::string moment(const Simulation& simulation, double mark) {
    return simulation.anchored() ? fmt::format("d/B = {:.6g}", mark) : fmt::format("t = {:.6g} s", mark);
}

}  // namespace

RegionRecorder::RegionRecorder(const scene::Scene& scene, const Simulation& simulation,
                               double initial_porosity)
    : material_(scene.ground.grains.material), initial_porosity_(initial_porosity) {
    std::vector<scene::Region> asked = scene.regions;
    std::ranges::sort(asked, {}, &scene::Region::name);
    const graph::GroundState& s = simulation.state();
    for (const scene::Region& region : asked) {
        const mpm::Rectangle place = place_of(scene, region, s.bodies);
        const std::size_t middle =
            nearest(s.points, 0.5 * (place.x0 + place.x1), 0.5 * (place.y0 + place.y1));
        Members members{inside(s.points, place), middle, region.packings};
        if (region.tracked_point) members.points = {middle};
        if (members.points.empty())
            throw InputError({scene.file}, fmt::format("[[region]] {} holds no material point", region.name),
                             fmt::format("it reaches from ({:.4g}, {:.4g}) to ({:.4g}, {:.4g}) m", place.x0,
                                         place.y0, place.x1, place.y1),
                             "move it into the ground, or give a place with at = [x, y]");
        regions_.push_back({region.name, static_cast<int>(members.points.size()), {}});
        members_.push_back(std::move(members));
    }
}

std::vector<io::RegionRow> RegionRecorder::rows(const Simulation& simulation) const {
    std::vector<io::RegionRow> out;
    for (const Members& members : members_) out.push_back(row(simulation, members));
    return out;
}

io::RegionRow RegionRecorder::row(const Simulation& simulation, const Members& members) const {
    const mpm::Points& g = simulation.state().points;
    const auto of = [&](auto value) { return spread(members.points, value); };
    io::RegionRow row;
    row.d_over_B = simulation.d_over_B(), row.time = simulation.time();
    row.p = of([&](std::size_t p) { return mean_stress(g.stress[p]); });
    row.q = of([&](std::size_t p) { return deviator(g.stress[p]); });
    row.sigma_xx = of([&](std::size_t p) { return -g.stress[p].xx; });
    row.sigma_yy = of([&](std::size_t p) { return -g.stress[p].yy; });
    row.sigma_xy = of([&](std::size_t p) { return -g.stress[p].xy; });
    row.K = lateral_pressure(members.points, g.stress, row);
    row.porosity =
        of([&](std::size_t p) { return point_porosity(simulation.state(), p, initial_porosity_); });
    row.strain = of([&](std::size_t p) { return mpm::equivalent_strain(g.F[p]); });
    row.volume_strain = of([&](std::size_t p) { return mpm::volumetric_strain(g.F[p]); });
    row.rotation = of([&](std::size_t p) { return mpm::rotation(g.F[p]); });
    row.x = of([&](std::size_t p) { return g.x[p]; });
    row.y = of([&](std::size_t p) { return g.y[p]; });
    add_packings(simulation.state(), material_, members.points, row);
    return row;
}

void RegionRecorder::keep_packings(const Simulation& simulation, const std::filesystem::path& folder,
                                   BackgroundWriter& writer) {
    const double now = simulation.mark();
    for (std::size_t k = 0; k < members_.size(); ++k)
        for (const double mark : members_[k].packings)
            if (passed(mark, now)) keep(simulation, k, mark, folder, writer);
    kept_to_ = now;
}

bool RegionRecorder::passed(double mark, double now) const {
    return mark > kept_to_ + kReached && mark <= now + kReached;
}

bool RegionRecorder::keeps_by(double mark) const {
    return std::ranges::any_of(members_, [&](const Members& m) {
        return std::ranges::any_of(m.packings, [&](double kept) { return passed(kept, mark); });
    });
}

void RegionRecorder::keep(const Simulation& simulation, std::size_t region, double mark,
                          const std::filesystem::path& folder, BackgroundWriter& writer) const {
    const std::size_t point = members_[region].middle;
    // None where a surrogate or a formula answers.
    const dem::Rve* packing = simulation.state().law->observe(point).packing;
    if (!packing)
        return notice(fmt::format("[[region]] {}: no packing at {}, no grains answer there",
                                  regions_[region].name, moment(simulation, mark)));
    auto record = std::make_shared<io::PackingRecord>();
    record->packing = dem::lab_packing(*packing), record->material = material_;
    record->recipe = fmt::format("# point {} of region {} at {}\n", point, regions_[region].name,
                                 moment(simulation, simulation.mark()));
    const auto path = folder / "packings" / fmt::format("{}_{}.h5", regions_[region].name, thousandths(mark));
    writer.post([record, path] {
        std::filesystem::create_directory(path.parent_path());  // not the run folder: that may be gone
        io::write_packing(path, *record);
    });
}

}  // namespace sandgraph::simulation
