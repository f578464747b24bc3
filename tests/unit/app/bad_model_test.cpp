#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>

#include "io/content.hpp"
#include "support/paths.hpp"
#include "surrogate/model_file.hpp"
#include "tests/support/random_model.hpp"
#include "tests/support/subprocess.hpp"

namespace sandgraph::app {
namespace {

// A short pull over 96 points.
constexpr const char* kScene = R"(
[domain]
width = "2 m"
depth = "3 m"
cell = "0.25 m"
[anchor]
embedment_ratio = 1
thickness = "0.25 m"
pull_to = 0.01
ramp = 0.002
[grains]
count = 60
[output]
load_every = 0.001
frames = [0, 0.01]
)";

using Change = std::function<void(surrogate::Model&)>;

const std::string kShipped = sandgraph::test::source_file("/configs/models/table1.surrogate.h5");

surrogate::Model shipped(const Change& change) {
    surrogate::Model model = surrogate::read_model(kShipped).model;
    change(model);
    return model;
}

std::string shipped_bytes() {
    std::ifstream in(kShipped, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string bytes_of(double value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

void scale_weights(surrogate::Model& model, double factor) {
    for (surrogate::Member& member : model.members)
        for (surrogate::Layer& layer : member.layers)
            for (double& weight : layer.weight) weight *= factor;
}

double number(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\":");
    return at == std::string::npos ? NAN : std::stod(json.substr(at + key.size() + 3));
}

class BadModel : public testing::Test {
  protected:
    BadModel() : shell_("bad_model") {
        setenv("SANDGRAPH_CACHE", shell_.path("cache").c_str(), 1);
        shell_.write("scene.toml", kScene);
    }
    ~BadModel() override { unsetenv("SANDGRAPH_CACHE"); }
    Shell::Outcome screen(const std::string& more = "") const {
        return shell_.run("run scene.toml -o out --mode screening --set surrogate.model=model.h5 " + more);
    }
    void write(const surrogate::Model& model) const {
        surrogate::write_model(shell_.path("model.h5"), model);
    }
    std::string sealed(const std::string& bytes) const {
        shell_.write("model.h5", bytes);
        io::seal(shell_.path("model.h5"));
        return shell_.read("model.h5");
    }
    void expect_refused(const std::string& bytes, const std::string& because) const {
        shell_.write("model.h5", bytes);
        const auto outcome = screen();
        EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find("model.h5"), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find(because), std::string::npos) << outcome.err;
        EXPECT_FALSE(shell_.exists("out"));
    }
    // The run ends with the load of full fidelity, or the model never got in.
    void expect_refused_or_caught() const {
        const auto outcome = screen();
        if (outcome.exit_code == 2) {
            EXPECT_NE(outcome.err.find("model.h5"), std::string::npos) << outcome.err;
            return;
        }
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        ASSERT_EQ(shell_.run("run scene.toml -o full").exit_code, 0);
        const std::string screened = shell_.read("out/summary.json"), full = shell_.read("full/summary.json");
        const double load = number(full, "peak_load_N_per_m");
        EXPECT_NEAR(number(screened, "peak_load_N_per_m"), load, 0.1 * load) << outcome.out;
        EXPECT_GT(number(screened, "dem_fraction_final"), 0.05);
        EXPECT_NE(outcome.out.find("handed over because of"), std::string::npos);
    }
    Shell shell_;
};

TEST_F(BadModel, WithWeightsThatAreNoNumbersIsRefused) {
    std::string bytes = shipped_bytes();
    const double weight = shipped([](surrogate::Model&) {}).members[1].layers[0].weight[3],
                 none = std::numeric_limits<double>::quiet_NaN();
    const std::size_t at = bytes.find(bytes_of(weight));
    ASSERT_NE(at, std::string::npos);
    expect_refused(sealed(bytes.replace(at, sizeof none, bytes_of(none))), "nan");
}

TEST_F(BadModel, CutShortIsRefused) {
    const std::string whole = shipped_bytes();
    for (const double share : {0.0, 0.1, 0.5, 0.9, 0.999})
        expect_refused(whole.substr(0, static_cast<std::size_t>(share * double(whole.size()))), "");
}

TEST_F(BadModel, WithRandomWeightsIsRefusedOrCaughtByTheGate) {
    write(support::random_model(5));
    expect_refused_or_caught();
}

TEST_F(BadModel, WithWeightsTenTimesTooLargeIsRefusedOrCaughtByTheGate) {
    write(shipped([](surrogate::Model& m) { scale_weights(m, 10); }));
    expect_refused_or_caught();
}

}  // namespace
}  // namespace sandgraph::app
