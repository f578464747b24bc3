#include "results/failure_pattern.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mpm/kinematics.hpp"
#include "results/field_values.hpp"

namespace sandgraph::results {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double edge_share = 0.1;     // of d: what counts as a rise of the surface
constexpr double visible_rise = 0.01;  // [B]
constexpr double strained = 0.1;       // eps_eq
constexpr double edge_strain = 0.2;    // eps_eq of the outer edge near the surface
constexpr double faint_strain = 0.1;
constexpr double not_exceeded = 0.95;  // share of the points, of their rotation
constexpr double band_reach = 0.3;     // [B] about a row's largest strain
constexpr double band_share = 0.5;     // of a row's largest strain
constexpr std::size_t fewest_rows = 3;
constexpr int cavity_bins = 10;  // per point across

struct Line {
    double x, y;
};

double travel(const io::Frame& frame, const GroundView& view) { return frame.d_over_B * view.anchor_width; }

// Slope dx/dy of the least-squares line through part of the band.
double angle_of(std::vector<Line>::const_iterator begin, std::vector<Line>::const_iterator end) {
    const auto n = static_cast<double>(end - begin);
    if (n < fewest_rows) return nan;
    double x = 0, y = 0, xy = 0, yy = 0;
    for (auto k = begin; k != end; ++k) x += k->x / n, y += k->y / n;
    for (auto k = begin; k != end; ++k) xy += (k->x - x) * (k->y - y), yy += (k->y - y) * (k->y - y);
    return std::atan2(yy, xy) * 180 / std::numbers::pi;
}

std::vector<Mat2> deformation_between(const io::Frame& early, const io::Frame& late) {
    const io::Field &before = field(early, "F", 4), &after = field(late, "F", 4);
    std::vector<Mat2> F(late.x.size());
    for (std::size_t p = 0; p < F.size(); ++p)
        F[p] = deformation_gradient(after, p) * deformation_gradient(before, p).inverse();
    return F;
}

using Row = std::vector<std::size_t>;

// The points of a row that belong to the band; none without strain.
Row band_in_row(const Row& row, const io::Frame& frame, const std::vector<double>& strain, double window) {
    double largest = 0, at = 0;
    for (const std::size_t p : row)
        if (strain[p] > largest) largest = strain[p], at = frame.x[p];
    Row band;
    for (const std::size_t p : row)
        if (largest > 0 && strain[p] >= band_share * largest && std::abs(frame.x[p] - at) <= window)
            band.push_back(p);
    return band;
}

std::vector<Row> band_rows(const io::Frame& frame, const std::vector<double>& strain,
                           const GroundView& view) {
    const double low = frame.plate_y + view.plate_size_y / 2, size = view.point_size;
    const auto rows = static_cast<std::size_t>(std::max(0.0, std::floor((view.surface - low) / size)));
    std::vector<Row> points(rows);
    for (std::size_t p = 0; p < frame.x.size(); ++p) {
        const double row = std::floor((frame.y[p] - low) / size);
        if (row >= 0 && row < static_cast<double>(rows) && frame.x[p] > 0 && std::isfinite(strain[p]))
            points[static_cast<std::size_t>(row)].push_back(p);
    }
    for (Row& row : points) row = band_in_row(row, frame, strain, band_reach * view.anchor_width);
    return points;
}

std::vector<Line> band_line(const std::vector<Row>& rows, const io::Frame& frame,
                            const std::vector<double>& strain, const GroundView& view) {
    const double low = frame.plate_y + view.plate_size_y / 2;
    std::vector<Line> line;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        double sum = 0, weight = 0;
        for (const std::size_t p : rows[k]) sum += strain[p] * frame.x[p], weight += strain[p];
        if (weight > 0)
            line.push_back({sum / weight, low + (static_cast<double>(k) + 0.5) * view.point_size});
    }
    return line;
}

double dilation_angle(const std::vector<Row>& rows, const std::vector<Mat2>& F) {
    double expansion = 0, shear = 0;
    for (const Row& row : rows)
        for (const std::size_t p : row) {
            const Mat2 e = mpm::logarithmic_strain(F[p]);
            expansion += e.trace(), shear += 2 * std::hypot((e(0, 0) - e(1, 1)) / 2, e(0, 1));
        }
    return shear > 0 ? std::asin(std::clamp(expansion / shear, -1.0, 1.0)) * 180 / std::numbers::pi : nan;
}

// Outermost point of each row in the uppermost half width that is strained past `least`.
std::vector<Line> outer_edge(const io::Frame& frame, const std::vector<double>& strain, double least,
                             const GroundView& view) {
    const double size = view.point_size;
    const auto rows = static_cast<std::size_t>(std::lround(0.5 * view.anchor_width / size));
    std::vector<Line> line;
    for (std::size_t k = 0; k < rows; ++k) {
        const double top = view.surface - static_cast<double>(k) * size;
        double outermost = nan;
        for (std::size_t p = 0; p < frame.x.size(); ++p)
            if (frame.y[p] <= top && frame.y[p] > top - size && strain[p] >= least && frame.x[p] > 0)
                outermost = std::isnan(outermost) ? frame.x[p] : std::max(outermost, frame.x[p]);
        if (std::isfinite(outermost)) line.push_back({outermost, top - 0.5 * size});
    }
    return line;
}

}  // namespace

