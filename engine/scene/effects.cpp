#include "scene/effects.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/element_test_spec.hpp"
#include "scene/probe_spec.hpp"
#include "scene/recipe_spec.hpp"
#include "scene/scene.hpp"
#include "scene/toml_file.hpp"
#include "scene/train_spec.hpp"

namespace sandgraph::scene {
namespace {

constexpr const char* leave_out = "leave it out";

bool on_command_line(const Key& key) { return key.given && key.where.file == override_file; }

// `ground.law = "rve"`, and whether somebody wrote that.
std::string standing(const KeyTable& keys, const char* name) {
    const Key& key = keys.at(name);
    return fmt::format("{} = {}{}", name, key.value->shown(), key.given ? "" : " by default");
}

// Rules of single keys of one table with a reason in common.
EffectRules each(const char* table, std::initializer_list<const char*> names, const EffectRule& common) {
    EffectRules rules;
    for (const char* name : names) {
        rules.push_back(common);
        rules.back().keys = fmt::format("{}.{}", table, name);
    }
    return rules;
}

void append(EffectRules& rules, const EffectRules& more) {
    rules.insert(rules.end(), more.begin(), more.end());
}

// [grains]: a packing file is made already, and a named density is a porosity.
EffectRules grain_rules(const Grains& grains, const KeyTable& keys) {
    EffectRules rules = each(
        "grains",
        {"density", "target_porosity", "count", "radius_min", "radius_max", "consolidation_pressure", "seed"},
        {"", grains.packing.empty(), "grains.packing",
         fmt::format("no effect: {} is a packing made already", standing(keys, "grains.packing")),
         "leave it out, or leave out grains.packing to have one made"});
    rules.push_back({"grains.target_porosity", grains.density == "custom", "grains.density",
                     fmt::format("density = \"{}\" sets it", grains.density),
                     "write density = \"custom\" or leave this key out"});
    return rules;
}

EffectRules law_rules(const Scene& s, const KeyTable& keys) {
    const bool grains = s.ground.law == Law::rve, elastic = s.ground.law == Law::elastic;
    const std::string law = "ground.law", is = standing(keys, "ground.law");
    const std::string no_grains = fmt::format("no effect: with {} a formula answers, not grains", is);
    const std::string to_grains = "leave it out, or write ground.law = \"rve\"";
    EffectRules rules;
    for (const char* table : {"grains", "rve", "surrogate", "gate", "audit"})
        rules.push_back({table, grains, law, no_grains, to_grains});
    rules.push_back({"continuum", !grains, law,
                     fmt::format("no effect: with {} grains answer, whose keys are [grains]", is),
                     "write grains.friction_angle, grains.young, ... for the contacts, or ground.law = "
                     "\"mohr_coulomb\""});
    append(rules, each("continuum", {"friction_angle", "dilation_angle", "cohesion"},
                       {"", !elastic, law, fmt::format("no effect: {} never yields", is),
                        "leave it out, or write ground.law = \"mohr_coulomb\""}));
    return rules;
}

EffectRules anchor_rules(const Scene& s, const KeyTable& keys) {
    return {{"anchor", s.anchor.present, "anchor.present",
             fmt::format("no effect: {}", standing(keys, "anchor.present")),
             "leave it out, or write anchor.present = true"},
            {"mpm.end_time", !s.anchor.present, "anchor.present",
             "no effect: a run with an anchor ends with the pull, at anchor.pull_to",
             "leave it out, or write anchor.present = false"}};
}

// A scene is run in both modes, with its [surrogate], [gate] and [audit] in the file.
EffectRules mode_rules(const Scene& s, const KeyTable& keys) {
    const bool screening = s.mode == Mode::screening;
    EffectRules rules;
    for (const char* table : {"surrogate", "gate", "audit"})
        rules.push_back({table, screening, "mode",
                         fmt::format("no effect: {}, grains answer everywhere", standing(keys, "mode")),
                         "leave it out, or run with --mode screening", true});
    rules.push_back({"output.history_points", !screening, "mode",
                     "no effect: a screening run logs its audited points, audit.share of them", leave_out,
                     true});
    return rules;
}

EffectRules screening_rules(const Screening& s, const KeyTable& keys) {
    EffectRules rules = each(
        "gate",
        {"strain", "stress_ratio", "tension", "distance", "spread", "second_order_work", "acoustic",
         "acoustic_from", "low", "flow"},
        {"", s.gate.active, "gate.active",
         fmt::format("no effect: with {} only failed answers are handed over", standing(keys, "gate.active")),
         "leave it out, or write gate.active = true"});
    rules.push_back({"gate.acoustic_from", s.gate.acoustic > -1000, "gate.acoustic",
                     fmt::format("no effect: {} is off", standing(keys, "gate.acoustic")),
                     "leave it out, or write gate.acoustic = 0"});
    append(rules, each("audit", {"seed", "every"},
                       {"", s.audit.share > 0, "audit.share",
                        fmt::format("no effect: {}, nothing is audited", standing(keys, "audit.share")),
                        leave_out}));
    rules.push_back({"surrogate.update_change_max", s.visits.update_tolerance > 0,
                     "surrogate.update_tolerance",
                     "no effect: with update_tolerance = 0 nothing is predicted", leave_out});
    return rules;
}

EffectRules visit_rules(const graph::RveSettings& rve) {
    return {{"rve.update_change_max", rve.update_tolerance > 0, "rve.update_tolerance",
             "no effect: with update_tolerance = 0 nothing is predicted", leave_out}};
}

EffectRules history_rules(const Output& o, const KeyTable& keys) {
    return each("output", {"history_points", "history_max"},
                {"", o.history, "output.history",
                 fmt::format("no effect: {}, nothing is logged", standing(keys, "output.history")),
                 "leave it out, or write output.history = true"});
}

// Element tests and probes visit their packing at each increment.
EffectRules no_visits() {
    return each("rve", {"update_tolerance", "update_change_max"},
                {"", false, "", "no effect: here the packing answers every increment", leave_out});
}

bool speaks_of(const EffectRule& rule, const Key& key) {
    const std::string name = key.full_name();
    return (rule.keys == name || rule.keys == key.section) && name != rule.decided_by;
}

// By an override, so that what stands in the file is not to blame.
bool switched(const EffectRule& rule, const KeyTable& keys) {
    return !rule.decided_by.empty() && on_command_line(keys.at(rule.decided_by));
}

}  // namespace

EffectRules effect_rules(const Scene& s, const KeyTable& keys) {
    EffectRules rules = law_rules(s, keys);
    append(rules, anchor_rules(s, keys));
    append(rules, grain_rules(s.ground.grains, keys));
    append(rules, mode_rules(s, keys));
    append(rules, screening_rules(s.screening, keys));
    append(rules, visit_rules(s.ground.rve));
    append(rules, history_rules(s.output, keys));
    return rules;
}

EffectRules effect_rules(const RecipeSpec& recipe, const KeyTable& keys) {
    return grain_rules(recipe.grains, keys);
}

EffectRules effect_rules(const ElementTestSpec& test, const KeyTable& keys) {
    EffectRules rules{{"rve", test.kind == TestKind::path && test.mode == dem::Kernel::fast, "mode",
                       test.kind == TestKind::path
                           ? fmt::format("no effect: {} takes the steps it is told", standing(keys, "mode"))
                           : fmt::format("no effect: {} takes steps of time_step", standing(keys, "kind")),
                       "leave it out, or write kind = \"path\" and mode = \"fast\""}};
    append(rules, no_visits());
    return rules;
}

EffectRules effect_rules(const ProbeSpec& probe, const KeyTable& keys) {
    const ProbePaths& p = probe.paths;
    EffectRules rules = each("paths", {"flow_rows", "flow_length"},
                             {"", p.flow > 0, "paths.flow",
                              fmt::format("no effect: {}", standing(keys, "paths.flow")), leave_out});
    rules.push_back({"paths.dither_rows", p.dither > 0, "paths.dither",
                     fmt::format("no effect: {}", standing(keys, "paths.dither")), leave_out});
    append(rules, no_visits());
    return rules;
}

EffectRules effect_rules(const TrainSpec& t, const KeyTable& keys) {
    const std::string rung = standing(keys, "model.rung");
    const bool elements = t.rung != TrainRung::mlp && t.rung != TrainRung::gru;
    return {
        {"model.start", t.rung == TrainRung::learned, "model.rung",
         fmt::format("no effect: {} starts from nothing", rung), "leave it out, or write rung = \"learned\""},
        {"model.measured_critical", elements, "model.rung",
         fmt::format("no effect: {} has no critical state of its own", rung),
         "leave it out, or write rung = \"learned\""},
        {"steps.lead_from", t.steps.lead_strain > 0, "steps.lead_strain",
         fmt::format("no effect: {}, the measured pressure never leads", standing(keys, "steps.lead_strain")),
         leave_out}};
}

const EffectRule* idle_by(const EffectRules& rules, const Key& key) {
    const auto found = std::ranges::find_if(
        rules, [&key](const EffectRule& rule) { return !rule.effective && speaks_of(rule, key); });
    return found == rules.end() ? nullptr : &*found;
}

void check_effects(const KeyTable& keys, const EffectRules& rules) {
    for (const Key& key : keys.keys())
        for (const EffectRule& rule : rules) {
            if (!key.given || rule.effective || !speaks_of(rule, key)) continue;
            if ((rule.may_stand || switched(rule, keys)) && !on_command_line(key)) continue;
            throw InputError(key.where, fmt::format("{} = {}", key.full_name(), key.value->shown()), rule.why,
                             rule.advice);
        }
}

}  // namespace sandgraph::scene
