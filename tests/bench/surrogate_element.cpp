// A surrogate beside the grains it stands for, in a soil laboratory: simple shear at constant mean stress,
// biaxial compression at constant lateral stress, 10,000 small increments to and fro, and the same path in
// ten times finer increments. Mean over packing seeds of a scene's own packings. Usage:
// bench_surrogate_element SCENE.toml MODEL.h5 [seeds]
#include <fmt/format.h>

#include <functional>

#include "base/random.hpp"
#include "dem/rve.hpp"
#include "packings/in_situ.hpp"
#include "scene/read_scene.hpp"
#include "surrogate/load_surrogate.hpp"

namespace {

using namespace sandgraph;

constexpr double increment = 1e-4, longest = 0.2;
constexpr std::array marks = {0.001, 0.002, 0.005, 0.01, 0.02, 0.035, 0.05, 0.1, 0.15, 0.2};
constexpr std::array pressures = {10e3, 30e3};

// Whoever answers a strain increment with a stress, and the packing's constants.
struct Specimen {
    stress::PackingTraits traits;
    Stress start;
    std::function<Stress(const Mat2&)> drive;
};

Stress tension(const Mat2& s) { return {-s(0, 0), -s(1, 1), -0.5 * (s(0, 1) + s(1, 0))}; }

struct Laboratory {
    scene::Scene scene;
    packings::PreparedGround ground;

