#pragma once
#include <type_traits>

#include "io/history.hpp"

// The columns of a history log, stated once for writer and reader (h5_table.hpp).
namespace sandgraph::io {

template <class Visit>
void columns(std::type_identity<HistoryRow>, Visit&& visit) {
    visit("history", "-", &HistoryRow::history);
    visit("sequence", "-", &HistoryRow::sequence);
    visit("mode", "-", &HistoryRow::mode);
    visit("status", "-", &HistoryRow::status);
    visit("F_inc", "-", &HistoryRow::F_inc);
    visit("J", "-", &HistoryRow::volume_ratio);
    visit("dt", "s", &HistoryRow::dt);
    visit("dem_steps", "-", &HistoryRow::dem_steps);
    visit("inertial_number", "-", &HistoryRow::inertial_number);
    visit("unbalanced", "-", &HistoryRow::unbalanced);
    visit("stress", "Pa", &HistoryRow::stress);
    visit("p", "Pa", &HistoryRow::p);
    visit("q", "Pa", &HistoryRow::q);
    visit("void_ratio", "-", &HistoryRow::void_ratio);
    visit("coordination", "-", &HistoryRow::coordination);
    visit("sliding_fraction", "-", &HistoryRow::sliding_fraction);
    visit("fabric", "-", &HistoryRow::fabric);
    visit("energy", "J", &HistoryRow::energy);
}

template <class Visit>
void columns(std::type_identity<HistoryPacking>, Visit&& visit) {
    using stress::PackingTraits;
    const auto traits = &HistoryPacking::traits;
    visit("hash", "-", &HistoryPacking::hash);
    visit("seed", "-", &HistoryPacking::seed);
    visit("density", "-", &HistoryPacking::density);
    visit("target_porosity", "-", &HistoryPacking::target_porosity);
    visit("pressure", "Pa", traits, &PackingTraits::pressure);
    visit("porosity", "-", traits, &PackingTraits::porosity);
    visit("bulk", "Pa", traits, &PackingTraits::bulk);
    visit("shear", "Pa", traits, &PackingTraits::shear);
    visit("coordination", "-", traits, &PackingTraits::coordination);
    visit("fabric_xx", "-", traits, &PackingTraits::fabric_xx);
    visit("fabric_xy", "-", traits, &PackingTraits::fabric_xy);
    visit("strength", "-", traits, &PackingTraits::peak_friction);
    visit("stress", "Pa", &HistoryPacking::stress);
}

template <class Visit>
void columns(std::type_identity<HistoryInfo>, Visit&& visit) {
    visit("packing", "-", &HistoryInfo::packing);
    visit("point", "-", &HistoryInfo::point);
    visit("x", "m", &HistoryInfo::x);
    visit("y", "m", &HistoryInfo::y);
    visit("path", "-", &HistoryInfo::path);
    visit("twin", "-", &HistoryInfo::twin);
    visit("twin_of", "-", &HistoryInfo::twin_of);
    visit("rotation", "rad", &HistoryInfo::rotation);
}

}  // namespace sandgraph::io
