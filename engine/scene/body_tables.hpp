#pragma once
#include <vector>

#include "scene/body_spec.hpp"
#include "scene/value.hpp"

namespace sandgraph::scene {

// [[body]] tables of a scene: rigid bodies of prescribed velocity, in metres of the domain.
//   shape = "rectangle"
//   centre = ["0 m", "3 m"]
//   size = ["1 m", "0.2 m"]        or, for a circle, radius = "0.5 m"
//   friction_angle = "0 deg"       against the soil; 90 deg, unless given: perfectly rough
//   velocity = ["0 m/s", "-0.01 m/s"]   at rest unless given
//   travel = "0.05 m"              after which it stops; the first body that moves ends the run with its own
class BodyTables : public Value {
  public:
    explicit BodyTables(std::vector<Body>& bodies) : bodies_(bodies) {}
    void read(const Entry& entry) override;
    std::string shown() const override { return "[]"; }
    std::string canonical() const override;
    std::string allowed() const override;

  private:
    std::vector<Body>& bodies_;
};

}  // namespace sandgraph::scene
