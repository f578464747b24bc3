#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/command_rve.hpp"
#include "base/console.hpp"
#include "io/atomic_file.hpp"
#include "io/folder_lock.hpp"
#include "laboratory/friction_table.hpp"
#include "laboratory/soil_laboratory.hpp"
#include "report/biaxial_picture.hpp"

namespace sandgraph::app {
namespace {

struct Options {
    std::string folder = "out/table1";
    laboratory::LaboratoryPlan plan;
    bool quick = false;
};

constexpr int kQuickSeeds = 2;

// A first look: two seeds, and four times the rate, which moves a peak by up to 2 deg, as another seed does.
laboratory::LaboratoryPlan shortened(laboratory::LaboratoryPlan plan) {
    plan.seeds = std::min(plan.seeds, kQuickSeeds);
    plan.test.axial_rate = 0.4;
    return plan;
}

std::vector<laboratory::FrictionRow> friction_rows(const std::vector<laboratory::Specimen>& specimens) {
    std::vector<laboratory::FrictionRow> rows;
    for (const laboratory::Specimen& specimen : specimens) rows.push_back(laboratory::friction_row(specimen));
    return rows;
}

report::BiaxialPicture picture_of(const std::string& density,
                                  const std::vector<laboratory::Specimen>& specimens) {
    report::BiaxialPicture picture{fmt::format("Biaxial compression, {} sand of Table 1", density), {}};
    for (std::size_t k = 0; k < dem::confining_pressures.size(); ++k) {
        report::BiaxialSeries series{dem::confining_pressures[k], {}};
        for (const laboratory::Specimen& specimen : specimens)
            if (specimen.density == density) series.tests.push_back(specimen.tests[k]);
        picture.series.push_back(std::move(series));
    }
    return picture;
}

void draw_pictures(const std::filesystem::path& folder, const std::vector<laboratory::Specimen>& specimens) {
    for (const std::string density : laboratory::kDensities) {
        const auto picture = report::draw_biaxial_picture(picture_of(density, specimens),
                                                          folder / fmt::format("biaxial_{}.png", density));
        if (!picture.drawn) fmt::print(stderr, "{}\n", picture.message);
    }
}

std::vector<laboratory::Specimen> test_with_progress(const laboratory::LaboratoryPlan& plan) {
    StageProgress progress;
    return laboratory::test_specimens(
        plan, [&](std::string_view stage, double fraction) { progress.update(stage, fraction); });
}

void run(const Options& options) {
    const std::filesystem::path folder = options.folder;
    const io::FolderLock owner(folder);
    const auto specimens = test_with_progress(options.quick ? shortened(options.plan) : options.plan);
    const std::vector<laboratory::FrictionRow> rows = friction_rows(specimens);
    io::write_text(folder / "table1.csv", laboratory::friction_csv(rows));
    draw_pictures(folder, specimens);
    fmt::print("{}{}: table1.csv, biaxial_dense.png, biaxial_loose.png\n", laboratory::friction_table(rows),
               options.folder);
}

}  // namespace

void add_rve_table(CLI::App& rve) {
    CLI::App* table =
        rve.add_subcommand("table", "peak friction of Table 1 sand: biaxial tests over several seeds");
    auto options = std::make_shared<Options>();
    table->add_option("-o,--out", options->folder, "folder for table and pictures")->capture_default_str();
    CLI::Option* seeds = table->add_option("--seeds", options->plan.seeds, "packings of each density");
    seeds->check(CLI::Range(1, 1000))->capture_default_str();
    table->add_option("--grains", options->plan.grains, "disks in a packing")
        ->check(CLI::Range(50, 10000))
        ->capture_default_str();
    table->add_flag("--quick", options->quick, "at most two seeds, four times the axial rate");
    table->callback([options, seeds] {
        if (options->quick && seeds->count() > 0 && options->plan.seeds > kQuickSeeds)
            throw CLI::ValidationError("--quick", "takes two seeds at most, --seeds asks for more");
        run(*options);
    });
}

}  // namespace sandgraph::app
