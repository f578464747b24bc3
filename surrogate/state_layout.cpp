#include "surrogate/state_layout.hpp"

#include "base/contracts.hpp"

namespace sandgraph::surrogate {
namespace {

MemberState unpack_member(std::size_t M, std::span<const double> v) {
    MemberState m{v[0], v[1], v[2], {}};
    for (std::size_t k = 0; k < M; ++k) m.elements.emplace_back(v[3 + k], v[3 + M + k]);
    return m;
}

void pack_member(const MemberState& m, std::span<double> v) {
    const std::size_t M = m.elements.size();
    v[0] = m.p;
    v[1] = m.gamma;
    v[2] = m.strength_scale;
    for (std::size_t k = 0; k < M; ++k) {
        v[3 + k] = m.elements[k].real();
        v[3 + M + k] = m.elements[k].imag();
    }
}

}  // namespace

PointState unpack(const StateLayout& layout, std::span<const double> v) {
    SG_EXPECT(v.size() == layout.size());
    const auto c = v.subspan(layout.constants);
    PointState point{
        v[layout.volume], {v[layout.fabric], v[layout.fabric + 1]}, {c[0], c[1], c[2], c[3], c[4], c[5]}, {}};
    for (std::size_t m = 0; m < layout.members; ++m)
        point.members.push_back(
            unpack_member(layout.elements, v.subspan(layout.member(m), layout.member_size())));
    return point;
}

void pack(const StateLayout& layout, const PointState& point, std::span<double> v) {
    SG_EXPECT(v.size() == layout.size() && point.members.size() == layout.members);
    std::fill(v.begin(), v.end(), 0.0);
    v[layout.volume] = point.volume;
    v[layout.fabric] = point.fabric.real();
    v[layout.fabric + 1] = point.fabric.imag();
    const PointConstants& c = point.constants;
    const double constants[] = {c.pressure, c.void_ratio, c.bulk, c.shear, c.coordination, c.peak_friction};
    std::copy(std::begin(constants), std::end(constants), v.subspan(layout.constants).begin());
    for (std::size_t m = 0; m < layout.members; ++m)
        pack_member(point.members[m], v.subspan(layout.member(m), layout.member_size()));
}

}  // namespace sandgraph::surrogate
