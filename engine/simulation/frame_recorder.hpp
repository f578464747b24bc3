#pragma once
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "simulation/make_frame.hpp"

namespace sandgraph::simulation {

// The field frames of a run: one for every mark (Simulation::mark) that it passes.
class FrameRecorder {
  public:
    // `simulation`: at rest before the first step; displacements count from there.
    FrameRecorder(const scene::Scene& scene, const Simulation& simulation, double initial_porosity);
    // The frame that is due, marks that one step passes together count once.
    std::optional<io::Frame> after_step(const Simulation& simulation);
    bool due_by(double mark) const;
    // A resumed run has passed this mark. Its list may be another than before: frames change no physics.
    void resume_at(double mark);

  private:
    std::vector<double> marks_;
    dem::Material material_;
    std::size_t next_ = 0;
    std::vector<Vec2> start_;
    double initial_porosity_;
};

}  // namespace sandgraph::simulation
