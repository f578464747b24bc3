// stability [--quick] [--list] [--only TEXT] [-o FILE [--resume]]: runs the cases whose name holds TEXT and
// prints a table; -o puts them into FILE.md and FILE.csv beside the cases that these hold already, which
// --resume does not run again. Exit code 1 when a case does not hold.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "stability/suite.hpp"
#include "stability/table.hpp"

namespace {

using namespace sandgraph::stability;

std::vector<Case> all_cases() {
    std::vector<Case> out;
    for (const std::span<const Case> group :
         {rve_cases(), rve_increment_cases(), column_cases(), time_step_cases(), falling_cases(),
          collapse_cases(), plate_cases(), mesh_cases(), gate_cases(), lying_cases(), repeat_cases(),
          killed_cases(), disk_cases()})
        out.insert(out.end(), group.begin(), group.end());
    return out;
}

// What FILE.csv holds of earlier runs.
std::vector<Outcome> measured(const std::string& file) {
    return std::filesystem::exists(file + ".csv") ? read_csv(file + ".csv") : std::vector<Outcome>();
}

// Puts the outcome in the place of an older one of the same case, and all into the order of the suite.
void record(std::vector<Outcome>& outcomes, Outcome outcome, std::span<const Case> cases) {
    std::erase_if(outcomes, [&](const Outcome& o) { return o.name == outcome.name; });
    outcomes.push_back(std::move(outcome));
    const auto place = [&](const Outcome& o) {
        return std::ranges::find(cases, o.name, [](const Case& c) { return std::string(c.name); }) -
               cases.begin();
    };
    std::ranges::stable_sort(outcomes, {}, place);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App cli("Cases that break solvers, with what was measured and its bounds");
    bool quick = false, list = false, resume = false;
    std::string only, file;
    cli.add_flag("--quick", quick, "shorter versions, as in every build");
    cli.add_flag("--list", list, "print the names of the cases");
    cli.add_flag("--resume", resume, "leave out what FILE.csv holds already, of whatever revision");
    cli.add_option("--only", only, "cases whose name holds this text");
    cli.add_option("-o", file, "FILE.md and FILE.csv, written after every case");
    CLI11_PARSE(cli, argc, argv);
    const std::vector<Case> cases = all_cases();
    std::vector<Outcome> outcomes = measured(file);
    const std::vector<Outcome> earlier = resume ? outcomes : std::vector<Outcome>();
    const auto write = [&] {
        if (!file.empty()) write_tables(file, fmt::format("stability{}", quick ? " --quick" : ""), outcomes);
    };
    for (const Case& c : cases) {
        if (std::string(c.name).find(only) == std::string::npos) continue;
        if (list) fmt::print("{}\n", c.name);
        if (list || std::ranges::any_of(earlier, [&](const Outcome& o) { return o.name == c.name; }))
            continue;
        Outcome outcome = run(c, quick ? Effort::quick : Effort::full);
        fmt::print("{}", markdown(std::span(&outcome, 1)));
        std::fflush(stdout);
        record(outcomes, std::move(outcome), cases);
        write();
    }
    if (!list) write();
    if (!list && outcomes.empty()) fmt::print(stderr, "no case of the name {}\n", only);
    return list || (!outcomes.empty() && std::ranges::all_of(outcomes, &Outcome::holds)) ? 0 : 1;
}
