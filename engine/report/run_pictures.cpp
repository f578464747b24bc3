#include "report/run_pictures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "report/field_picture.hpp"
#include "report/load_picture.hpp"
#include "results/analytic.hpp"
#include "results/finished_run.hpp"
#include "results/ground_view.hpp"

namespace sandgraph::report {
namespace {

struct Shown {
    results::Quantity quantity;
    const char* name;
};
constexpr Shown kFields[] = {{results::Quantity::displacement, "displacement"},
                             {results::Quantity::equivalent_strain, "strain"},
                             {results::Quantity::rotation, "rotation"},
                             {results::Quantity::porosity, "porosity"},
                             {results::Quantity::mode, "mode"}};

constexpr double kDegree = std::numbers::pi / 180;

// None where no friction angle is known.
std::vector<ReferenceLine> formulas(const results::FinishedRun& run) {
    const double ratio = results::embedment_of(run), phi = run.summary.number("friction_angle_deg") * kDegree;
    if (!(phi > 0)) return {};
    if (results::pulled_up(run.scene))
        return {{"Meyerhof & Adams (1968)", results::meyerhof_adams(ratio, phi)}};
    if (!(ratio > 1)) return {};  // it has no factor for so shallow a plate
    return {{"Biarez (1965)", results::biarez(ratio, phi)}};
}

}  // namespace

LoadCurve load_curve(const results::FinishedRun& run) {
    const double unit = run.summary.number("unit_load_N_per_m");
    LoadCurve curve;
    curve.label = results::title_of(run.scene);
    for (const io::LoadRow& row : run.record.load)
        curve.d_over_B.push_back(row.d_over_B), curve.load.push_back(row.load);
    if (run.record.load_audited)
        for (const io::LoadRow& row : run.record.load)
            curve.corrected.push_back(row.corrected), curve.low.push_back(row.low),
                curve.high.push_back(row.high);
    curve.unit_load = std::isfinite(unit) ? unit : 1;
    curve.breakout = results::breakout(curve.d_over_B, curve.load);
    return curve;
}

namespace {

std::vector<Shown> fields_of(const io::Frame& frame) {
    std::vector<Shown> fields;
    for (const Shown& field : kFields)
        if (field.quantity != results::Quantity::mode || results::has_field(frame, "mode"))
            fields.push_back(field);
    return fields;
}

// Of all frames, also of those that are not drawn now: pictures of a run can be laid side by side.
std::map<std::string, ColourRange> ranges_of(const results::FinishedRun& run,
                                             const results::GroundView& view) {
    std::map<std::string, ColourRange> ranges;
    for (std::size_t k = 0; k < run.record.frames; ++k) {
        const io::Frame frame = io::read_run_frame(run.frame_file(), k);
        for (const Shown& field : fields_of(frame)) {
            const ColourRange one = field_range(frame, field.quantity, view);
            const auto [at, fresh] = ranges.try_emplace(field.name, one);
            if (!fresh) at->second = joined(at->second, one);
        }
    }
    return ranges;
}

Picture draw_frames(const std::filesystem::path& to, const results::FinishedRun& run,
                    const std::vector<std::size_t>& frames, const std::vector<std::string>& formats) {
    const results::GroundView view = results::ground_view(run.scene);
    const std::map<std::string, ColourRange> ranges = ranges_of(run, view);
    Picture last{true, ""};
    for (const std::size_t k : frames) {
        const io::Frame frame = io::read_run_frame(run.frame_file(), k);
        for (const Shown& field : fields_of(frame))
            if (last.drawn)
                last =
                    draw_field_picture(frame, field.quantity, view, ranges.at(field.name),
                                       to / picture_name(field.name, results::mark_of(frame, view)), formats);
    }
    return last;
}

std::string draw_all(const std::filesystem::path& to, const results::FinishedRun& run,
                     std::vector<std::size_t> frames) {
    std::filesystem::create_directories(to);
    const std::vector<std::string> formats = picture_formats(run.scene);
    for (std::size_t k = 0, all = frames.empty() ? run.record.frames : 0; k < all; ++k) frames.push_back(k);
    Picture last{true, ""};
    if (run.scene.anchor.present)
        last = draw_formats(load_plot({results::title_of(run.scene), {load_curve(run)}, formulas(run)}),
                            to / "load.png", formats);
    if (last.drawn) last = draw_frames(to, run, frames, formats);
    return last.drawn ? fmt::format("pictures in {}", to.string()) : "no pictures: " + last.message;
}

}  // namespace

std::vector<std::string> picture_formats(const scene::Scene& scene) {
    switch (scene.output.picture_format) {
        case scene::PictureFormat::svg:
            return {".png", ".svg"};
        case scene::PictureFormat::pdf:
            return {".png", ".pdf"};
        case scene::PictureFormat::png:
            break;
    }
    return {".png"};
}

std::string draw_pictures(const std::filesystem::path& to, const results::FinishedRun& run,
                          const std::vector<std::size_t>& frames) {
    try {
        return draw_all(to, run, frames);
    } catch (const std::exception& error) {  // a folder that cannot be made, a frame that cannot be read
        return fmt::format("no pictures: {}", error.what());
    }
}

const std::vector<std::string>& field_picture_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Shown& field : kFields) all.emplace_back(field.name);
        return all;
    }();
    return names;
}

std::string picture_name(const std::string& field, double mark) {
    return fmt::format("{}_{:04.0f}.png", field, 1e3 * mark);
}

}  // namespace sandgraph::report
