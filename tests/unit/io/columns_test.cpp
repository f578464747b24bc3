#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "base/error.hpp"
#include "base/text.hpp"
#include "io/content.hpp"
#include "io/frame.hpp"
#include "io/h5_file.hpp"
#include "io/load_columns.hpp"
#include "io/packing_file.hpp"
#include "io/region_series.hpp"
#include "io/screening_record.hpp"
#include "io/summary.hpp"
#include "tests/unit/io/scratch.hpp"

// Every number of its own value, so that no column can stand in another's place.
namespace sandgraph::io {
namespace {

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> out;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
    return out;
}

TEST(LoadColumns, EachValueStandsUnderItsOwnName) {
    const LoadRow row{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13};
    const std::vector<std::string> names = cells(load_csv_header()), values = cells(load_csv_line(row));
    const std::vector<std::string> expected{"d_over_B",
                                            "load_N_per_m",
                                            "top_N_per_m",
                                            "bottom_N_per_m",
                                            "time_s",
                                            "kinetic_energy_J_per_m",
                                            "strain_work_J_per_m",
                                            "plate_work_J_per_m",
                                            "rve_active",
                                            "dem_steps",
                                            "damping_share",
                                            "pic_share",
                                            "inertia_share"};
    ASSERT_GE(names.size(), expected.size());  // columns are added at the end
    for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_EQ(names[k], expected[k]);
        EXPECT_EQ(values[k], std::to_string(k + 1));
    }
}

