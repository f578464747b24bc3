#pragma once
#include <algorithm>
#include <cmath>

#include "base/byte_stream.hpp"
#include "base/tensor.hpp"

namespace sandgraph::dem {

// How far a packing has been strained one way: the Hencky strain along its own direction of late, of which a
// reversal takes away a hundred times as much as it goes back. Noise therefore counts as no way at all.
class StrainRun {
  public:
    double length() const { return length_; }

    // docs/how_it_works.md (eq. 27a). `strain`: Hencky strain of an update, packing frame.
    void add(const Mat2& strain) {
        constexpr double kMemory = 1e-4, kLoss = 100;  // strain over which a direction is forgotten
        const double size = strain.norm(), along = (direction_.array() * strain.array()).sum();
        if (!(size > 0)) return;
        length_ = std::max(0.0, length_ + (along < 0 ? kLoss : 1) * along);
        const double kept = std::exp(-size / kMemory);
        direction_ = kept * direction_ + (1 - kept) / size * strain;
    }

    void save(ByteWriter& out) const { out.put(length_), out.put(std::span(direction_.data(), 4)); }
    void load(ByteReader& in) {
        in.take(length_), in.take(std::span<double>(direction_.data(), 4));
        require_state(length_ >= 0 && std::isfinite(length_) && direction_.allFinite(), "numbers");
    }

  private:
    double length_ = 0;
    Mat2 direction_ = Mat2::Zero();  // mean over the strain of late, norm 1 at most
};

}  // namespace sandgraph::dem
