#include "io/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "tests/unit/io/scratch.hpp"

namespace sandgraph::io {
namespace {

using test::Scratch;

TEST(Summary, HasTheKeysScriptsRelyOnInTheirOrder) {
    const auto json = nlohmann::ordered_json::parse(to_json(Summary{}));
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    const std::vector<std::string> expected{"points",
                                            "steps",
                                            "wall_s",
                                            "cpu_s",
                                            "dem_steps",
                                            "rve_updates",
                                            "surrogate_updates",
                                            "dem_fraction_final",
                                            "dem_fraction_mean",
                                            "breakout",
                                            "peak_load_N_per_m",
                                            "peak_d_over_B",
                                            "n_gamma",
                                            "n_gamma_meyerhof_adams",
                                            "n_gamma_biarez",
                                            "late_load_N_per_m",
                                            "kinetic_to_strain_energy_max",
                                            "threads",
                                            "mode",
                                            "git",
                                            "scene_hash",
                                            "audit",
                                            "warnings"};
    EXPECT_EQ(keys, expected);
    for (const char* key :
         {"points", "stress_error_mean", "ci95", "load_correction", "load_ci95", "load_ci95_late"})
        EXPECT_TRUE(json["audit"].contains(key));
}

TEST(Summary, TellsOfASurrogateOnlyWhereThereIsOne) {
    const Scratch folder;
    Summary s;
    EXPECT_EQ(to_json(s).find("surrogate_knows"), std::string::npos);
    s.surrogate_knows_this_sand = false;
    write_summary(folder / "summary.json", s);
    EXPECT_EQ(read_summary(folder / "summary.json").surrogate_knows_this_sand, false);
}

TEST(Summary, ReadsBackTheSameAndNullForUnknown) {
    const Scratch folder;
    Summary s;
    s.dem_steps = 12'345'678'901, s.breakout_load = 0.1 + 0.2, s.mode = "full", s.audit.points = 7;
    s.extra = {{"porosity", 0.16}};
    s.breakout = true, s.warnings = {"too fast", "too coarse"};
    write_summary(folder / "summary.json", s);
    const Summary read = read_summary(folder / "summary.json");
    EXPECT_EQ(read.dem_steps, s.dem_steps);
    EXPECT_EQ(read.breakout_load, s.breakout_load);
    EXPECT_EQ(read.mode, "full");
    EXPECT_EQ(read.audit.points, 7);
    EXPECT_TRUE(std::isnan(read.n_gamma_biarez));
    EXPECT_EQ(read.extra, s.extra);
    EXPECT_TRUE(read.breakout);
    EXPECT_EQ(read.warnings, s.warnings);
    EXPECT_NE(test::contents(folder / "summary.json").find("\"n_gamma_biarez\": null"), std::string::npos);
}

TEST(Summary, OfAVersionThatAuditedNoLoadIsReadWithoutIt) {
    const Scratch folder;
    std::string text = to_json(Summary{});
    for (const char* key : {"load_correction", "load_ci95_late", "load_ci95"}) {
        const std::size_t at = text.find("\"" + std::string(key) + "\"");
        text.replace(at + 1, 4, "gone");
    }
    test::overwrite(folder / "s.json", text);
    EXPECT_TRUE(std::isnan(read_summary(folder / "s.json").audit.load_ci95));
}

TEST(Summary, RefusesOtherJson) {
    const Scratch folder;
    test::overwrite(folder / "s.json", "{\"points\": 3}");
    EXPECT_THROW(read_summary(folder / "s.json"), InputError);
    test::overwrite(folder / "s.json", "{\"points\":");
    EXPECT_THROW(read_summary(folder / "s.json"), InputError);
    EXPECT_THROW(read_summary(folder / "none.json"), InputError);
}

}  // namespace
}  // namespace sandgraph::io
