#pragma once
#include <vector>

#include "scene/region_spec.hpp"
#include "scene/value.hpp"

namespace sandgraph::scene {

// [[region]] tables of a scene:
//   name = "A"
//   x = [-0.5, -0.1]      low and high, in plate widths from the plate's centre, or "3 m" in the domain
//   y = [-0.5, 0.5]
// or, for the material point nearest to a place,
//   at = [0.6, 0.5]
// and in either case
//   packings = [0, 0.1]   d/B at which its packing is kept
class RegionTables : public Value {
  public:
    explicit RegionTables(std::vector<Region>& regions) : regions_(regions) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return "[]"; }
    std::string canonical() const override { return ""; }
    std::string allowed() const override;

  private:
    std::vector<Region>& regions_;
};

}  // namespace sandgraph::scene
