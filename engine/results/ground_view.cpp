#include "results/ground_view.hpp"

#include <fmt/format.h>

#include "results/finished_run.hpp"
#include "scene/alignment.hpp"

namespace sandgraph::results {

GroundView ground_view(const scene::Scene& scene) {
    const scene::Anchor& a = scene.anchor;
    GroundView view;
    view.title = title_of(scene);
    view.width = scene.domain.width, view.surface = scene.domain.depth;
    view.point_size = scene::point_spacing(scene.domain);
    view.anchor_width = a.width, view.has_plate = a.present;
    view.plate_size_x = pulled_up(scene) ? a.width : a.thickness;
    view.plate_size_y = pulled_up(scene) ? a.thickness : a.width;
    if (!a.present) return view;
    view.mirror = pulled_up(scene);
    view.window = (a.embedment_ratio + 2) * a.width;
    return view;
}

double mark_of(const io::Frame& frame, const GroundView& view) {
    return view.has_plate ? frame.d_over_B : frame.time;
}

std::string moment_text(double mark, bool has_plate) {
    return has_plate ? fmt::format("d/B = {:.3g}", mark) : fmt::format("t = {:.3g} s", mark);
}

}  // namespace sandgraph::results
