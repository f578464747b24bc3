#include "io/packing_valid.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "dem/packing/check.hpp"

namespace sandgraph::io {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& problem, const std::string& why) {
    throw InputError({file}, problem, why, "make the packing again with 'sandgraph rve prepare'");
}

void check_length(const std::string& file, const char* name, std::size_t length, std::size_t grains) {
    if (length != grains)
        refuse(file, fmt::format("/grains/{} has {} entries", name, length),
               fmt::format("/grains/x has {}", grains));
}

void check_velocity(const std::string& file, const char* name, const std::vector<double>& v,
                    std::size_t grains) {
    if (v.empty()) return;  // at rest
    check_length(file, name, v.size(), grains);
    for (std::size_t g = 0; g < grains; ++g)
        if (!std::isfinite(v[g]))
            refuse(file, fmt::format("/grains/{} of grain {} is not finite", name, g), "NaN or infinity");
}

void check_contact(const std::string& file, std::size_t c, const dem::Contact& contact, std::size_t grains) {
    const auto inside = [&](std::int32_t g) { return g >= 0 && static_cast<std::size_t>(g) < grains; };
    if (!inside(contact.i) || !inside(contact.j))
        refuse(file, fmt::format("contact {} joins grains {} and {}", c, contact.i, contact.j),
               fmt::format("there are grains 0 to {}", static_cast<long>(grains) - 1));
    if (contact.i == contact.j && contact.cell_x == 0 && contact.cell_y == 0)
        refuse(file, fmt::format("contact {} joins grain {} to itself", c, contact.i),
               "no periodic image between");
    if (!std::isfinite(contact.tangential) || !std::isfinite(contact.moment))
        refuse(file, fmt::format("the history of contact {} is not finite", c), "NaN or infinity");
}

}  // namespace

void check_stored_packing(const dem::Packing& p, const std::string& file) {
    const std::size_t grains = p.size();
    check_length(file, "y", p.y.size(), grains);
    check_length(file, "r", p.r.size(), grains);
    check_velocity(file, "vx", p.vx, grains);
    check_velocity(file, "vy", p.vy, grains);
    check_velocity(file, "spin", p.spin, grains);
    if (!p.L.allFinite()) refuse(file, "/cell/L is not finite", "NaN or infinity");
    dem::check_packing(p, {file, 0, {}});
    for (std::size_t c = 0; c < p.contacts.size(); ++c) check_contact(file, c, p.contacts[c], grains);
}

}  // namespace sandgraph::io
