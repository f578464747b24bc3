#pragma once
#include "report/field_picture.hpp"
#include "scene/scene.hpp"

namespace sandgraph::app {

// How the pictures and measures of a scene's ground look at it: the plate and about two widths around it.
report::GroundView ground_view(const scene::Scene& scene);

}  // namespace sandgraph::app
