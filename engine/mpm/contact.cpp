#include "mpm/contact.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

// Soil-side tangent of a face: +x on top and bottom, +y on the sides.
double along(Face face, const Vec2& v) { return horizontal(face) ? v.x() : v.y(); }
Vec2 tangent(Face face) { return horizontal(face) ? Vec2(1, 0) : Vec2(0, 1); }

// A point that changed its face, or that was in no contact, has no history.
void remember(Contact& contact, std::size_t p, Face face) {
    if (contact.face[p] == static_cast<std::uint8_t>(face)) return;
    contact.face[p] = static_cast<std::uint8_t>(face);
    contact.slip[p] = 0;
}

// Force on the soil [N/m], docs/how_it_works.md (eq. 14); slips the spring where Coulomb's limit is reached.
Vec2 force(const RigidPlate& plate, const ContactPoint& t, double& slip) {
    SG_EXPECT(t.penetration > 0 && t.length > 0);  // never tension
    const double limit = std::tan(plate.friction_angle) * t.penetration;
    slip = std::clamp(slip, -limit, limit);
    const double k = plate.stiffness * t.length;
    return k * t.penetration * normal(t.face) - k * slip * tangent(t.face);
}

}  // namespace

Contact make_contact(std::size_t points) {
    Contact contact;
    contact.slip.assign(points, 0.0);
    contact.face.assign(points, 0);
    return contact;
}

void add_contact(const RigidPlate& plate, const Points& points, const Order& order, Grid& grid,
                 Contact& contact) {
    SG_EXPECT(contact.slip.size() == points.size() && contact.face.size() == points.size());
    SG_EXPECT(plate.stiffness > 0 || order.near.empty());
    contact.points.clear();
    contact.reaction = {};
    for (const auto id : order.near) {
        const ContactPoint contact_point = find_contact_point(plate, points, id, grid);
        const auto p = static_cast<std::size_t>(id);
        remember(contact, p, contact_point.face);
        if (contact_point.face == Face::none) continue;
        const Vec2 f = force(plate, contact_point, contact.slip[p]);
        spread(grid, contact_point.stencil, f.x(), f.y());
        contact.reaction.on[static_cast<std::size_t>(contact_point.face)] -= f;
        contact.points.push_back(contact_point);
    }
}

void advance_slip(const RigidPlate& plate, const Grid& grid, double dt, Contact& contact) {  // (eq. 14)
    SG_EXPECT(dt > 0);
    for (const ContactPoint& t : contact.points)
        contact.slip[static_cast<std::size_t>(t.point)] +=
            dt * along(t.face, velocity(grid, t.stencil) - plate.velocity);
}

void archive(Archive& a, Contact& contact) {
    field_of_known_length(a, "contact/slip", contact.slip);
    field_of_known_length(a, "contact/face", contact.face);
    require_indices(contact.face, kFaces, "contact/face");
}

}  // namespace sandgraph::mpm
