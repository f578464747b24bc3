#include "mpm/points.hpp"

#include <algorithm>
#include <string>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

// Tensors travel as flat arrays, point-major: xx, yx, xy, yy (columns) or xx, yy, xy (stress).
void archive(Archive& a, const std::string& name, std::vector<Mat2>& values) {
    std::vector<double> flat;
    for (const Mat2& m : values) flat.insert(flat.end(), m.data(), m.data() + 4);
    field_of_known_length(a, name, flat);
    if (!a.reading()) return;
    for (std::size_t p = 0; p < values.size(); ++p) std::copy_n(flat.data() + 4 * p, 4, values[p].data());
}

void archive(Archive& a, const std::string& name, std::vector<Stress>& values) {
    std::vector<double> flat;
    for (const Stress& s : values) flat.insert(flat.end(), {s.xx, s.yy, s.xy});
    field_of_known_length(a, name, flat);
    if (!a.reading()) return;
    for (std::size_t p = 0; p < values.size(); ++p)
        values[p] = {flat[3 * p], flat[3 * p + 1], flat[3 * p + 2]};
}

// Indices that the scene gives: they are kept to tell another ground.
void confirm(Archive& a, const std::string& name, const std::vector<std::int32_t>& values) {
    const std::vector<std::int64_t> wide(values.begin(), values.end());
    std::vector<std::int64_t> read = wide;
    a.field(name, read);
    require_state(read == wide, name.c_str());
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
    points.cut.resize(count);
    SG_ENSURE(points.size() == count && points.F.size() == count && points.stress.size() == count);
}

void archive(Archive& a, Points& points) {
    std::vector<double> half{points.half};
    field_of_known_length(a, "points/half", half);
    points.half = half.front();
    field_of_known_length(a, "points/x", points.x);
    field_of_known_length(a, "points/y", points.y);
    field_of_known_length(a, "points/vx", points.vx);
    field_of_known_length(a, "points/vy", points.vy);
    field_of_known_length(a, "points/mass", points.mass);
    field_of_known_length(a, "points/volume0", points.volume0);
    field_of_known_length(a, "points/volume", points.volume);
    archive(a, "points/F", points.F);
    archive(a, "points/F_inc", points.F_inc);
    archive(a, "points/stress", points.stress);
    confirm(a, "points/row", points.row);
    confirm(a, "points/surface", points.surface);
    confirm(a, "points/cut", points.cut);
}

}  // namespace sandgraph::mpm
