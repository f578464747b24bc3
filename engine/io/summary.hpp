#pragma once
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sandgraph::io {

// summary.json: the keys scripts rely on, always all of them, in this order. NaN is written as null. Loads
// are for the whole plate [N/m].
struct Summary {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::int64_t points = 0, steps = 0;
    double wall_s = 0, cpu_s = 0;
    std::int64_t dem_steps = 0, rve_updates = 0, surrogate_updates = 0;
    double dem_fraction_final = unknown, dem_fraction_mean = unknown;
    bool breakout = false;
    // Where there is none, the largest load of the run and its place; n_gamma is then unknown. [N/m], -
    double breakout_load = unknown, breakout_d_over_B = unknown;
    double n_gamma = unknown, n_gamma_meyerhof_adams = unknown, n_gamma_biarez = unknown;
    double late_load = unknown;                     // [N/m]
    double kinetic_to_strain_energy_max = unknown;  // of the ground, over what the plate has put into it
    int threads = 1;
    std::string mode, git, scene_hash;
    struct Audit {
        std::int64_t points = 0;
        double stress_error_mean = unknown, ci95 = unknown;
        // Of the load, shares of the peak load: what it lacks at the peak and the 95 % interval of that there
        // and at the end; unknown where nothing audits the load.
        double load_correction = unknown, load_ci95 = unknown, load_ci95_late = unknown;
    } audit;
    std::optional<bool> surrogate_knows_this_sand;      // of a screening run; else the key is absent
    std::vector<std::string> warnings;                  // what makes the results doubtful, a line each
    std::vector<std::pair<std::string, double>> extra;  // further keys, behind the fixed ones

    double number(const std::string& key) const;  // of `extra`; NaN if it has none such
};

std::string to_json(const Summary& summary);
void write_summary(const std::filesystem::path& path, const Summary& summary);  // atomic

// InputError when the file is missing or not JSON with the fixed keys. `extra` holds the other numbers.
Summary read_summary(const std::filesystem::path& path);

}  // namespace sandgraph::io
