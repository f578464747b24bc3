#include "app/run_pictures.hpp"

#include <fmt/format.h>

#include "app/finished_run.hpp"
#include "app/ground_view.hpp"
#include "report/analytic.hpp"
#include "report/field_picture.hpp"
#include "report/load_picture.hpp"

namespace sandgraph::app {
namespace {

struct Shown {
    report::Quantity quantity;
    const char* name;
};
constexpr Shown kFields[] = {{report::Quantity::displacement, "displacement"},
                             {report::Quantity::equivalent_strain, "strain"},
                             {report::Quantity::rotation, "rotation"},
                             {report::Quantity::porosity, "porosity"},
                             {report::Quantity::mode, "mode"}};

report::ReferenceLine formula(const PictureSource& source) {
    const double ratio = source.embedment_ratio, phi = source.friction_angle;
    if (pulled_up(source.scene)) return {"Meyerhof & Adams (1968)", report::meyerhof_adams(ratio, phi)};
    return {"Biarez (1965)", report::biarez(ratio, phi)};
}

}  // namespace

report::LoadCurve load_curve(const PictureSource& source) {
    report::LoadCurve curve;
    curve.label = title_of(source.scene);
    for (const io::LoadRow& row : source.record.load)
        curve.d_over_B.push_back(row.d_over_B), curve.load.push_back(row.load);
    curve.unit_load = source.unit_load;
    curve.breakout = report::breakout(curve.d_over_B, curve.load);
    return curve;
}

std::string draw_pictures(const std::filesystem::path& to, const PictureSource& source) {
    std::filesystem::create_directories(to);
    report::Picture last{true, ""};
    if (source.scene.anchor.present) {
        report::LoadPicture picture{title_of(source.scene), {load_curve(source)}, {}};
        if (source.friction_angle > 0) picture.references = {formula(source)};
        last = report::draw_load_picture(picture, to / "load.png");
    }
    const report::GroundView view = ground_view(source.scene);
    std::vector<std::size_t> frames = source.frames;
    for (std::size_t k = 0; source.frames.empty() && k < source.record.frames; ++k) frames.push_back(k);
    for (const std::size_t k : frames) {
        if (!last.drawn) break;
        const io::Frame frame = io::read_run_frame(source.frame_file, k);
        for (const Shown& field : kFields)
            if (last.drawn && (field.quantity != report::Quantity::mode || report::has_field(frame, "mode")))
                last = report::draw_field_picture(frame, field.quantity, view,
                                                  to / picture_name(field.name, frame.d_over_B));
    }
    return last.drawn ? fmt::format("pictures in {}", to.string()) : "no pictures: " + last.message;
}

const std::vector<std::string>& field_picture_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Shown& field : kFields) all.emplace_back(field.name);
        return all;
    }();
    return names;
}

std::string picture_name(const std::string& field, double d_over_B) {
    return fmt::format("{}_{:04.0f}.png", field, 1e3 * d_over_B);
}

}  // namespace sandgraph::app
