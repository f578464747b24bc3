#pragma once
#include <filesystem>
#include <string>

#include "report/load_picture.hpp"
#include "results/finished_run.hpp"

namespace sandgraph::report {

// Draws load curve and fields of the frames (all, if none are named) into the folder `to`. Returns one line
// for the user; pictures are an extra, so that what went wrong is told there, not thrown.
std::string draw_pictures(const std::filesystem::path& to, const results::FinishedRun& run,
                          const std::vector<std::size_t>& frames = {});

// Extensions of the files of each picture: ".png", and what the scene asks for beside it.
std::vector<std::string> picture_formats(const scene::Scene& scene);

LoadCurve load_curve(const results::FinishedRun& run);
// FIELD_DDDD.png, DDDD: 1000 d/B; and the fields there are.
std::string picture_name(const std::string& field, double mark);
const std::vector<std::string>& field_picture_names();

}  // namespace sandgraph::report
