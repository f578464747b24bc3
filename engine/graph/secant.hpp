#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/byte_stream.hpp"
#include "base/tensor.hpp"

namespace sandgraph::graph {

// The plastic part of predictions: by how much the last answers of a point fell short of its elastic stress,
// per strain along the way that it was going. It holds as long as the point goes that way; a reversal is
// elastic. docs/how_it_works.md (eqs. 29a and 31a).
class Secants {
  public:
    explicit Secants(std::size_t points) : all_(points) {}

    // What the increment takes off the elastic prediction [Pa], tension positive.
    Stress shortfall(std::size_t point, const Mat2& F_inc);
    // The law's answer to the deformation collected since its last one lay so far beyond the prediction [Pa].
    void learn(std::size_t point, const Mat2& collected, const Stress& beyond);
    void forget(std::size_t point) { all_[point] = {}; }

    void save(ByteWriter& out) const { out.put(all_); }
    void load(ByteReader& in);

  private:
    struct Secant {
        Stress way;        // mean direction of the strain, Frobenius norm 1; 0: none known
        Stress slope;      // shortfall per strain along it [Pa]
        double along = 0;  // strain that way since the last answer
    };
    std::vector<Secant> all_;
};

// Here to be inlined: it runs for every point at every step.
inline Stress Secants::shortfall(std::size_t point, const Mat2& F_inc) {
    Secant& q = all_[point];
    const double along =
        q.way.xx * (F_inc(0, 0) - 1) + q.way.yy * (F_inc(1, 1) - 1) + q.way.xy * (F_inc(0, 1) + F_inc(1, 0));
    if (!(along > 0)) return {};
    q.along += along;
    return {along * q.slope.xx, along * q.slope.yy, along * q.slope.xy};
}

}  // namespace sandgraph::graph
