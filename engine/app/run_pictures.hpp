#pragma once
#include <filesystem>
#include <string>

#include "io/run_record.hpp"
#include "report/load_picture.hpp"
#include "scene/scene.hpp"

namespace sandgraph::app {

// What the pictures of a run are made from, whether it has just ended or was read back from its folder.
struct PictureSource {
    const scene::Scene& scene;
    const io::RunRecord& record;
    std::filesystem::path frame_file;
    double unit_load = 1;                  // B (gamma H + q_s) [N/m]
    double friction_angle = 0;             // measured on the packing [rad]; 0: unknown
    double embedment_ratio = 0;            // equivalent H/B, surcharge counted as depth
    std::vector<std::size_t> frames = {};  // to draw; empty: all
};

// Draws load curve and fields of the frames into the folder. Returns one line for the user; pictures are an
// extra, so that what went wrong is told there, not thrown.
std::string draw_pictures(const std::filesystem::path& to, const PictureSource& source);

report::LoadCurve load_curve(const PictureSource& source);
// FIELD_DDDD.png, DDDD: 1000 d/B; and the fields there are.
std::string picture_name(const std::string& field, double d_over_B);
const std::vector<std::string>& field_picture_names();

}  // namespace sandgraph::app
