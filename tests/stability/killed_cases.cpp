#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <thread>

#include "base/random.hpp"
#include "io/checkpoint.hpp"
#include "io/run_record.hpp"
#include "stability/run_digest.hpp"
#include "stability/run_folder.hpp"

namespace sandgraph::stability {
namespace {

namespace fs = std::filesystem;

struct Wreck {
    int kills = 0, writing = 0, before_checkpoint = 0, unreadable = 0, odd_exits = 0;
};

// After a kill: run.h5 is a whole file and load.csv ends with a whole row.
bool readable(const fs::path& folder) {
    if (!fs::exists(folder / "run.h5")) return true;
    io::read_run(folder / "run.h5");
    std::ifstream csv(folder / "load.csv");
    const std::string text{std::istreambuf_iterator<char>(csv), {}};
    return text.empty() || text.back() == '\n';
}

// A writer was killed: its file stands there under its temporary name.
bool holds_temporary(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".tmp") return true;
    return false;
}

// Every output but the scene's text, where checkpoint_every differs.
std::map<std::string, std::string> results(const fs::path& folder) {
    auto all = digest(folder);
    std::erase_if(all, [](const auto& entry) { return entry.first.ends_with("@text"); });
    return all;
}

// Starts or resumes, and kills at a random moment of [0, longest] s; true when the run was over before.
bool start_and_kill(const RunFolder& folder, const std::string& name, double longest, Random& random,
                    Wreck& wreck) {
    // Every other round writes a checkpoint at each step, so that most kills hit one being written.
    const char* often = wreck.kills % 2 ? "output.checkpoint_every=1 ms" : "output.checkpoint_every=50 ms";
    std::vector<std::string> words = {"--set", often};
    if (folder.can_resume(name)) words.push_back("--resume");
    const pid_t pid = folder.start(name, words);
    std::this_thread::sleep_for(std::chrono::duration<double>(random.uniform(0, longest)));
    const bool over = !support::program_runs(pid);
    if (!over) kill(pid, SIGKILL);
    const int code = support::finish_program(pid);
    if (over || code == 0) {
        wreck.odd_exits += code != 0;
        return true;
    }
    ++wreck.kills;
    wreck.odd_exits += code != 128 + SIGKILL;
    wreck.writing += holds_temporary(folder / name);
    wreck.before_checkpoint += !folder.can_resume(name);
    wreck.unreadable += !readable(folder / name);
    return false;
}

void killed(Effort effort, Findings& found, RunMode mode) {
    const int wanted = effort == Effort::quick ? 4 : 30;
    found.driven = fmt::format("{} run, SIGKILL at {} random moments, resumed each time",
                               mode == RunMode::full ? "full-fidelity" : "screening", wanted);
    RunFolder folder(effort, mode);
    const double longest = 0.7 * folder.seconds("whole");
    const auto whole = results(folder / "whole");
    Random random(effort == Effort::quick ? 1 : 2);
    Wreck wreck;
    int runs = 0;
    std::vector<std::string> differ;
    while (wreck.kills < wanted) {
        const std::string name = fmt::format("killed{}", runs++);
        while (wreck.kills < wanted && !start_and_kill(folder, name, longest, random, wreck)) {
        }
        // The last kill may have come after the summary and before the checkpoints were removed.
        if (folder.can_resume(name) || !fs::exists(folder / name / "summary.json"))
            wreck.odd_exits += folder.can_resume(name) ? folder.run(name, {"--resume"}) : folder.run(name);
        std::ranges::copy(differences(whole, results(folder / name)), std::back_inserter(differ));
    }
    found.exactly("kills", wreck.kills, wanted);
    found.note("of them while a checkpoint or run.h5 was being written", wreck.writing);
    found.note("of them before the first checkpoint: started anew", wreck.before_checkpoint);
    found.exactly("run.h5 or load.csv not readable after a kill", wreck.unreadable, 0);
    found.exactly("unexpected exit codes", wreck.odd_exits, 0);
    found.note("runs that the kills were spread over", runs);
    check_same("the uninterrupted run" + (differ.empty() ? "" : ", kept in " + folder.keep()), differ, found);
}

void asked(Effort effort, Findings& found, int signal, const char* name) {
    found.driven = fmt::format("{} after the first checkpoint, then --resume", name);
    const RunFolder folder(effort, RunMode::full);
    folder.run("whole");
    const pid_t pid = folder.start("asked");
    folder.await_checkpoint(pid, "asked");
    const auto begin = std::chrono::steady_clock::now();
    kill(pid, signal);
    found.exactly("exit code: stopped early, can be resumed", support::finish_program(pid), 3);
    found.note("seconds to the end",
               std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    found.exactly("says how to go on", folder.log("asked").find("--resume") != std::string::npos, 1);
    found.exactly("exit code of the resumed run", folder.run("asked", {"--resume"}), 0);
    check_same("the uninterrupted run", differences(digest(folder / "whole"), digest(folder / "asked")),
               found);
}

constexpr std::array table = {
    Case{"lost.killed.full", [](Effort e, Findings& f) { killed(e, f, RunMode::full); }},
    Case{"lost.killed.screening", [](Effort e, Findings& f) { killed(e, f, RunMode::screening); }},
    Case{"lost.asked.SIGTERM", [](Effort e, Findings& f) { asked(e, f, SIGTERM, "SIGTERM"); }},
    Case{"lost.asked.SIGINT", [](Effort e, Findings& f) { asked(e, f, SIGINT, "SIGINT (Ctrl-C)"); }},
};

}  // namespace

std::span<const Case> killed_cases() { return table; }

}  // namespace sandgraph::stability
