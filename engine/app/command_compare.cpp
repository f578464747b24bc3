#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "results/compare_runs.hpp"

namespace sandgraph::app {
namespace {

struct Arguments {
    std::string reference, other;
    bool json = false;
};

// A line when their times are not those of one program on as many threads; else nothing.
std::string unlike(const io::Summary& a, const io::Summary& b) {
    if (a.threads == b.threads && a.git == b.git) return "";
    return fmt::format(
        "notice: the ratios of time are not like for like: {} threads of {} against {} of {}\n", a.threads,
        a.git, b.threads, b.git);
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("compare", "error and speed of one run against another");
    command->add_option("reference", a->reference, "run folder")->required();
    command->add_option("other", a->other, "run folder")->required();
    command->add_flag("--json", a->json, "as JSON");
    command->callback([a, &exit_code] {
        const results::FinishedRun reference = results::read_finished_run(a->reference),
                                   other = results::read_finished_run(a->other);
        const results::Comparison c = results::compare_runs(reference, other);
        fmt::print(stderr, "{}", unlike(reference.summary, other.summary));
        fmt::print("{}", a->json ? results::to_json(c) : results::to_text(c));
        exit_code = exit_done;
    });
}

}  // namespace sandgraph::app
