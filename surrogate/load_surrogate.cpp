#include "surrogate/load_surrogate.hpp"

#include "surrogate/model_file.hpp"
#include "surrogate/self_test.hpp"
#include "surrogate/serving.hpp"

namespace sandgraph::surrogate {

std::unique_ptr<stress::Surrogate> make_surrogate(const Model& model) {
    return std::make_unique<Serving>(model);
}

std::unique_ptr<stress::Surrogate> load_surrogate(const std::filesystem::path& path) {
    const ModelRecord record = read_model(path);
    auto law = make_surrogate(record.model);
    check_self_test(record.model, *law, record.self_test, path.string());
    check_physics(record.model, *law, path.string());
    return law;
}

}  // namespace sandgraph::surrogate
