#include "surrogate/check_model.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "surrogate/features.hpp"

namespace sandgraph::surrogate {
namespace {

class Check {
  public:
    explicit Check(const std::string& file) : file_(file) {}

    void in(const std::string& name, double value, double low, double high) const {
        if (value >= low && value <= high) return;
        refuse(fmt::format("{} is {}", name, value), fmt::format("{} to {} expected", low, high));
    }
    void length(const std::string& name, std::size_t found, std::size_t wanted) const {
        if (found != wanted)
            refuse(fmt::format("{} has {} entries", name, found), fmt::format("{} expected", wanted));
    }
    void all_in(const std::string& name, const std::vector<double>& values, std::size_t count, double low,
                double high) const {
        length(name, values.size(), count);
        for (const double v : values) in("an entry of " + name, v, low, high);
    }
    [[noreturn]] void refuse(const std::string& problem, const std::string& why) const {
        throw InputError({file_}, problem, why, "train the model again with 'sandgraph train'");
    }

  private:
    std::string file_;
};

constexpr double tiny = 1e-12;

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

void check_ranges(const Check& check, const Model& model) {
    for (std::size_t i = 0; i < feature_count; ++i) {
        const std::string name = fmt::format("the trained range of '{}'", feature_names[i]);
        check.in(name, model.ranges[i].low, -1e3, 1e3);
        check.in(name, model.ranges[i].high, -1e3, 1e3);
        if (!(model.ranges[i].high - model.ranges[i].low >= 1e-6))
            check.refuse(name + " is empty", "low must be below high");
    }
}

void check_layers(const Check& check, const std::string& name, const Model& model, const Member& member) {
    std::size_t width = feature_count;
    for (std::size_t l = 0; l < member.layers.size(); ++l) {
        const Layer& layer = member.layers[l];
        const std::string here = fmt::format("{}/layer_{}", name, l);
        if (layer.inputs != width || layer.outputs < 1 || layer.outputs > max_width)
            check.refuse(fmt::format("{} is {} x {}", here, layer.outputs, layer.inputs),
                         fmt::format("{} inputs and 1 to {} outputs expected", width, max_width));
        check.all_in(here + "/weight", layer.weight, layer.outputs * layer.inputs, -1e3, 1e3);
        check.all_in(here + "/bias", layer.bias, layer.outputs, -1e3, 1e3);
        width = layer.outputs;
    }
    if (!member.layers.empty()) check.length(name + " answers", width, 3 * model.elements + 1);
}

void check_member(const Check& check, const std::string& name, const Model& model, const Member& m) {
    check.in(name + "/exponent", m.exponent, 0, 1);
    check.in(name + "/bulk", m.bulk, 0.02 * model.bounds.bulk, 5 / model.bounds.bulk);
    check.in(name + "/critical_mature", m.critical.mature, 1e-3, 1e9);
    check.in(name + "/critical_pull", m.critical.pull, 0, 10);
    check.in(name + "/critical_void_ratio", m.critical.void_ratio, 0.01, 2);
    check.in(name + "/critical_slope", m.critical.slope, 0, 0.1);
    check.all_in(name + "/share", m.share, model.elements, tiny, 1);
    check.in("the sum of " + name + "/share", sum(m.share), 1 - 1e-9, 1 + 1e-9);
    check.all_in(name + "/strength", m.strength, model.elements, tiny, 1);
    check.in("the sum of " + name + "/strength", sum(m.strength), tiny, 1);
    check.all_in(name + "/dilatancy", m.dilatancy, model.elements, -5, 5);
    check_layers(check, name, model, m);
}

}  // namespace

void check_model(const Model& model, const std::string& file) {
    const Check check(file);
    if (model.features != feature_version)
        check.refuse(fmt::format("the model's features are version {}", model.features),
                     fmt::format("this program computes version {}", feature_version));
    check.in("the number of elements", static_cast<double>(model.elements), 1, max_elements);
    check.in("the number of members", static_cast<double>(model.members.size()), 1, max_members);
    check.in("substep", model.substep, 1e-6, 1e-2);
    check.in("bound_shear", model.bounds.shear, 1, 5);
    check.in("bound_strength", model.bounds.strength, 1, 5);
    check.in("bound_bulk", model.bounds.bulk, 1, 5);
    check_ranges(check, model);
    for (std::size_t m = 0; m < model.members.size(); ++m)
        check_member(check, fmt::format("/member_{}", m), model, model.members[m]);
}

}  // namespace sandgraph::surrogate
