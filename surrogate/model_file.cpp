#include "surrogate/model_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/content.hpp"
#include "io/h5_attribute.hpp"
#include "io/h5_dataset.hpp"
#include "io/h5_file.hpp"
#include "surrogate/features.hpp"
#include "surrogate/model.hpp"
#include "surrogate/reference.hpp"
#include "surrogate/self_test.hpp"

namespace sandgraph::surrogate {
namespace {

namespace h5 = io::h5;
constexpr std::int64_t schema = 1;

std::string joined_feature_names() {
    std::string text;
    for (const char* name : feature_names) text += std::string(text.empty() ? "" : "; ") + name;
    return text;
}

void write_column(h5::Group& group, std::string_view name, const std::vector<double>& values) {
    h5::write(group, name, std::span<const double>(values), {values.size()}, "1", h5::Storage::contiguous);
}

// The scalars of the root, each once for both directions.
template <class Number>
void each_scalar(Number&& number, auto& model) {
    number("substep", model.substep);
    number("bound_shear", model.bounds.shear);
    number("bound_strength", model.bounds.strength);
    number("bound_bulk", model.bounds.bulk);
}

void write_root(h5::Group& root, const Model& model) {
    const auto integer = [&](const char* name, std::size_t value) {
        h5::set_attribute(root, ".", name, static_cast<std::int64_t>(value));
    };
    integer("feature_version", static_cast<std::size_t>(model.features));
    integer("elements", model.elements);
    integer("members", model.members.size());
    integer("frictional", model.frictional);
    each_scalar([&](const char* name, double v) { h5::set_attribute(root, ".", name, v); }, model);
    h5::set_attribute(root, ".", "data_hash", model.data_hash);
    h5::set_attribute(root, ".", "description", model.description);
}

void write_features(h5::Group group, const Model& model) {
    std::vector<double> low, high;
    for (const FeatureRange& range : model.ranges) low.push_back(range.low), high.push_back(range.high);
    write_column(group, "low", low);
    write_column(group, "high", high);
    h5::set_attribute(group, ".", "names", joined_feature_names());
}

// The scalars of a member, likewise.
template <class Number>
void each_constant(Number&& number, auto& member) {
    number("exponent", member.exponent);
    number("bulk", member.bulk);
    number("critical_mature", member.critical.mature);
    number("critical_pull", member.critical.pull);
    number("critical_void_ratio", member.critical.void_ratio);
    number("critical_slope", member.critical.slope);
}

void write_member(h5::Group group, const Member& member) {
    each_constant([&](const char* name, double v) { h5::set_attribute(group, ".", name, v); }, member);
    h5::set_attribute(group, ".", "layers", static_cast<std::int64_t>(member.layers.size()));
    write_column(group, "share", member.share);
    write_column(group, "strength", member.strength);
    write_column(group, "dilatancy", member.dilatancy);
    for (std::size_t l = 0; l < member.layers.size(); ++l) {
        const Layer& layer = member.layers[l];
        h5::Group here = group.create(fmt::format("layer_{}", l));
        h5::write(here, "weight", std::span<const double>(layer.weight), {layer.outputs, layer.inputs}, "1",
                  h5::Storage::contiguous);
        write_column(here, "bias", layer.bias);
    }
}

std::size_t read_count(const h5::Group& group, const char* name, std::size_t most) {
    const std::int64_t n = h5::get_integer(group, ".", name);
    if (n < 0 || n > static_cast<std::int64_t>(most))
        h5::refuse(group, fmt::format("the attribute '{}' is {}", name, n),
                   fmt::format("0 to {} expected", most));
    return static_cast<std::size_t>(n);
}

void read_features(const h5::Group& group, Model& model) {
    if (h5::get_text(group, ".", "names") != joined_feature_names())
        h5::refuse(group, "the model was trained for other features", h5::get_text(group, ".", "names"));
    const auto low = h5::read<double>(group, "low"), high = h5::read<double>(group, "high");
    if (low.size() != feature_count || high.size() != feature_count)
        h5::refuse(group, "the trained ranges are incomplete", fmt::format("{} expected", feature_count));
    for (std::size_t i = 0; i < feature_count; ++i) model.ranges[i] = {low[i], high[i]};
}

Layer read_layer(const h5::Group& group) {
    const h5::Shape shape = h5::shape(group, "weight");
    if (shape.size() != 2)
        h5::refuse(group, group.path_of("weight") + " is no matrix", "outputs x inputs expected");
    return {shape[1], shape[0], h5::read<double>(group, "weight"), h5::read<double>(group, "bias")};
}

Member read_member(const h5::Group& group) {
    Member member;
    each_constant([&](const char* name, double& v) { v = h5::get_real(group, ".", name); }, member);
    member.share = h5::read<double>(group, "share");
    member.strength = h5::read<double>(group, "strength");
    member.dilatancy = h5::read<double>(group, "dilatancy");
    for (std::size_t l = 0, n = read_count(group, "layers", 8); l < n; ++l)
        member.layers.push_back(read_layer(group.open(fmt::format("layer_{}", l))));
    return member;
}

Model read_numbers(const h5::Group& root) {
    Model model;
    model.features = static_cast<int>(h5::get_integer(root, ".", "feature_version"));
    if (model.features != feature_version) return model;  // check_model says so
    model.elements = read_count(root, "elements", max_elements);
    model.frictional = read_count(root, "frictional", 1) == 1;
    each_scalar([&](const char* name, double& v) { v = h5::get_real(root, ".", name); }, model);
    model.data_hash = h5::get_text(root, ".", "data_hash");
    model.description = h5::get_text(root, ".", "description");
    read_features(root.open("features"), model);
    for (std::size_t m = 0, n = read_count(root, "members", max_members); m < n; ++m)
        model.members.push_back(read_member(root.open(fmt::format("member_{}", m))));
    return model;
}

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

void write_model(const std::filesystem::path& path, const Model& model) {
    check_model(model, path.string());
    const Reference law(model);
    io::AtomicFile target(path);
    h5::File file = h5::File::create(target.temporary(), io::seal_size);
    h5::Group root = file.root();
    io::mark_content(root, "surrogate", schema);
    write_root(root, model);
    write_features(root.create("features"), model);
    for (std::size_t m = 0; m < model.members.size(); ++m)
        write_member(root.create(fmt::format("member_{}", m)), model.members[m]);
    write_column(root, "self_test", self_test_answers(model, law));
    file.close();
    io::seal(target.temporary());
    target.commit();
}

ModelRecord read_model(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path))
        throw InputError({path.string()}, "no such model file", "", "train one with 'sandgraph train'");
    if (const auto problem = io::broken_seal(path))
        throw InputError({path.string()}, "the model file is damaged", *problem, "copy or train it again");
    const h5::File file = h5::File::open(path);
    const h5::Group root = file.root();
    io::require_content(root, "surrogate", schema);
    ModelRecord record{read_numbers(root), h5::read<double>(root, "self_test")};
    check_model(record.model, path.string());
    return record;
}

}  // namespace sandgraph::surrogate
