#include "results/field_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "graph/screening/modes.hpp"
#include "mpm/kinematics.hpp"

namespace sandgraph::results {
namespace {

template <class Measure>
std::vector<double> from_gradient(const io::Frame& frame, Measure&& measure) {
    const io::Field& F = field(frame, "F", 4);
    std::vector<double> values(frame.x.size());
    for (std::size_t p = 0; p < values.size(); ++p) values[p] = measure(deformation_gradient(F, p));
    return values;
}

std::vector<double> magnitudes(const io::Frame& frame) {
    const io::Field& u = field(frame, "displacement", 2);
    std::vector<double> values(frame.x.size());
    for (std::size_t p = 0; p < values.size(); ++p)
        values[p] = std::hypot(u.values[2 * p], u.values[2 * p + 1]);
    return values;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

const io::Field* find(const io::Frame& frame, const std::string& name) {
    const auto same = [&](const io::Field& f) { return f.name == name; };
    const auto it = std::find_if(frame.fields.begin(), frame.fields.end(), same);
    return it == frame.fields.end() ? nullptr : &*it;
}

std::vector<std::string> mode_words() {
    std::vector<std::string> words(graph::mode_names.begin(), graph::mode_names.end());
    for (std::string& word : words) std::ranges::replace(word, '_', ' ');
    return words;
}

}  // namespace

bool has_field(const io::Frame& frame, const std::string& name) { return find(frame, name) != nullptr; }

const io::Field& field(const io::Frame& frame, const std::string& name, int components) {
    const io::Field* found = find(frame, name);
    const std::string where = fmt::format("frame at d/B = {}", frame.d_over_B);
    if (!found)
        throw InputError({where}, fmt::format("no field '{}'", name), "the picture is made from it",
                         "write it");
    if (found->components != components || found->values.size() != components * frame.x.size())
        throw InputError({where}, fmt::format("field '{}' has {} components", name, found->components),
                         fmt::format("{} expected", components), "write it again");
    return *found;
}

Mat2 deformation_gradient(const io::Field& F, std::size_t point) {
    const double* f = F.values.data() + 4 * point;
    return (Mat2() << f[0], f[1], f[2], f[3]).finished();
}

PointValues point_values(const io::Frame& frame, Quantity quantity) {
    switch (quantity) {
        case Quantity::displacement:
            return {"displacement", "m", false, magnitudes(frame)};
        case Quantity::equivalent_strain:
            return {"equivalent strain ε_{eq}", "-", false, from_gradient(frame, mpm::equivalent_strain)};
        case Quantity::rotation:
            return {"rotation θ, anticlockwise +", "deg", true,
                    from_gradient(frame, [](const Mat2& F) { return degrees(mpm::rotation(F)); })};
        case Quantity::mode:
            return {"constitutive mode", "-", false, field(frame, "mode", 1).values, mode_words()};
        case Quantity::porosity:
            break;
    }
    return {"porosity n", "-", false, field(frame, "porosity", 1).values};
}

}  // namespace sandgraph::results
