#pragma once
#include <vector>

#include "packings/compressed_packings.hpp"

namespace sandgraph::packings {

// The sand of a ground: the base packings of `grains` (samples.hpp), each at any pressure.
class SandSample {
  public:
    explicit SandSample(const scene::Grains& grains, const ProgressCallback& progress = {});

    std::size_t size() const { return packings_.size(); }
    const CompressedPackings& operator[](std::size_t sample) const { return packings_[sample]; }

    double porosity() const;                            // 2D, of the base packings, mean
    double porosity(double pressure, double k0) const;  // 2D, at that stress, mean
    // Peak friction angle of each [rad].
    std::vector<double> friction(const ProgressCallback& progress = {}) const;

  private:
    std::vector<CompressedPackings> packings_;
};

}  // namespace sandgraph::packings
