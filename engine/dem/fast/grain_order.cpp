#include "dem/fast/grain_order.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/contracts.hpp"

namespace sandgraph::dem {
namespace {

std::vector<double> picked(const std::vector<double>& values, const std::vector<int>& order) {
    std::vector<double> out;
    if (values.empty()) return out;
    out.reserve(order.size());
    for (const int g : order) out.push_back(values[g]);
    return out;
}

double fraction(double s) { return s - std::floor(s); }

}  // namespace

std::vector<int> strip_order(const Packing& p) {
    const Mat2 inverse = p.H.inverse();
    const double strips = std::max(1.0, std::floor(std::sqrt(static_cast<double>(p.size()))));
    std::vector<std::pair<double, double>> place(p.size());
    for (std::size_t g = 0; g < p.size(); ++g) {
        const Vec2 s = inverse * Vec2(p.x[g], p.y[g]);
        place[g] = {std::floor(fraction(s.x()) * strips), fraction(s.y())};
    }
    std::vector<int> order(p.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place[a] < place[b]; });
    SG_ENSURE(distinct_below(order, p.size()));
    return order;
}

std::vector<int> inverse_order(const std::vector<int>& order) {
    SG_EXPECT(distinct_below(order, order.size()));
    std::vector<int> out(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) out[order[k]] = static_cast<int>(k);
    return out;
}

Packing reordered(const Packing& p, const std::vector<int>& order) {
    SG_EXPECT(order.size() == p.size());
    const std::vector<int> place = inverse_order(order);
    Packing out = p;
    out.x = picked(p.x, order), out.y = picked(p.y, order), out.r = picked(p.r, order);
    out.vx = picked(p.vx, order), out.vy = picked(p.vy, order), out.spin = picked(p.spin, order);
    for (Contact& c : out.contacts) c.i = place[c.i], c.j = place[c.j];
    return out;
}

}  // namespace sandgraph::dem
