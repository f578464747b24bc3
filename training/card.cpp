#include "training/card.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "surrogate/features.hpp"

namespace sandgraph::training {
namespace {

using Json = nlohmann::ordered_json;

Json ranges(const Law& law) {
    Json out = Json::object();
    const std::optional<surrogate::Model> model = law.served(1);
    if (!model) return out;
    for (std::size_t i = 0; i < surrogate::feature_count; ++i)
        out[surrogate::feature_names[i]] = {model->ranges[i].low, model->ranges[i].high};
    return out;
}

Json errors(std::span<const ErrorTable> tables) {
    Json out = Json::array();
    for (const ErrorTable& table : tables)
        for (const ErrorRow& row : table.rows)
            out.push_back({{"of", table.of},
                           {"data", table.data},
                           {"regime", row.regime},
                           {"samples", row.samples},
                           {"p50", row.median},
                           {"p95", row.high},
                           {"worst", row.worst},
                           {"p_bias", row.p_bias},
                           {"q_bias", row.q_bias}});
    return out;
}

Json compared(const Verdict& verdict) {
    if (verdict.comparisons.empty()) return nullptr;
    Json out{{"with", verdict.start}, {"verdict", verdict.words}, {"data", Json::array()}};
    for (const Comparison& c : verdict.comparisons)
        out["data"].push_back({{"data", c.data},
                               {"histories", c.histories},
                               {"before", c.before},
                               {"after", c.after},
                               {"change", c.change},
                               {"interval95", std::isfinite(c.interval) ? Json(c.interval) : Json()}});
    return out;
}

Json data_part(const TrainingData& data) {
    const Split& s = data.split;
    return {{"hash", data.hash},
            {"logs", data.set.sources},
            {"histories",
             {{"training", s.training.size()},
              {"validation", s.validation.size()},
              {"held out, new seeds", s.new_seeds.size()},
              {"held out, known seeds", s.known_seeds.size()},
              {"guard", s.guard.size()}}},
            {"seeds_validation", s.seeds_validation},
            {"seeds_held_out", s.seeds_held_out}};
}

}  // namespace

std::string model_card(const scene::TrainSpec& spec, const TrainingData& data, const Trained& trained,
                       std::span<const ErrorTable> tables, const Verdict& verdict, const std::string& command,
                       const std::string& revision) {
    const Json card{{"rung", name_of(spec.rung)},
                    {"members", spec.members},
                    {"command", command},
                    {"git", revision},
                    {"recipe", spec.text},
                    {"data", data_part(data)},
                    {"epochs", trained.epochs},
                    {"validation_loss", trained.validation},
                    {"wall_s", trained.seconds},
                    {"ranges", ranges(*trained.law)},
                    {"compared", compared(verdict)},
                    {"error",
                     "|sigma - sigma_DEM| (Frobenius) / max(p_DEM, 1 kPa), ensemble mean, every "
                     "training step of a history"},
                    {"errors", errors(tables)}};
    return card.dump(2) + "\n";
}

}  // namespace sandgraph::training
