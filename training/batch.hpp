#pragma once
#include <torch/types.h>

#include <span>

#include "training/path.hpp"

namespace sandgraph::training {

// Histories of about equal length side by side, T steps of B histories; shorter ones end in steps that strain
// nothing and weigh nothing. Deviators have their two parts on the last axis. Stresses in Pa.
struct Batch {
    torch::Tensor dv, J, J_middle, strain;      // [T, B]; J at a step's begin and middle
    torch::Tensor de;                           // [T, B, 2]
    torch::Tensor p;                            // [T, B] measured
    torch::Tensor s;                            // [T, B, 2] measured
    torch::Tensor weight;                       // [T, B] in the loss
    torch::Tensor lead;                         // [T, B] share of its error that p is led back by
    torch::Tensor p0, e0, K0, G0, Z0, sin_phi;  // [B] of the packing
    torch::Tensor fabric, s0;                   // [B, 2] at the start
    torch::Tensor histories;                    // [B] index of each in the set (int64)

    std::int64_t steps() const { return dv.size(0); }
    std::int64_t size() const { return dv.size(1); }
};

// One history of the set, cut.
struct CutHistory {
    std::int64_t index = 0;
    const io::HistoryPacking* start = nullptr;
    std::vector<Step> steps;
};

// Cuts the histories `which`; steps beyond a path's length of `strain_max` are left out.
std::vector<CutHistory> cut_all(const HistorySet& set, std::span<const std::int64_t> which,
                                const CutRule& rule, double strain_max);

// Batches of at most `size` histories, the shortest first.
std::vector<Batch> make_batches(std::vector<CutHistory> histories, std::size_t size, torch::Dtype type);

Batch make_batch(std::span<const CutHistory> histories, torch::Dtype type);

}  // namespace sandgraph::training
