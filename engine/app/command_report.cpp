#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "base/console.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "report/html.hpp"
#include "report/run_report.hpp"

namespace sandgraph::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFramesOfMany = 2;  // field pictures of a run beside others: breakout and end

struct Arguments {
    std::vector<std::string> folders;
    std::string out = "out/report";
    std::string critical;  // critical_state.csv
};

// The speed-against-error table of a `pareto` folder, when there is one.
std::string pareto_chapter(const std::vector<std::string>& folders) {
    std::string html;
    for (const std::string& folder : folders)
        if (fs::exists(fs::path(folder) / "pareto.png"))
            html += "<h2>Speed against error</h2>\n" +
                    report::figure(fs::path(folder) / "pareto.png",
                                   "Gate thresholds from all grains to all surrogate");
    return html;
}

void run(const Arguments& a) {
    const std::vector<results::FinishedRun> runs = results::find_runs(a.folders);
    const fs::path out = a.out;
    const io::FolderLock owner(out);
    std::string body =
        fmt::format("<h1>Plate anchors in sand</h1>\n<p class=\"lead\">{} run{}; made by sandgraph</p>\n",
                    runs.size(), runs.size() == 1 ? "" : "s");
    report::ChapterOptions options;
    if (runs.size() > 1) options.frames_max = kFramesOfMany;
    if (!a.critical.empty()) options.critical = report::read_critical_lines(a.critical);
    StageProgress progress;
    if (runs.size() > 1) body += report::comparison_chapter(runs, out / "pictures");
    body += pareto_chapter(a.folders);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        progress.update("pictures", static_cast<double>(k) / static_cast<double>(runs.size()));
        body += report::run_chapter(
            runs[k], out / "pictures" / fmt::format("{:02}_{}", k, runs[k].folder.filename().string()),
            options);
    }
    io::write_text(out / "index.html", report::page("sandgraph report", body));
    fmt::print("report in {}\n", (out / "index.html").string());
}

}  // namespace

void add_report_command(CLI::App& app, int& exit_code) {
    auto a = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("report", "one page with the results and pictures of finished runs");
    command->add_option("folders", a->folders, "run folders, or folders of them")->required();
    command->add_option("-o,--out", a->out, "folder of index.html and the pictures (default: out/report)");
    command->add_option("--critical", a->critical,
                        "critical_state.csv of `rve critical`, for the stress paths of regions");
    command->callback([a, &exit_code] {
        run(*a);
        exit_code = exit_done;
    });
}

}  // namespace sandgraph::app
