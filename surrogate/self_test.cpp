#include "surrogate/self_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace sandgraph::surrogate {
namespace {

constexpr int packings = 3;
constexpr const char* train_again = "train the model again with 'sandgraph train'";

// `place` 0 to 1 inside the trained range of the four features of a packing.
stress::PackingTraits traits_at(const Model& model, double place) {
    const auto feature = [&](std::size_t i) {
        return model.ranges[i].low + place * (model.ranges[i].high - model.ranges[i].low);
    };
    stress::PackingTraits t;
    t.pressure = 1e4 * std::exp(3 * std::clamp(feature(4), -3.0, 3.0));
    const double void_ratio = std::max(0.22 + 0.04 * feature(5), 0.01);
    t.porosity = void_ratio / (1 + void_ratio);
    t.coordination = std::max(3.5 + 0.5 * feature(6), 0.5);
    t.peak_friction = std::clamp(0.5 + 0.1 * feature(7), 0.05, 0.95);
    t.bulk = 2e7 * std::sqrt(t.pressure / 1e4);
    t.shear = 0.6 * t.bulk;
    t.fabric_xx = 0.02 * place;
    t.fabric_xy = 0.01;
    return t;
}

// One point of the law, started isotropically.
class Probe {
  public:
    Probe(const Model& model, const stress::Surrogate& law, double place)
        : law_(law), traits_(traits_at(model, place)), state_(law.state_size()) {
        law.start(traits_, {-traits_.pressure, -traits_.pressure, 0}, state_);
    }
    const stress::PackingTraits& traits() const { return traits_; }
    Stress drive(double xx, double yy, double xy, double yx) {
        const Mat2 F = (Mat2() << 1 + xx, xy, yx, 1 + yy).finished();
        const std::int32_t point = 0;
        stress::SurrogateAnswer answer;
        law_.update({&point, 1}, {&F, 1}, state_, {&answer, 1});
        return answer.stress;
    }

  private:
    const stress::Surrogate& law_;
    stress::PackingTraits traits_;
    std::vector<double> state_;
};

void check_factor(const std::string& file, const char* name, double ratio) {
    if (ratio >= 0.1 && ratio <= 4) return;
    throw InputError({file},
                     fmt::format("the model's {} at rest is {:.3g} times the packing's own", name, ratio),
                     "0.1 to 4 expected", train_again);
}

// Secant moduli of a strain so small that hardly an element slips.
void check_moduli(const Model& model, const stress::Surrogate& law, double place, const std::string& file) {
    constexpr double strain = 1e-7;
    Probe squeezed(model, law, place), sheared(model, law, place);
    const double p0 = squeezed.traits().pressure;
    const double bulk = (mean_stress(squeezed.drive(-strain, -strain, 0, 0)) - p0) / (2 * strain);
    const double shear = sheared.drive(0, 0, strain, strain).xy / (2 * strain);
    check_factor(file, "bulk modulus", bulk / squeezed.traits().bulk);
    check_factor(file, "shear modulus", shear / squeezed.traits().shear);
}

}  // namespace

std::vector<double> self_test_answers(const Model& model, const stress::Surrogate& law) {
    std::vector<double> answers;
    for (int i = 0; i < packings; ++i) {
        Probe probe(model, law, 0.5 * i);
        for (int step = 0; step < 24; ++step) {
            const double shear = step < 14 ? 3e-4 : -2e-4, volume = step < 4 ? -5e-5 : 2e-5;
            const Stress s = probe.drive(volume - shear, volume + shear, 1e-3, step % 5 ? -1e-3 : 2e-4);
            if (step % 4 == 3)
                for (const double component : {s.xx, s.yy, s.xy})
                    answers.push_back(component / probe.traits().pressure);
        }
    }
    return answers;
}

void check_self_test(const Model& model, const stress::Surrogate& law, const std::vector<double>& stored,
                     const std::string& file) {
    const std::vector<double> now = self_test_answers(model, law);
    double difference = now.size() == stored.size() ? 0 : INFINITY;
    for (std::size_t i = 0; i < std::min(now.size(), stored.size()); ++i)
        if (!(std::abs(now[i] - stored[i]) <= difference)) difference = std::abs(now[i] - stored[i]);
    if (!(difference <= 1e-9))
        throw InputError({file}, "the model fails its own self test",
                         fmt::format("answers differ by {:.1e} p0 from those stored with it", difference),
                         train_again);
}

void check_physics(const Model& model, const stress::Surrogate& law, const std::string& file) {
    for (int i = 0; i < packings; ++i) {
        check_moduli(model, law, 0.5 * i, file);
        Probe probe(model, law, 0.5 * i);
        if (!model.frictional) continue;
        for (int step = 0; step < 50; ++step) {
            const Stress s = probe.drive(-1e-3, 1e-3, 0, 0);
            const double ratio = deviator(s) / mean_stress(s);
            if (!(ratio <= 1))
                throw InputError({file}, fmt::format("the model reaches q/p = {:.3g} in shear", ratio),
                                 "grains without cohesion cannot pass 1", train_again);
        }
    }
}

}  // namespace sandgraph::surrogate