TEST(LoadColumns, OfTheErrorBarStandBehindTheOthersAndOnlyWhereTheLoadIsAudited) {
    const LoadRow row{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    const std::string plain = load_csv_header(), audited = load_csv_header(true);
    EXPECT_EQ(audited, plain + ",load_corrected_N_per_m,load_low_N_per_m,load_high_N_per_m");
    EXPECT_EQ(load_csv_line(row, true), load_csv_line(row) + ",14,15,16");
}

// Mean, least and largest of quantity k are 100 k + 1, 2 and 3.
RegionSeries numbered() {
    RegionRow row;
    row.d_over_B = 0.5, row.time = 7;
    double base = 0;
    for (Spread* s :
         {&row.p, &row.q, &row.sigma_xx, &row.sigma_yy, &row.sigma_xy, &row.K, &row.porosity, &row.anisotropy,
          &row.coordination, &row.strain, &row.volume_strain, &row.rotation, &row.x, &row.y})
        base += 100, *s = {base + 1, base + 2, base + 3};
    return {"A", 4, {row}};
}

TEST(RegionCsv, EachValueStandsUnderItsOwnName) {
    std::istringstream text(region_csv({numbered()}));
    std::string head, line;
    std::getline(text, head), std::getline(text, line);
    const std::vector<std::string> names = cells(head), values = cells(line);
    ASSERT_EQ(names.size(), values.size());
    const char* quantities[] = {
        "p",        "q",          "sigma_xx",     "sigma_yy", "sigma_xy",      "K",
        "porosity", "anisotropy", "coordination", "strain",   "volume_strain", "rotation",
        "x",        "y"};
    const char* statistics[] = {"mean", "min", "max"};
    for (std::size_t k = 0; k < 14; ++k)
        for (std::size_t s = 0; s < 3; ++s) {
            EXPECT_EQ(names[3 + 3 * k + s], std::string(quantities[k]) + "_" + statistics[s]);
            EXPECT_EQ(values[3 + 3 * k + s], std::to_string(100 * (k + 1) + s + 1));
        }
    EXPECT_EQ(values.back(), "7");
}

TEST(Regions, ComeBackFromAFileAsTheyWere) {
    const test::Scratch scratch;
    {
        h5::File file = h5::File::create(scratch / "a.h5");
        h5::Group root = file.root();
        write_regions(root, {numbered()});
    }
    const h5::File file = h5::File::open(scratch / "a.h5");
    EXPECT_EQ(region_csv(read_regions(file.root())), region_csv({numbered()}));
}

TEST(ScreeningRecord, ComesBackFromAFileAsItWas) {
    const test::Scratch scratch;
    ScreeningRecord record;
    record.reasons = {"none", "strain"};
    record.switches = {{3, 0.25, 7, stress::Reason::strain, 0.5, 0.125, 0.0625}};
    record.audits = {{0.75, 4, 9, 0.01, 0.002}};
    {
        h5::File file = h5::File::create(scratch / "a.h5");
        h5::Group root = file.root();
        write_screening(root, record);
    }
    const h5::File file = h5::File::open(scratch / "a.h5");
    const ScreeningRecord read = read_screening(file.root());
    EXPECT_EQ(read.reasons, record.reasons);
    const stress::Switch& s = read.switches.at(0);
    EXPECT_EQ(s.step, 3);
    EXPECT_EQ(s.d_over_B, 0.25);
    EXPECT_EQ(s.point, 7);
    EXPECT_EQ(s.reason, stress::Reason::strain);
    EXPECT_EQ(s.jump, 0.5);
    EXPECT_EQ(s.felt, 0.125);
    EXPECT_EQ(s.ordinary, 0.0625);
    const stress::AuditRow& a = read.audits.at(0);
    EXPECT_EQ(a.d_over_B, 0.75);
    EXPECT_EQ(a.points, 4);
    EXPECT_EQ(a.population, 9);
    EXPECT_EQ(a.mean, 0.01);
    EXPECT_EQ(a.ci95, 0.002);
}

TEST(Frame, ComesBackFromAFileAsItWas) {
    const test::Scratch scratch;
    Frame frame{1, 2, 3, 4, {5, 6}, {7, 8}, {{"porosity", "-", 1, {9, 10}}}};
    {
        h5::File file = h5::File::create(scratch / "a.h5");
        write_frame(file.root().create("f"), frame);
    }
    const h5::File file = h5::File::open(scratch / "a.h5");
    const Frame read = read_frame(file.root().open("f"));
    EXPECT_EQ((std::vector<double>{read.time, read.d_over_B, read.plate_x, read.plate_y}),
              (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(read.x, frame.x);
    EXPECT_EQ(read.y, frame.y);
    EXPECT_EQ(read.fields.at(0).values, frame.fields[0].values);
}

TEST(Summary, EachNumberStandsUnderItsOwnKey) {
    Summary s;
    s.points = 1, s.steps = 2, s.wall_s = 3, s.cpu_s = 4, s.dem_steps = 5, s.rve_updates = 6;
    s.surrogate_updates = 7, s.dem_fraction_final = 8, s.dem_fraction_mean = 9, s.breakout_load = 10;
    s.breakout_d_over_B = 11, s.n_gamma = 12, s.n_gamma_meyerhof_adams = 13, s.n_gamma_biarez = 14;
    s.late_load = 15, s.kinetic_to_strain_energy_max = 16, s.threads = 17;
    s.audit = {18, 19, 20};
    const std::string json = to_json(s);
    int k = 0;
    for (const char* key :
         {"points", "steps", "wall_s", "cpu_s", "dem_steps", "rve_updates", "surrogate_updates",
          "dem_fraction_final", "dem_fraction_mean", "peak_load_N_per_m", "peak_d_over_B", "n_gamma",
          "n_gamma_meyerhof_adams", "n_gamma_biarez", "late_load_N_per_m", "kinetic_to_strain_energy_max",
          "threads"}) {
        const std::string begin = fmt::format("\"{}\": ", key);
        const std::size_t at = json.find(begin);
        ASSERT_NE(at, std::string::npos) << key;
        EXPECT_EQ(std::stod(json.substr(at + begin.size())), ++k) << key;
    }
    for (const char* key : {"stress_error_mean\": 19", "ci95\": 20"})
        EXPECT_NE(json.find(key), std::string::npos);
}

TEST(Content, OfAnotherSchemaIsRefusedOlderOrNewer) {
    const test::Scratch scratch;
    {
        h5::File file = h5::File::create(scratch / "a.h5");
        h5::Group root = file.root();
        mark_content(root, "run", 3);
    }
    const h5::File file = h5::File::open(scratch / "a.h5");
    EXPECT_NO_THROW(require_content(file.root(), "run", 3));
    EXPECT_THROW(require_content(file.root(), "run", 2), InputError);
    EXPECT_THROW(require_content(file.root(), "run", 4), InputError);
    EXPECT_THROW(require_content(file.root(), "packing", 3), InputError);
}

TEST(Content, ItsSealTellsTheLengthOfWhatFollows) {
    const test::Scratch scratch;
    test::overwrite(scratch / "a", std::string(seal_size + 70'000, 'x'));
    seal(scratch / "a");
    EXPECT_FALSE(broken_seal(scratch / "a"));
    EXPECT_EQ(test::contents(scratch / "a").rfind("sandgraph seal 1\nlength 70000\n", 0), 0u);
}

}  // namespace
}  // namespace sandgraph::io
