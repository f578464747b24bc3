#include "results/ground_view.hpp"

#include "results/finished_run.hpp"
#include "scene/check_scene.hpp"

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
    view.mirror = pulled_up(scene);
    view.window = (a.embedment_ratio + 2) * a.width;
    return view;
}

}  // namespace sandgraph::results
