// stability [--quick] [--list] [--only TEXT] [-o FILE]: runs the cases whose name holds TEXT and prints a
// table; -o writes FILE.md and FILE.csv. Exit code 1 when a case does not hold.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "app/revision.hpp"
#include "stability/suite.hpp"

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

void write(const std::string& file, std::span<const Outcome> outcomes, const std::string& head) {
    std::ofstream(file + ".md") << head << markdown(outcomes);
    std::ofstream(file + ".csv") << csv(outcomes);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App cli("Cases that break solvers, with what was measured and its bounds");
    bool quick = false, list = false;
    std::string only, file;
    cli.add_flag("--quick", quick, "shorter versions, as in every build");
    cli.add_flag("--list", list, "print the names of the cases");
    cli.add_option("--only", only, "cases whose name holds this text");
    cli.add_option("-o", file, "write FILE.md and FILE.csv");
    CLI11_PARSE(cli, argc, argv);
    std::vector<Outcome> outcomes;
    bool all_hold = true;
    for (const Case& c : all_cases()) {
        if (std::string(c.name).find(only) == std::string::npos) continue;
        if (list) {
            fmt::print("{}\n", c.name);
            continue;
        }
        outcomes.push_back(run(c, quick ? Effort::quick : Effort::full));
        all_hold = all_hold && outcomes.back().holds();
        fmt::print("{}", markdown(std::span(&outcomes.back(), 1)));
        std::fflush(stdout);
    }
    const std::string head = fmt::format("`stability{}{}`, revision {}\n\n", quick ? " --quick" : "",
                                         only.empty() ? "" : " --only " + only, sandgraph::app::revision());
    if (!file.empty()) write(file, outcomes, head);
    if (!list && outcomes.empty()) fmt::print(stderr, "no case of the name {}\n", only);
    return all_hold && (list || !outcomes.empty()) ? 0 : 1;
}
