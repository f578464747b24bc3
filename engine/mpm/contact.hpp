#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "mpm/contact_point.hpp"
#include "mpm/order.hpp"

namespace sandgraph::mpm {

// Force of the soil on each face of the plate [N/m], by Face. Penalty forces only: no damping enters.
struct Reaction {
    std::array<Vec2, kFaces> on = zeros();
    Vec2 face(Face f) const { return on[static_cast<std::size_t>(f)]; }
    Vec2 total() const { return on[1] + on[2] + on[3] + on[4] + on[5]; }
    static std::array<Vec2, kFaces> zeros() {
        std::array<Vec2, kFaces> all;
        all.fill(Vec2::Zero());
        return all;
    }
};

// Weak-form penalty contact between the points' domains and the plate: pressure k_a times penetration, never
// tension; elastic-frictional shear k_a times slip, limited by tan(friction) times the pressure.
struct Contact {
    std::vector<double> slip;  // by point id: elastic slip of the soil along its face [m]
    // By point id, at the ends of faces: how far the point has sunk into the face that the nodes beside the
    // face have not [m]; it flows around the end and is not pressed for that.
    std::vector<double> sunk;
    std::vector<std::uint8_t> face;    // by point id: the Face it was in contact with last step
    std::vector<ContactPoint> points;  // of this step, by id
    Reaction reaction;                 // of this step
};

Contact make_contact(std::size_t points);

// Before the first step: ground laid out around a circle touches it.
Contact make_contact(const RigidPlate& plate, const Points& points);

// Finds the contact points among order.near and adds their forces to the grid AT THE CONTACT: hat functions
// on the domain's edge, averaged over the length in contact. Uniform GIMP ends its internal force there, so
// that a point under uniform stress balances the plate wherever the grid lies. After points_to_grid, before
// update_grid.
void add_contact(const RigidPlate& plate, const Points& points, const Order& order, Grid& grid,
                 Contact& contact);

// Slip and sinking of this step, from the velocity of the soil at the contact (grid) against the plate's and
// the point's own. After
// update_grid.
void advance_slip(const RigidPlate& plate, const Grid& grid, double dt, Contact& contact);

void archive(Archive& a, Contact& contact, const std::string& prefix = "");

}  // namespace sandgraph::mpm
