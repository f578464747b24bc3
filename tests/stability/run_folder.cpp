#include "stability/run_folder.hpp"

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "io/checkpoint.hpp"
#include "support/paths.hpp"

namespace sandgraph::stability {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene = R"(
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
[domain]
width = "2 m"
depth = "3 m"
cell = "0.25 m"
[grains]
count = 100
[output]
load_every = 0.001
frames = [0, 0.01, 0.02, 0.03]
checkpoint_every = "0.05 s"
[[region]]
name = "band"
x = [0.5, 0.8]
y = [0.2, 0.7]
packings = [0, 0.01, 0.02]
[[region]]
name = "above"
at = [0.2, 0.3]
)";

std::vector<std::string> settings(Effort effort, RunMode mode) {
    std::vector<std::string> out = {effort == Effort::quick ? "anchor.pull_to=0.03" : "anchor.pull_to=0.06"};
    if (mode == RunMode::screening)
        out.insert(out.end(), {"mode=screening", "audit.share=0.25", "audit.every=0.005"});
    if (mode == RunMode::full) out.insert(out.end(), {"output.history=true", "output.history_points=12"});
    return out;
}

}  // namespace

RunFolder::RunFolder(Effort effort, RunMode mode) {
    static int count = 0;
    folder_ = fs::temp_directory_path() /
              ("sandgraph-stability-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    fs::create_directories(folder_);
    std::ofstream(folder_ / "scene.toml") << kScene;
    if (mode == RunMode::screening)
        always_ = {"--set",
                   "surrogate.model=" + sandgraph::test::source_file("/configs/models/table1.surrogate.h5")};
    for (const std::string& s : settings(effort, mode)) always_.insert(always_.end(), {"--set", s});
}

RunFolder::~RunFolder() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(folder_, ignored);
}

pid_t RunFolder::start(const std::string& name, const std::vector<std::string>& more,
                       const support::ProgramLimits& limits) const {
    std::vector<std::string> words = {sandgraph::test::program(), "run", (folder_ / "scene.toml").string(),
                                      "-o", (folder_ / name).string()};
    words.insert(words.end(), always_.begin(), always_.end());
    words.insert(words.end(), more.begin(), more.end());
    return support::start_program(std::move(words), folder_ / (fs::path(name).filename().string() + ".log"),
                                  limits);
}

int RunFolder::run(const std::string& name, const std::vector<std::string>& more,
                   const support::ProgramLimits& limits) const {
    return support::finish_program(start(name, more, limits));
}

double RunFolder::seconds(const std::string& name) const {
    const auto begin = std::chrono::steady_clock::now();
    if (const int code = run(name); code != 0)
        throw std::runtime_error("the uninterrupted run ended with " + std::to_string(code) + ": " +
                                 log(name));
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void RunFolder::await_checkpoint(pid_t pid, const std::string& name, bool and_previous) const {
    const fs::path checkpoint = folder_ / name / io::checkpoint_name,
                   wanted = and_previous ? io::previous_checkpoint(checkpoint) : checkpoint;
    while (!fs::exists(wanted) && support::program_runs(pid))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

std::string RunFolder::log(const std::string& name) const {
    std::ifstream in(folder_ / (fs::path(name).filename().string() + ".log"));
    return (std::ostringstream() << in.rdbuf()).str();
}

bool RunFolder::can_resume(const std::string& name) const {
    const fs::path checkpoint = folder_ / name / io::checkpoint_name;
    return fs::exists(checkpoint) || fs::exists(io::previous_checkpoint(checkpoint));
}

}  // namespace sandgraph::stability
