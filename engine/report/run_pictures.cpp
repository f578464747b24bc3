#include "report/run_pictures.hpp"

#include <fmt/format.h>

#include <cmath>
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
    return {{"Biarez (1965)", results::biarez(ratio, phi)}};
}

}  // namespace

LoadCurve load_curve(const results::FinishedRun& run) {
    const double unit = run.summary.number("unit_load_N_per_m");
    LoadCurve curve;
    curve.label = results::title_of(run.scene);
    for (const io::LoadRow& row : run.record.load)
        curve.d_over_B.push_back(row.d_over_B), curve.load.push_back(row.load);
    curve.unit_load = std::isfinite(unit) ? unit : 1;
    curve.breakout = results::breakout(curve.d_over_B, curve.load);
    return curve;
}

std::string draw_pictures(const std::filesystem::path& to, const results::FinishedRun& run,
                          const std::vector<std::size_t>& wanted) {
    std::filesystem::create_directories(to);
    Picture last{true, ""};
    if (run.scene.anchor.present)
        last = draw_load_picture({results::title_of(run.scene), {load_curve(run)}, formulas(run)},
                                 to / "load.png");
    const results::GroundView view = results::ground_view(run.scene);
    std::vector<std::size_t> frames = wanted;
    for (std::size_t k = 0; wanted.empty() && k < run.record.frames; ++k) frames.push_back(k);
    for (const std::size_t k : frames) {
        if (!last.drawn) break;
        const io::Frame frame = io::read_run_frame(run.frame_file(), k);
        for (const Shown& field : kFields)
            if (last.drawn &&
                (field.quantity != results::Quantity::mode || results::has_field(frame, "mode")))
                last = draw_field_picture(frame, field.quantity, view,
                                          to / picture_name(field.name, results::mark_of(frame, view)));
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

std::string picture_name(const std::string& field, double mark) {
    return fmt::format("{}_{:04.0f}.png", field, 1e3 * mark);
}

}  // namespace sandgraph::report