SurfaceShape surface_shape(const io::Frame& frame, const GroundView& view) {
    const io::Field& u = field(frame, "displacement", 2);
    const double d = travel(frame, view), B = view.anchor_width;
    const double start = view.mirror ? 0 : frame.plate_x - d;
    SurfaceShape shape;
    if (d <= 0) return shape;
    for (std::size_t p = 0; p < frame.x.size(); ++p) {
        if (frame.y[p] - u.values[2 * p + 1] < view.surface - view.point_size) continue;
        const double x = frame.x[p] - start, rise = u.values[2 * p + 1] / d;
        shape.highest = std::max(shape.highest, rise), shape.lowest = std::min(shape.lowest, rise);
        if (u.values[2 * p + 1] >= visible_rise * B)
            shape.visible_ahead = std::max(shape.visible_ahead, x / B);
        if (rise >= edge_share) shape.heave_ahead = std::max(shape.heave_ahead, x / B);
        if (rise <= -edge_share) shape.sink_behind = std::max(shape.sink_behind, -x / B);
    }
    return shape;
}

StrainedZone strained_zone(const io::Frame& frame, const GroundView& view) {
    const io::Field& F = field(frame, "F", 4);
    StrainedZone zone;
    for (std::size_t p = 0; p < frame.x.size(); ++p) {
        if (!(mpm::equivalent_strain(deformation_gradient(F, p)) >= strained)) continue;
        const double x = (frame.x[p] - frame.plate_x) / view.anchor_width;
        const double y = (frame.y[p] - frame.plate_y) / view.anchor_width;
        zone.ahead = std::max(zone.ahead, x), zone.behind = std::max(zone.behind, view.mirror ? x : -x);
        zone.above = std::max(zone.above, y), zone.below = std::max(zone.below, -y);
    }
    return zone;
}

double cavity_share(const io::Frame& frame, const GroundView& view) {
    const double d = travel(frame, view), top = frame.plate_y - view.plate_size_y / 2;
    const double bin = view.point_size / cavity_bins, half = view.point_size / 2;
    const auto across = static_cast<int>(std::lround(view.plate_size_x / 2 / bin));
    const int down = static_cast<int>(std::lround(d / bin));
    if (across == 0 || down == 0) return 0;
    std::vector<bool> covered(static_cast<std::size_t>(across * down));
    for (std::size_t p = 0; p < frame.x.size(); ++p) {
        const auto cell = [&](double at) { return static_cast<int>(std::floor(at / bin + 0.5)); };
        const int i0 = std::max(0, cell(frame.x[p] - half)), i1 = std::min(across, cell(frame.x[p] + half));
        const int j0 = std::max(0, cell(top - frame.y[p] - half)),
                  j1 = std::min(down, cell(top - frame.y[p] + half));
        for (int i = i0; i < i1; ++i)
            for (int j = j0; j < j1; ++j) covered[static_cast<std::size_t>(i * down + j)] = true;
    }
    const auto empty = std::count(covered.begin(), covered.end(), false);
    return static_cast<double>(empty) / static_cast<double>(covered.size());
}

ShearBand shear_band(const io::Frame& early, const io::Frame& late, const GroundView& view) {
    const std::vector<Mat2> F = deformation_between(early, late);
    std::vector<double> strain(F.size());
    std::ranges::transform(F, strain.begin(), mpm::equivalent_strain);
    const std::vector<Row> rows = band_rows(late, strain, view);
    const std::vector<Line> line = band_line(rows, late, strain, view);
    const auto at = [&](std::size_t third) {
        return line.begin() + static_cast<std::ptrdiff_t>(third * line.size() / 3);
    };
    const auto edge = [&](double least) {
        const std::vector<Line> outer = outer_edge(late, strain, least, view);
        return angle_of(outer.begin(), outer.end());
    };
    const double surface = line.empty() ? nan : line.back().x / view.anchor_width;
    return {angle_of(at(0), at(1)), angle_of(at(1), at(2)), angle_of(at(2), line.end()), surface,
            edge(edge_strain),      edge(faint_strain),     dilation_angle(rows, F)};
}

double band_rotation(const io::Frame& frame, const GroundView& view) {
    const io::Field& F = field(frame, "F", 4);
    std::vector<double> turned;
    for (std::size_t p = 0; p < frame.x.size(); ++p)
        if (const Mat2 f = deformation_gradient(F, p);
            frame.y[p] > frame.plate_y + view.plate_size_y / 2 && mpm::equivalent_strain(f) >= edge_strain)
            turned.push_back(std::abs(mpm::rotation(f)) * 180 / std::numbers::pi);
    if (turned.empty()) return nan;
    const auto at = turned.begin() + static_cast<std::ptrdiff_t>(not_exceeded * (turned.size() - 1));
    std::nth_element(turned.begin(), at, turned.end());
    return *at;
}

}  // namespace sandgraph::results
