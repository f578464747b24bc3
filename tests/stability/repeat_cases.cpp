#include <fmt/format.h>

#include <array>

#include "stability/run_digest.hpp"
#include "stability/run_folder.hpp"

namespace sandgraph::stability {
namespace {

void repeat(Effort effort, Findings& found, RunMode mode) {
    found.driven = fmt::format("a pull on 1, 2 and 4 threads, twice, and stopped and resumed, {}",
                               mode == RunMode::full ? "with the history log" : "screening, with audits");
    const RunFolder folder(effort, mode);
    int failed = folder.run("one", {"--threads", "1"});
    const auto one = digest(folder / "one");
    found.at_least("outputs compared: files, datasets, attributes, summary entries",
                   static_cast<double>(one.size()), 80);
    const auto compare = [&](const char* what, const std::string& name) {
        check_same(fmt::format("one thread: {}", what), differences(one, digest(folder / name)), found);
    };
    for (const char* threads : {"2", "4"}) {
        failed += folder.run(std::string("threads") + threads, {"--threads", threads});
        compare(fmt::format("{} threads", threads).c_str(), std::string("threads") + threads);
    }
    failed += folder.run("again", {"--threads", "4"});
    compare("4 threads once more", "again");
    for (const char* until : {"0.0073", "0.0151", "0.0222"}) {
        const std::string name = std::string("part") + until;
        failed += folder.run(name, {"--until", until, "--threads", "2"});
        failed += folder.run(name, {"--resume", "--threads", "4"});
        compare(fmt::format("stopped at {} B and resumed", until).c_str(), name);
    }
    found.exactly("exit codes, summed", failed, 0);
}

constexpr std::array table = {
    Case{"repeat.full", [](Effort e, Findings& f) { repeat(e, f, RunMode::full); }},
    Case{"repeat.screening", [](Effort e, Findings& f) { repeat(e, f, RunMode::screening); }}};

}  // namespace

std::span<const Case> repeat_cases() { return table; }

}  // namespace sandgraph::stability
