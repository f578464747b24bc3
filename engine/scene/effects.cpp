#include "scene/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/toml_file.hpp"

namespace sandgraph::scene {
namespace {

using enum EffectRule::If;

// Reasons of several rules.
constexpr const char* no_grains = "no effect: {is}, a formula answers, not grains";
constexpr const char* to_grains = "leave it out, or write ground.law = \"rve\"";
constexpr const char* no_yield = "no effect: {is} never yields";
constexpr const char* to_yield = "leave it out, or write ground.law = \"mohr_coulomb\"";
constexpr const char* made = "no effect: {is} is a packing made already";
constexpr const char* to_recipe = "leave it out, or leave out grains.packing to have one made";
constexpr const char* no_surrogate = "no effect: {is}, grains answer everywhere";
constexpr const char* to_screening = "leave it out, or run with --mode screening";
constexpr const char* no_gate = "no effect: {is}, only failed answers are handed over";
constexpr const char* to_gate = "leave it out, or write gate.active = true";
constexpr const char* no_audit = "no effect: {is}, nothing is audited";
constexpr const char* no_log = "no effect: {is}, nothing is logged";
constexpr const char* to_log = "leave it out, or write output.history = true";
constexpr const char* no_prediction = "no effect: {is}, nothing is predicted";
constexpr const char* every_increment = "no effect: here the packing answers every increment";
constexpr const char* no_paths = "no effect: {is}";

// A scene may hold what only its screening runs use.
constexpr auto scene_rules = std::to_array<EffectRule>({
    {"grains", "ground.law", is, "\"rve\"", no_grains, to_grains},
    {"rve", "ground.law", is, "\"rve\"", no_grains, to_grains},
    {"surrogate", "ground.law", is, "\"rve\"", no_grains, to_grains},
    {"gate", "ground.law", is, "\"rve\"", no_grains, to_grains},
    {"audit", "ground.law", is, "\"rve\"", no_grains, to_grains},
    {"continuum", "ground.law", is_not, "\"rve\"", "no effect: {is}, grains answer, whose keys are [grains]",
     "write grains.friction_angle, grains.young, ... for the contacts, or ground.law = \"mohr_coulomb\""},
    {"continuum.friction_angle", "ground.law", is_not, "\"elastic\"", no_yield, to_yield},
    {"continuum.dilation_angle", "ground.law", is_not, "\"elastic\"", no_yield, to_yield},
    {"continuum.cohesion", "ground.law", is_not, "\"elastic\"", no_yield, to_yield},
    {"anchor", "anchor.present", is, "true", "no effect: {is}",
     "leave it out, or write anchor.present = true"},
    {"mpm.end_time", "anchor.present", is, "false",
     "no effect: a run with an anchor ends with the pull, at anchor.pull_to",
     "leave it out, or write anchor.present = false"},
    {"surrogate", "mode", is, "\"screening\"", no_surrogate, to_screening, true},
    {"gate", "mode", is, "\"screening\"", no_surrogate, to_screening, true},
    {"audit", "mode", is, "\"screening\"", no_surrogate, to_screening, true},
    {"output.history_points", "mode", is, "\"full\"",
     "no effect: a screening run logs its audited points, audit.share of them", "leave it out", true},
    {"output.history_points", "output.history", is, "true", no_log, to_log},
    {"output.history_max", "output.history", is, "true", no_log, to_log},
    {"gate.strain", "gate.active", is, "true", no_gate, to_gate},
    {"gate.stress_ratio", "gate.active", is, "true", no_gate, to_gate},
    {"gate.tension", "gate.active", is, "true", no_gate, to_gate},
    {"gate.distance", "gate.active", is, "true", no_gate, to_gate},
    {"gate.spread", "gate.active", is, "true", no_gate, to_gate},
    {"gate.second_order_work", "gate.active", is, "true", no_gate, to_gate},
    {"gate.acoustic", "gate.active", is, "true", no_gate, to_gate},
    {"gate.acoustic_from", "gate.active", is, "true", no_gate, to_gate},
    {"gate.low", "gate.active", is, "true", no_gate, to_gate},
    {"gate.flow", "gate.active", is, "true", no_gate, to_gate},
    {"gate.acoustic_from", "gate.acoustic", is_not, "-1000", "no effect: {is} is off",
     "leave it out, or write gate.acoustic = 0"},
    {"audit.load_evenly", "audit.load_points", is_not, "0", no_audit},
    {"surrogate.update_change_max", "surrogate.update_tolerance", is_not, "0", no_prediction},
    {"rve.update_change_max", "rve.update_tolerance", is_not, "0", no_prediction},
    {"rve.predictor", "rve.update_tolerance", is_not, "0", no_prediction},
    {"rve.steady_strain", "rve.steady_factor", is_not, "1", "no effect: {is}, the bounds never loosen",
     "leave it out, or write steady_factor = 2"},
});

// Of scenes and recipes.
constexpr auto grain_rules = std::to_array<EffectRule>({
    {"grains.density", "grains.packing", is, "\"\"", made, to_recipe},
    {"grains.target_porosity", "grains.packing", is, "\"\"", made, to_recipe},
    {"grains.count", "grains.packing", is, "\"\"", made, to_recipe},
    {"grains.radius_min", "grains.packing", is, "\"\"", made, to_recipe},
    {"grains.radius_max", "grains.packing", is, "\"\"", made, to_recipe},
    {"grains.consolidation_pressure", "grains.packing", is, "\"\"", made, to_recipe},
    {"grains.seed", "grains.packing", is, "\"\"", made, to_recipe},
    {"grains.target_porosity", "grains.density", is, "\"custom\"", "density = {value} sets it",
     "write density = \"custom\" or leave this key out"},
});

constexpr auto element_test_rules = std::to_array<EffectRule>({
    {"rve", "kind", is, "\"path\"", "no effect: {is} takes steps of time_step"},
    {"rve", "mode", is, "\"fast\"", "no effect: {is} takes steps of time_step",
     "leave it out, or write mode = \"fast\""},
    {"rve.update_tolerance", "", is, "", every_increment},
    {"rve.update_change_max", "", is, "", every_increment},
    {"rve.predictor", "", is, "", every_increment},
    {"rve.steps_max", "", is, "", every_increment},
});

constexpr auto probe_rules = std::to_array<EffectRule>({
    {"paths.flow_rows", "paths.flow", is_not, "0", no_paths},
    {"paths.flow_length", "paths.flow", is_not, "0", no_paths},
    {"paths.dither_rows", "paths.dither", is_not, "0", no_paths},
    {"rve.update_tolerance", "", is, "", every_increment},
    {"rve.update_change_max", "", is, "", every_increment},
    {"rve.predictor", "", is, "", every_increment},
    {"rve.steps_max", "", is, "", every_increment},
});

constexpr auto sweep_rules = std::to_array<EffectRule>({
    {"combine", "rows", is, "\"\"", "no effect: the lines of a CSV are rows as they stand"},
    {"axis", "rows", is, "\"\"", "no effect: {is}, its lines are the rows", "leave out the one or the other"},
});

constexpr auto train_rules = std::to_array<EffectRule>({
    {"model.start", "model.rung", is, "\"learned\"", "no effect: {is} starts from nothing",
     "leave it out, or write rung = \"learned\""},
    {"data.guard", "model.start", is_not, "\"\"",
     "it guards what model.start has learnt, and no model is gone on from",
     "leave it out, or write start = \"MODEL.h5\" under [model]"},
    {"model.measured_critical", "model.rung", is_not, "\"mlp\"|\"gru\"",
     "no effect: {is} has no critical state of its own", "leave it out, or write rung = \"learned\""},
    {"steps.lead_from", "steps.lead_strain", is_not, "0",
     "no effect: {is}, the measured pressure never leads"},
});

std::span<const EffectRule> rules_of_scene() {
    static const auto all = [] {
        std::vector<EffectRule> rules(scene_rules.begin(), scene_rules.end());
        rules.insert(rules.end(), grain_rules.begin(), grain_rules.end());
        return rules;
    }();
    return all;
}

bool speaks_of(const EffectRule& rule, const Key& key) {
    const std::string name = key.full_name();
    return (rule.keys == name || rule.keys == key.section) && name != rule.decided_by;
}

bool holds(std::string_view values, std::string_view value) {
    for (std::size_t from = 0; from <= values.size();) {
        const std::size_t to = std::min(values.find('|', from), values.size());
        if (values.substr(from, to - from) == value) return true;
        from = to + 1;
    }
    return false;
}

const Key* decider(const EffectRule& rule, const KeyTable& keys) {
    return *rule.decided_by ? &keys.at(rule.decided_by) : nullptr;
}

bool effective(const EffectRule& rule, const KeyTable& keys) {
    const Key* key = decider(rule, keys);
    return key && holds(rule.values, key->value->canonical()) == (rule.when == is);
}

bool on_command_line(const Key* key) { return key && key->given && key->where.file == override_file; }

// The file is not to blame for what an override did, nor for what it holds for other runs.
bool excused(const EffectRule& rule, const KeyTable& keys, const Key& key) {
    return !on_command_line(&key) && (rule.may_stand || on_command_line(decider(rule, keys)));
}

std::string why(const EffectRule& rule, const KeyTable& keys) {
    const Key* key = decider(rule, keys);
    if (!key) return rule.why;
    const std::string value = key->value->shown();
    const std::string is = fmt::format("{} = {}{}", key->full_name(), value, key->given ? "" : " by default");
    return fmt::format(fmt::runtime(rule.why), fmt::arg("is", is), fmt::arg("value", value));
}

}  // namespace

std::span<const EffectRule> effect_rules(FileKind kind) {
    switch (kind) {
        case FileKind::scene:
            return rules_of_scene();
        case FileKind::recipe:
            return grain_rules;
        case FileKind::element_test:
            return element_test_rules;
        case FileKind::probe:
            return probe_rules;
        case FileKind::sweep:
            return sweep_rules;
        case FileKind::train:
            break;
    }
    return train_rules;
}

bool is_idle(const KeyTable& keys, const Key& key, FileKind kind) {
    return std::ranges::any_of(effect_rules(kind), [&](const EffectRule& rule) {
        return !rule.may_stand && speaks_of(rule, key) && !effective(rule, keys);
    });
}

void check_effects(const KeyTable& keys, FileKind kind) {
    for (const Key& key : keys.keys())
        for (const EffectRule& rule : effect_rules(kind))
            if (key.given && speaks_of(rule, key) && !effective(rule, keys) && !excused(rule, keys, key))
                throw InputError(key.where, fmt::format("{} = {}", key.full_name(), key.value->shown()),
                                 why(rule, keys), rule.advice);
}

}  // namespace sandgraph::scene
