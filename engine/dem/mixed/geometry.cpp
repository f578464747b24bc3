#include "dem/mixed/geometry.hpp"

namespace sandgraph::dem {
namespace {

constexpr double kPeriod = 4294967296.0;  // units of a coordinate

}  // namespace

NearestImage nearest_image(const MixedPacking& p, int i, int j) {
    const auto image = [](std::int32_t from, std::int32_t to, std::int32_t& branch) {
        const auto a = static_cast<std::uint32_t>(from), b = static_cast<std::uint32_t>(to);
        branch = static_cast<std::int32_t>(b - a);
        return static_cast<std::int16_t>((std::int64_t{branch} - (std::int64_t{b} - std::int64_t{a})) >> 32);
    };
    NearestImage out{};
    out.cell_x = image(p.x[i], p.x[j], out.x), out.cell_y = image(p.y[i], p.y[j], out.y);
    return out;
}

Vec2 centre(const MixedPacking& p, int g) {
    const auto share = [](std::int32_t units) { return static_cast<std::uint32_t>(units) / kPeriod; };
    return p.H * Vec2(share(p.x[g]), share(p.y[g]));
}

Vec2 branch(const MixedPacking& p, const NearestImage& image) {
    return p.H * (Vec2(image.x, image.y) / kPeriod);
}

}  // namespace sandgraph::dem
