#include "mpm/contact.hpp"

#include <algorithm>
#include <cmath>

#include "base/contracts.hpp"

namespace sandgraph::mpm {
namespace {

// Soil-side tangent: +x on top and bottom, +y on the sides, clockwise around a circle.
Vec2 tangent(const ContactPoint& t) {
    if (t.face == Face::round) return {t.normal.y(), -t.normal.x()};
    return horizontal(t.face) ? Vec2(1, 0) : Vec2(0, 1);
}

// A point that changed its face, or that was in no contact, has no history. One that turns round the end of a
// face, where it has sunk, is as deep under the next: it is not thrown out of it.
void remember(Contact& contact, const ContactPoint& t, bool trimmed) {
    const auto p = static_cast<std::size_t>(t.point);
    const auto before = static_cast<Face>(contact.face[p]);
    if (before == t.face) return;
    const bool turned = trimmed && before != Face::none && t.face != Face::none;
    contact.face[p] = static_cast<std::uint8_t>(t.face);
    contact.slip[p] = 0;
    contact.sunk[p] = turned ? std::max(t.penetration, 0.0) : 0;
}

// Of the pressure at an end of a face what all nodes carry: the whole at rest, nothing once it has doubled or
// gone.
double at_rest(double pressed, double rest) { return std::max(rest - std::fabs(pressed - rest), 0.0); }

// Adds the force on the soil and returns it [N/m], docs/how_it_works.md (eq. 14); slips the spring where
// Coulomb's limit is reached.
Vec2 press(const RigidPlate& plate, const ContactPoint& t, double& slip, Grid& grid) {
    SG_EXPECT(t.length > 0);
    const double pressed = std::max(t.penetration, 0.0);  // never tension
    const double limit = std::tan(plate.friction_angle) * pressed;
    slip = std::clamp(slip, -limit, limit);
    const double k = plate.stiffness * t.length;
    const Vec2 force = k * pressed * t.normal - k * slip * tangent(t);
    const Vec2 rest = t.at_end ? Vec2(k * at_rest(pressed, t.rest) * t.normal) : Vec2(0, 0);
    spread(grid, t.stencil, force.x() - rest.x(), force.y() - rest.y());
    if (t.at_end) spread(grid, t.whole, rest.x(), rest.y());
    return force;
}

}  // namespace

Contact make_contact(std::size_t points) {
    Contact contact;
    contact.slip.assign(points, 0.0);
    contact.sunk.assign(points, 0.0);
    contact.face.assign(points, 0);
    return contact;
}

Contact make_contact(const RigidPlate& plate, const Points& points) {
    Contact contact = make_contact(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
        if (const double sunk = bedding(plate, points, p); !std::isnan(sunk)) {
            contact.face[p] = static_cast<std::uint8_t>(Face::round);
            contact.sunk[p] = sunk;
        }
    return contact;
}

void add_contact(const RigidPlate& plate, const Points& points, const Order& order, Grid& grid,
                 Contact& contact) {
    SG_EXPECT(contact.slip.size() == points.size() && contact.face.size() == points.size());
    SG_EXPECT(plate.stiffness > 0 || order.near.empty());
    contact.points.clear();
    contact.reaction = {};
    for (const auto id : order.near) {
        ContactPoint contact_point = find_contact_point(plate, points, id, grid);
        const auto p = static_cast<std::size_t>(id);
        remember(contact, contact_point, plate.trimmed);
        if (contact_point.face == Face::none) continue;
        contact_point.penetration -= contact.sunk[p];
        if (plate.round && contact_point.penetration <= 0) {
            contact.slip[p] = 0.0;  // what it was bedded by stays
            continue;
        }
        const Vec2 f = press(plate, contact_point, contact.slip[p], grid);
        contact.reaction.on[static_cast<std::size_t>(contact_point.face)] -= f;
        contact.points.push_back(contact_point);
    }
}

void advance_slip(const RigidPlate& plate, const Grid& grid, double dt, Contact& contact) {  // (eq. 14)
    SG_EXPECT(dt > 0);
    for (const ContactPoint& t : contact.points) {
        const auto p = static_cast<std::size_t>(t.point);
        const Vec2 v = velocity(grid, t.stencil);
        contact.slip[p] += dt * tangent(t).dot(v - plate.velocity);
        if (t.at_end) contact.sunk[p] += dt * t.normal.dot(v - velocity(grid, t.own));
    }
}

void archive(Archive& a, Contact& contact, const std::string& prefix) {
    field_of_known_length(a, prefix + "contact/slip", contact.slip);
    field_of_known_length(a, prefix + "contact/sunk", contact.sunk);
    field_of_known_length(a, prefix + "contact/face", contact.face);
    require_indices(contact.face, kFaces, "contact/face");
}

}  // namespace sandgraph::mpm
