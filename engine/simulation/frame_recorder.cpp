#include "simulation/frame_recorder.hpp"

namespace sandgraph::simulation {
namespace {

constexpr double kReached = 1e-9;  // slack on marks

}  // namespace

FrameRecorder::FrameRecorder(const scene::Scene& scene, const Simulation& simulation, double initial_porosity)
    : marks_(scene.output.frames),
      material_(scene.ground.grains.material),
      initial_porosity_(initial_porosity) {
    const mpm::Points& points = simulation.state().points;
    for (std::size_t p = 0; p < points.size(); ++p) start_.emplace_back(points.x[p], points.y[p]);
}

std::optional<io::Frame> FrameRecorder::after_step(const Simulation& simulation) {
    const std::size_t before = next_;
    resume_at(simulation.mark());
    if (next_ == before) return std::nullopt;
    return make_frame(simulation, start_, initial_porosity_, material_);
}

bool FrameRecorder::due_by(double mark) const {
    return next_ < marks_.size() && mark >= marks_[next_] - kReached;
}

void FrameRecorder::resume_at(double mark) {
    while (due_by(mark)) ++next_;
}

}  // namespace sandgraph::simulation
