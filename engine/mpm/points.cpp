#include "mpm/points.hpp"

#include <algorithm>
#include <string>

namespace sandgraph::mpm {
namespace {

// Tensors travel as flat arrays, point-major: xx, yx, xy, yy (columns) or xx, yy, xy (stress).
void archive(Archive& a, const std::string& name, std::vector<Mat2>& values) {
    std::vector<double> flat;
    for (const Mat2& m : values) flat.insert(flat.end(), m.data(), m.data() + 4);
    a.field(name, flat);
    if (!a.reading()) return;
    values.resize(flat.size() / 4);
    for (std::size_t p = 0; p < values.size(); ++p) std::copy_n(flat.data() + 4 * p, 4, values[p].data());
}

void archive(Archive& a, const std::string& name, std::vector<Stress>& values) {
    std::vector<double> flat;
    for (const Stress& s : values) flat.insert(flat.end(), {s.xx, s.yy, s.xy});
    a.field(name, flat);
    if (!a.reading()) return;
    values.resize(flat.size() / 3);
    for (std::size_t p = 0; p < values.size(); ++p)
        values[p] = {flat[3 * p], flat[3 * p + 1], flat[3 * p + 2]};
}

void archive(Archive& a, const std::string& name, std::vector<std::int32_t>& values) {
    std::vector<std::int64_t> wide(values.begin(), values.end());
    a.field(name, wide);
    values.resize(wide.size());
    std::transform(wide.begin(), wide.end(), values.begin(),
                   [](auto v) { return static_cast<std::int32_t>(v); });
}

}  // namespace

void resize(Points& points, std::size_t count) {
    for (auto* field :
         {&points.x, &points.y, &points.vx, &points.vy, &points.mass, &points.volume0, &points.volume})
        field->resize(count);
    points.F.resize(count, Mat2::Identity());
    points.F_inc.resize(count, Mat2::Identity());
    points.stress.resize(count);
    points.row.resize(count);
}

void archive(Archive& a, Points& points) {
    std::vector<double> half{points.half};
    a.field("points/half", half);
    points.half = half.at(0);
    a.field("points/x", points.x);
    a.field("points/y", points.y);
    a.field("points/vx", points.vx);
    a.field("points/vy", points.vy);
    a.field("points/mass", points.mass);
    a.field("points/volume0", points.volume0);
    a.field("points/volume", points.volume);
    archive(a, "points/F", points.F);
    archive(a, "points/F_inc", points.F_inc);
    archive(a, "points/stress", points.stress);
    archive(a, "points/row", points.row);
    archive(a, "points/surface", points.surface);
}

}  // namespace sandgraph::mpm
