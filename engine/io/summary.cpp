#include "io/summary.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace sandgraph::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kKnowsSand = "surrogate_knows_this_sand";

// Visits the fixed keys in their order; one list serves both directions.
template <class S, class Visit>
void visit_keys(S& s, Visit&& visit) {
    visit("points", s.points), visit("steps", s.steps), visit("wall_s", s.wall_s), visit("cpu_s", s.cpu_s);
    visit("dem_steps", s.dem_steps), visit("rve_updates", s.rve_updates);
    visit("surrogate_updates", s.surrogate_updates);
    visit("dem_fraction_final", s.dem_fraction_final), visit("dem_fraction_mean", s.dem_fraction_mean);
    visit("breakout", s.breakout), visit("peak_load_N_per_m", s.breakout_load),
        visit("peak_d_over_B", s.breakout_d_over_B);
    visit("n_gamma", s.n_gamma), visit("n_gamma_meyerhof_adams", s.n_gamma_meyerhof_adams);
    visit("n_gamma_biarez", s.n_gamma_biarez), visit("late_load_N_per_m", s.late_load);
    visit("kinetic_to_strain_energy_max", s.kinetic_to_strain_energy_max);
    visit("threads", s.threads), visit("mode", s.mode), visit("git", s.git),
        visit("scene_hash", s.scene_hash);
}

template <class A, class Visit>
void visit_audit(A& a, Visit&& visit) {
    visit("points", a.points), visit("stress_error_mean", a.stress_error_mean), visit("ci95", a.ci95);
    visit("load_correction", a.load_correction), visit("load_ci95", a.load_ci95);
    visit("load_ci95_late", a.load_ci95_late);
}

auto writer(Json& json) {
    return [&json](const char* key, const auto& value) { json[key] = value; };
}

// null stands for NaN.
void get(const Json& value, double& to) { to = value.is_null() ? Summary::unknown : value.get<double>(); }
template <class T>
void get(const Json& value, T& to) {
    to = value.get<T>();
}

// Runs of earlier versions have no `breakout`; their criterion tells it.
bool broke_out(const Json& json) { return json.value("breakout", json.value("breakout_criterion", 2.0) < 2); }

auto reader(const Json& json) {
    return [&json](const char* key, auto& value) {
        if constexpr (std::is_same_v<decltype(value), bool&>)
            value = broke_out(json);
        else if (json.contains(key) ||
                 !std::string_view(key).starts_with("load_"))  // earlier versions lack these
            get(json.at(key), value);
    };
}

Summary from_json(const Json& json) {
    Summary summary;
    visit_keys(summary, reader(json));
    visit_audit(summary.audit, reader(json.at("audit")));
    if (json.contains(kKnowsSand)) summary.surrogate_knows_this_sand = json.at(kKnowsSand).get<bool>();
    if (json.contains("warnings")) summary.warnings = json.at("warnings").get<std::vector<std::string>>();
    Json known;
    visit_keys(summary, writer(known));
    for (const auto& [key, value] : json.items())
        if (value.is_number() && !known.contains(key)) summary.extra.emplace_back(key, value.get<double>());
    return summary;
}

}  // namespace

double Summary::number(const std::string& key) const {
    for (const auto& [name, value] : extra)
        if (name == key) return value;
    return unknown;
}

std::string to_json(const Summary& summary) {
    Json json, audit;
    visit_keys(summary, writer(json));
    visit_audit(summary.audit, writer(audit));
    json["audit"] = audit;
    if (summary.surrogate_knows_this_sand) json[kKnowsSand] = *summary.surrogate_knows_this_sand;
    json["warnings"] = summary.warnings;
    for (const auto& [key, value] : summary.extra) json[key] = value;
    return json.dump(2) + "\n";
}

void write_summary(const std::filesystem::path& path, const Summary& summary) {
    write_text(path, to_json(summary));
}

Summary read_summary(const std::filesystem::path& path) {
    std::ifstream in(path);
    if (!in)
        throw InputError({path.string()}, "no such file", "a finished run has one", "finish the run first");
    try {
        return from_json(Json::parse(in));
    } catch (const Json::exception& error) {
        throw InputError({path.string()}, "not the summary of a run", error.what(), "run the scene again");
    }
}

}  // namespace sandgraph::io
