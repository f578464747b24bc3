#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "base/random.hpp"
#include "stability/plate_ride.hpp"
#include "stability/tampered_surrogate.hpp"

namespace sandgraph::stability {
namespace {

using Lie = void (*)(std::int32_t point, stress::SurrogateAnswer& answer);

void honest(std::int32_t, stress::SurrogateAnswer&) {}
void biased(std::int32_t, stress::SurrogateAnswer& a) {
    a.stress.xx *= 1.3, a.stress.yy *= 1.3, a.stress.xy *= 1.3;
}
void flipped(std::int32_t, stress::SurrogateAnswer& a) {
    a.stress = {-a.stress.xx, -a.stress.yy, -a.stress.xy};
}
// Each component multiplied by another number from 0.7 to 1.3; the same answer always gets the same lie.
void random_lie(std::int32_t point, stress::SurrogateAnswer& a) {
    Random random(std::bit_cast<std::uint64_t>(a.stress.xx), static_cast<std::uint64_t>(point));
    for (double* s : {&a.stress.xx, &a.stress.yy, &a.stress.xy}) *s *= random.uniform(0.7, 1.3);
}

struct Told {
    double audit = 0, failed_share = 0, by_grains = 0, kinetic = 0;
    bool stopped = false;
};

// The plate pulled by 0.02 B with every fourth point audited, to the end or to a stop with a message.
Told told(Effort effort, Lie lie, bool gate) {
    GroundSpec spec = plate_in_ground(effort, 1);
    spec.screening = [&](graph::ScreeningSetup& setup) {
        setup.surrogate = std::make_shared<TamperedSurrogate>(setup.surrogate, lie);
        setup.audit = {0.25, 1, 0.005};
        setup.gate.active = gate;
    };
    Ground ground(spec);
    Told out;
    try {
        out.kinetic = pull(ground, effort == Effort::quick ? 0.2 : 0.1, 0.02).kinetic_share;
    } catch (const std::runtime_error&) {
        out.stopped = true;
    }
    auto& law = dynamic_cast<graph::ScreeningLaw&>(*ground.state().law);
    law.audit_now(0.02);
    for (const stress::AuditRow& a : law.screening_log()->audits)
        if (a.points > 1) out.audit = std::max(out.audit, a.mean);
    const auto size = static_cast<double>(law.size());
    out.failed_share = static_cast<double>(law.screening_log()->counters.failed_answers) / size;
    out.by_grains = static_cast<double>(law.modes().grain_points()) / size;
    return out;
}

void lying(Effort effort, Findings& found, Lie lie, const char* how, double least, bool gate) {
    found.driven =
        fmt::format("surrogate whose stress is {}, gate {}: 0.02 B with every fourth point audited", how,
                    gate ? "on" : "off");
    const Told truth = told(effort, honest, gate), lies = told(effort, lie, gate);
    found.note("finished (1) or stopped with a message (0)", lies.stopped ? 0 : 1);
    found.note("largest audited error of the honest surrogate, share of p", truth.audit);
    found.note("largest audited error of this one, share of p", lies.audit);
    found.note("share of the points by grains, beyond that of the honest one",
               lies.by_grains - truth.by_grains);
    found.at_least(
        "the largest of: audited error beyond the honest one's, share of answers refused, more grains",
        std::max({lies.audit - truth.audit, lies.failed_share, lies.by_grains - truth.by_grains}), least);
    found.note("share of the points whose answers were refused", lies.failed_share);
    found.note("kinetic energy over the plate's work", lies.kinetic);
}

constexpr std::array table = {
    Case{"lying.random",
         [](Effort e, Findings& f) { lying(e, f, random_lie, "off by up to 30 % at random", 0.1, false); }},
    Case{"lying.biased", [](Effort e, Findings& f) { lying(e, f, biased, "30 % too high", 0.2, false); }},
    Case{"lying.flipped",
         [](Effort e, Findings& f) { lying(e, f, flipped, "of the other sign", 0.5, false); }},
    Case{"lying.random.gate",
         [](Effort e, Findings& f) {
             if (e == Effort::full) lying(e, f, random_lie, "off by up to 30 % at random", 0.1, true);
         }},
    Case{"lying.biased.gate",
         [](Effort e, Findings& f) {
             if (e == Effort::full) lying(e, f, biased, "30 % too high", 0.2, true);
         }},
};

}  // namespace

std::span<const Case> lying_cases() { return table; }

}  // namespace sandgraph::stability