    Laboratory(scene::Scene s, std::uint64_t seed) : scene(std::move(s)) {
        scene.ground.grains.seed = seed;
        ground = packings::prepare_ground(scene);
    }
    std::size_t row(double pressure) const {
        const auto off = [&](std::size_t k) { return std::abs(ground.traits[k].pressure - pressure); };
        std::size_t best = 0;
        for (std::size_t k = 1; k < ground.traits.size(); ++k)
            if (off(k) < off(best)) best = k;
        return best;
    }
    Specimen grains(double pressure) const {
        const auto r = row(pressure);
        auto rve = std::make_shared<dem::Rve>(ground.packings[r].packing);
        auto work = std::make_shared<dem::Workspace>();
        const dem::Material material = scene.ground.grains.material;
        const dem::RveOptions options =
            dem::rve_options(scene.ground.rve, material, ground.packings[r].packing->grains->radius);
        return {ground.traits[r], tension(rve->stress()), [=](const Mat2& F) {
                    rve->update(F, material, options, *work);
                    return tension(rve->stress());
                }};
    }
    Specimen surrogate(double pressure, const stress::Surrogate& law) const {
        const auto r = row(pressure);
        auto state = std::make_shared<std::vector<double>>(law.state_size());
        const Stress start = tension(dem::Rve(ground.packings[r].packing).stress());
        law.start(ground.traits[r], start, *state);
        return {ground.traits[r], start, [&law, state](const Mat2& F) {
                    const std::int32_t point = 0;
                    stress::SurrogateAnswer answer;
                    law.update({&point, 1}, {&F, 1}, *state, {&answer, 1});
                    return answer.stress;
                }};
    }
};

enum class Test { shear, biaxial };

// q/p and porosity at the marks (q/p: mean since the mark before), summed over specimens.
struct Curve {
    std::array<double, marks.size()> ratio{}, porosity{};
};

// The free strain follows the held stress by a proportional and integral servo.
Curve run(Test test, const Specimen& s) {
    Curve curve;
    Stress now = s.start;
    const auto held = [&] { return test == Test::shear ? mean_stress(now) : -now.yy; };
    const double target = held();
    double J = 1, rate = 0, sum = 0;
    int count = 0;
    std::size_t mark = 0;
    for (double e = increment; mark < marks.size(); e += increment) {
        const double off = (held() - target) / s.traits.bulk;
        rate += 0.05 * off;
        const double x = std::clamp(0.5 * off + rate, -3 * increment, 3 * increment);
        const Mat2 F = test == Test::shear ? (Mat2() << 1 + x / 2, increment, 0, 1 + x / 2).finished()
                                           : (Mat2() << 1 - increment, 0, 0, 1 + x).finished();
        J *= F.determinant();
        now = s.drive(F);
        sum += deviator(now) / mean_stress(now), ++count;
        if (e < marks[mark]) continue;
        curve.ratio[mark] = sum / count, curve.porosity[mark] = 1 - (1 - s.traits.porosity) / J;
        ++mark, sum = 0, count = 0;
    }
    return curve;
}

void print(const char* who, const std::vector<Curve>& curves) {
    const auto n = static_cast<double>(curves.size());
    fmt::print("{:10}", who);
    for (std::size_t k = 0; k < marks.size(); ++k) {
        double ratio = 0, porosity = 0;
        for (const Curve& c : curves) ratio += c.ratio[k] / n, porosity += c.porosity[k] / n;
        fmt::print("  {:.3f} {:.4f}", ratio, porosity);
    }
    fmt::print("\n");
}

double distance(const Stress& a, const Stress& b) {
    const double x = a.xx - b.xx, y = a.yy - b.yy, s = a.xy - b.xy;
    return std::sqrt(x * x + y * y + 2 * s * s) / std::max(mean_stress(b), 1e3);
}

// 10,000 random increments of about 1e-6 around the start, each partly taken back by the next: grid noise.
double dither(const Specimen& model, const Specimen& grains, std::uint64_t seed) {
    Random random(seed, 77);
    Eigen::Array4d before = Eigen::Array4d::Zero();
    double sum = 0;
    for (int k = 0; k < 10'000; ++k) {
        Eigen::Array4d at;
        for (double& v : at) v = random.uniform(-2e-6, 2e-6);
        const Eigen::Array4d step = at - before;
        before = at;
        const Mat2 F = (Mat2() << 1 + step[0], step[1], step[2], 1 + step[3]).finished();
        sum += distance(model.drive(F), grains.drive(F));
    }
    return sum / 10'000;
}

// Largest change of the answer by cutting a path of shear at constant volume (0 to 1 %) ten times finer.
double finer(const Specimen& coarse, const Specimen& fine) {
    double worst = 0;
    for (int k = 0; k < 100; ++k) {
        const double e = 1e-4 * (1 + 0.3 * std::sin(k));
        const Mat2 F = (Mat2() << std::exp(e), 0.2 * e, 0, std::exp(-e)).finished();
        const Mat2 part = (Mat2() << std::exp(e / 10), 0.02 * e, 0, std::exp(-e / 10)).finished();
        const Stress a = coarse.drive(F);
        Stress b;
        for (int i = 0; i < 10; ++i) b = fine.drive(part);
        worst = std::max(worst, distance(a, b));
    }
    return worst;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return fmt::print(stderr, "bench_surrogate_element SCENE.toml MODEL.h5 [seeds]\n"), 2;
    const auto law = surrogate::load_surrogate(argv[2]);
    const int seeds = argc > 3 ? std::atoi(argv[3]) : 3;
    std::vector<Laboratory> labs;
    for (int seed = 1; seed <= seeds; ++seed)
        labs.emplace_back(scene::read_scene(argv[1]), static_cast<std::uint64_t>(seed));
    fmt::print("q/p and porosity at strain\n{:10}", "");
    for (const double m : marks) fmt::print("  {:<12}", m);
    fmt::print("\n");
    for (const Test test : {Test::shear, Test::biaxial})
        for (const double p : pressures) {
            std::vector<Curve> grains, model;
            for (const Laboratory& lab : labs) {
                grains.push_back(run(test, lab.grains(p)));
                model.push_back(run(test, lab.surrogate(p, *law)));
            }
            fmt::print("{} at {} kPa\n", test == Test::shear ? "simple shear" : "biaxial", p / 1e3);
            print("grains", grains);
            print("surrogate", model);
        }
    for (const double p : pressures) {
        double noise = 0, change = 0;
        for (std::size_t k = 0; k < labs.size(); ++k) {
            noise += dither(labs[k].surrogate(p, *law), labs[k].grains(p), k) / static_cast<double>(seeds);
            change = std::max(change, finer(labs[k].surrogate(p, *law), labs[k].surrogate(p, *law)));
        }
        fmt::print(
            "{} kPa: 10,000 increments to and fro: {:.4f} of p from the grains; ten times finer: {:.5f}\n",
            p / 1e3, noise, change);
    }
}
