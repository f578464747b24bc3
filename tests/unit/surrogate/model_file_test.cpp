#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <limits>

#include "base/error.hpp"
#include "io/info.hpp"
#include "support/paths.hpp"
#include "surrogate/load_surrogate.hpp"
#include "surrogate/model.hpp"
#include "surrogate/model_file.hpp"
#include "surrogate/self_test.hpp"
#include "tests/unit/surrogate/driver.hpp"

namespace sandgraph::surrogate {
namespace {

namespace fs = std::filesystem;

class ModelFile : public testing::Test {
  protected:
    ModelFile() { fs::create_directories(folder_); }
    ~ModelFile() override { fs::remove_all(folder_); }

    fs::path written(const Model& model) const {
        write_model(folder_ / "model.h5", model);
        return folder_ / "model.h5";
    }
    std::string bytes(const fs::path& path) const {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    fs::path with_bytes(const std::string& text) const {
        const fs::path path = folder_ / "changed.h5";
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }

  private:
    fs::path folder_ =
        fs::temp_directory_path() /
        (std::string("sandgraph_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

std::string refusal(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

TEST_F(ModelFile, ServesTheSameBitsAsTheModelItWasWrittenFrom) {
    const Model model = support::random_model(1);
    const auto loaded = load_surrogate(written(model));
    const auto made = make_surrogate(model);
    Driver a(*loaded), b(*made);
    for (const Mat2& F : random_path(2)) EXPECT_EQ(a.drive(F).stress, b.drive(F).stress);
}

TEST_F(ModelFile, EveryRungIsServed) {
    Model elastic = support::random_model(1, {1, 3, 0, 0});
    elastic.frictional = false;
    const auto law = load_surrogate(written(elastic));
    Driver point(*law);
    const Stress s = point.drive(gradient(-1e-6, -1e-6, 0, 0)).stress;
    EXPECT_GT(mean_stress(s), mean_stress(support::rest_stress()));
    EXPECT_NO_THROW(load_surrogate(written(support::random_model(1, {4, 8, 0, 0}))));
    EXPECT_NO_THROW(load_surrogate(written(support::random_model(1, {5, 8, 16, 3}))));
}

TEST_F(ModelFile, InfoDescribesAndVerifiesIt) {
    const fs::path path = written(support::random_model(1));
    const std::string text = io::info(path);
    for (const char* word : {"checksum verified", "content = \"surrogate\"", "feature_version", "member_3/",
                             "float64 (16 x 9)", "random weights, for tests"})
        EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
    std::string bad = bytes(path);
    bad[bad.size() / 2] ^= 1;
    EXPECT_NE(refusal([&] { io::info(with_bytes(bad)); }), "");
}

TEST_F(ModelFile, AnyFlippedByteIsRefused) {
    const std::string good = bytes(written(support::random_model(1, {1, 3, 4, 2})));
    for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 97) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x10);
        EXPECT_NE(refusal([&] { load_surrogate(with_bytes(bad)); }), "") << "byte " << at;
    }
}

TEST_F(ModelFile, TruncatedAtAnyLengthIsRefused) {
    const std::string good = bytes(written(support::random_model(1, {1, 3, 4, 2})));
    for (std::size_t length = 0; length < good.size(); length += 1 + good.size() / 23)
        EXPECT_NE(refusal([&] { load_surrogate(with_bytes(good.substr(0, length))); }), "") << length;
}

TEST_F(ModelFile, MissingFileIsRefused) {
    EXPECT_NE(refusal([&] { load_surrogate("no_such_model.h5"); }).find("no_such_model.h5: no such model"),
              std::string::npos);
}

// A change of a good model and the word its refusal must contain.
struct Defect {
    const char* word;
    std::function<void(Model&)> change;
};

const double nan_value = std::numeric_limits<double>::quiet_NaN();

const Defect defects[] = {
    {"nan", [](Model& m) { m.members[1].layers[0].weight[3] = nan_value; }},
    {"inf", [](Model& m) { m.members[0].layers[1].bias[0] = INFINITY; }},
    {"weight", [](Model& m) { m.members[0].layers[1].weight[0] = 1e6; }},
    {"weight has", [](Model& m) { m.members[0].layers[1].weight.pop_back(); }},
    {"inputs", [](Model& m) { m.members[0].layers[1].inputs = 7; }},
    {"answers", [](Model& m) { m.members[0].layers.pop_back(); }},
    {"version", [](Model& m) { m.features = feature_version + 1; }},
    {"substep", [](Model& m) { m.substep = 0; }},
    {"elements", [](Model& m) { m.elements = 0; }},
    {"members", [](Model& m) { m.members.clear(); }},
    {"exponent", [](Model& m) { m.members[0].exponent = 3; }},
    {"bulk", [](Model& m) { m.members[0].bulk = 40; }},
    {"bound_shear", [](Model& m) { m.bounds.shear = 50; }},
    {"sum of /member_0/share", [](Model& m) { m.members[0].share[0] *= 1.01; }},
    {"share", [](Model& m) { m.members[0].share[0] = -1; }},
    {"sum of /member_2/strength", [](Model& m) { m.members[2].strength[0] = 0.9; }},
    {"dilatancy", [](Model& m) { m.members[0].dilatancy[0] = nan_value; }},
    {"trained range", [](Model& m) { m.ranges[4].low = nan_value; }},
    {"empty",
     [](Model& m) {
         m.ranges[4] = {1, 1};
     }},
};

TEST(CheckModel, RefusesEveryDefectByName) {
    for (const Defect& defect : defects) {
        Model model = support::random_model(1);
        EXPECT_EQ(refusal([&] { check_model(model, "m.h5"); }), "");
        defect.change(model);
        const std::string text = refusal([&] { check_model(model, "m.h5"); });
        EXPECT_EQ(text.find("m.h5: "), 0u) << defect.word;
        EXPECT_NE(text.find(defect.word), std::string::npos) << defect.word << ": " << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
}

TEST(CheckModel, WeightsChangedAfterwardsFailTheSelfTest) {
    Model model = support::random_model(1);
    const std::vector<double> stored = self_test_answers(model, *make_surrogate(model));
    EXPECT_EQ(refusal([&] { check_self_test(model, *make_surrogate(model), stored, "m.h5"); }), "");
    model.members[3].layers[1].weight[7] += 1e-3;
    EXPECT_NE(refusal([&] { check_self_test(model, *make_surrogate(model), stored, "m.h5"); }), "");
}

TEST(CheckModel, ModuliFarFromThePackingsAreRefused) {
    Model model = support::random_model(1, {1, 4, 0, 0});
    EXPECT_EQ(refusal([&] { check_physics(model, *make_surrogate(model), "m.h5"); }), "");
    model.bounds.bulk = 1;
    model.members[0].bulk = 4;
    EXPECT_NE(refusal([&] { check_physics(model, *make_surrogate(model), "m.h5"); }).find("bulk modulus"),
              std::string::npos);
}

TEST(CheckModel, StrengthBeyondFrictionIsRefused) {
    Model model = support::random_model(1, {1, 2, 0, 0});
    model.members[0].strength = {0.5, 0.49};
    Layer boosted{feature_count, 7, std::vector<double>(7 * feature_count), {0, 0, 3, 3, 0, 0, 0}};
    model.members[0].layers = {boosted};
    EXPECT_NO_THROW(check_model(model, "m.h5"));
    EXPECT_NE(refusal([&] { check_physics(model, *make_surrogate(model), "m.h5"); }).find("q/p"),
              std::string::npos);
}

// Loading checks file, features, self test and physics: a change of the equations that leaves the shipped
// weights behind shows here.
TEST(ShippedModel, IsAcceptedByThisVersion) {
    EXPECT_NO_THROW(load_surrogate(sandgraph::test::source_file("/configs/models/table1.surrogate.h5")));
}

}  // namespace
}  // namespace sandgraph::surrogate
