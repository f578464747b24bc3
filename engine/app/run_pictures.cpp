#include "app/run_pictures.hpp"

#include <fmt/format.h>

#include "report/analytic.hpp"
#include "report/field_picture.hpp"
#include "report/load_picture.hpp"
#include "scene/check_scene.hpp"

namespace sandgraph::app {
namespace {

struct Shown {
    report::Quantity quantity;
    const char* name;
};
constexpr Shown kFields[] = {{report::Quantity::displacement, "displacement"},
                             {report::Quantity::equivalent_strain, "strain"},
                             {report::Quantity::rotation, "rotation"},
                             {report::Quantity::porosity, "porosity"}};

bool horizontal(const scene::Scene& s) { return s.anchor.orientation == scene::Orientation::horizontal; }

std::string title_of(const scene::Scene& scene) {
    return scene.title.empty() ? std::filesystem::path(scene.file).stem().string() : scene.title;
}

report::LoadPicture load_picture(const RunSession& session, const scene::Scene& scene,
                                 const PreparedGround& ground) {
    report::LoadCurve curve;
    curve.label = title_of(scene);
    for (const io::LoadRow& row : session.record().load)
        curve.d_over_B.push_back(row.d_over_B), curve.load.push_back(row.load);
    curve.unit_load = unit_load(scene, ground);
    curve.breakout = report::breakout(curve.d_over_B, curve.load);
    report::LoadPicture picture{title_of(scene), {curve}, {}};
    if (ground.friction_angle <= 0) return picture;
    const double ratio = scene.anchor.embedment_ratio, phi = ground.friction_angle;
    picture.references.push_back(
        horizontal(scene)
            ? report::ReferenceLine{"Meyerhof & Adams (1968)", report::meyerhof_adams(ratio, phi)}
            : report::ReferenceLine{"Biarez (1965)", report::biarez(ratio, phi)});
    return picture;
}

report::GroundView view_of(const scene::Scene& scene) {
    const scene::Anchor& a = scene.anchor;
    report::GroundView view;
    view.title = title_of(scene);
    view.width = scene.domain.width, view.surface = scene.domain.depth;
    view.point_size = scene::point_spacing(scene.domain);
    view.anchor_width = a.width, view.has_plate = a.present;
    view.plate_size_x = horizontal(scene) ? a.width : a.thickness;
    view.plate_size_y = horizontal(scene) ? a.thickness : a.width;
    view.mirror = horizontal(scene);
    view.window = (a.embedment_ratio + 2) * a.width;
    return view;
}

}  // namespace

std::string draw_pictures(const std::filesystem::path& folder, const RunSession& session,
                          const scene::Scene& scene, const PreparedGround& ground) {
    const std::filesystem::path to = folder / "pictures";
    std::filesystem::create_directories(to);
    report::Picture last{true, ""};
    if (scene.anchor.present)
        last = report::draw_load_picture(load_picture(session, scene, ground), to / "load.png");
    const report::GroundView view = view_of(scene);
    for (std::size_t k = 0; last.drawn && k < session.record().frames; ++k) {
        const io::Frame frame = io::read_run_frame(session.frame_file(), k);
        for (const Shown& field : kFields)
            if (last.drawn)
                last = report::draw_field_picture(
                    frame, field.quantity, view,
                    to / fmt::format("{}_{:04.0f}.png", field.name, 1e3 * frame.d_over_B));
    }
    return last.drawn ? fmt::format("pictures in {}", to.string()) : "no pictures: " + last.message;
}

}  // namespace sandgraph::app
