#pragma once
#include <cstdint>

#include "base/contracts.hpp"

namespace sandgraph {

// Counter-based random numbers: the value depends on (seed, stream, counter) only, so results do not depend
// on the order of calls or on the thread count. Mixing function: splitmix64 (Steele, Lea & Flood 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : key_(mix(seed) ^ mix(~stream)) {}
    std::uint64_t bits() { return mix(key_ + counter_++ * 0x9E3779B97F4A7C15ull); }
    // Uniform in [0, 1).
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
    double uniform(double low, double high) {
        SG_EXPECT(low <= high);
        return low + (high - low) * uniform();
    }

  private:
    static std::uint64_t mix(std::uint64_t z) {
        z += 0x9E3779B97F4A7C15ull;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return z ^ (z >> 31);
    }
    std::uint64_t key_, counter_ = 0;
};

}  // namespace sandgraph
