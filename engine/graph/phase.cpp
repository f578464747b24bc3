#include "graph/phase.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>

namespace sandgraph::graph {
namespace {

using stress::data_count;

std::string text(const Version& v) {
    return std::string(stress::name_of(v.data)) + " " + std::to_string(v.of);
}

std::size_t index(Data data) { return static_cast<std::size_t>(data); }

// Who writes which version of a datum: [data][version - 1].
class Writers {
  public:
    explicit Writers(const std::vector<Phase>& phases) {
        for (std::size_t k = 0; k < phases.size(); ++k)
            for (const Version& v : phases[k].writes) add(v, k, phases);
        for (const auto& of_data : writer_)
            for (const auto& [version, phase] : of_data)
                if (version > 1 && !of_data.contains(version - 1))
                    throw std::logic_error(phases[phase].name + " writes a version of " +
                                           stress::name_of(static_cast<Data>(&of_data - writer_.data())) +
                                           " that follows none");
    }
    int last(Data data) const {
        const auto& of_data = writer_[index(data)];
        return of_data.empty() ? 0 : of_data.rbegin()->first;
    }
    // Of version 0, and of one past the last: nobody.
    std::optional<std::size_t> of(const Version& v) const {
        const auto found = writer_[index(v.data)].find(v.of);
        return found == writer_[index(v.data)].end() ? std::nullopt : std::optional(found->second);
    }

  private:
    void add(const Version& v, std::size_t phase, const std::vector<Phase>& phases) {
        if (v.of < 1 || v.of >= settled) throw std::logic_error(phases[phase].name + " writes " + text(v));
        const auto [place, fresh] = writer_[index(v.data)].emplace(v.of, phase);
        if (!fresh)
            throw std::logic_error("two phases of a step write " + text(v) + ": " +
                                   phases[place->second].name + " and " + phases[phase].name);
    }
    std::array<std::map<int, std::size_t>, data_count> writer_;
};

// The version that a phase means.
Version meant(Version v, const Writers& writers) {
    return {v.data, v.of == settled ? writers.last(v.data) : v.of};
}

void wait(std::vector<std::size_t>& before, std::optional<std::size_t> other, std::size_t self) {
    if (other && *other != self) before.push_back(*other);
}

void add_edges(std::size_t k, const std::vector<Phase>& phases, const Writers& writers,
               std::vector<std::vector<std::size_t>>& before) {
    for (const Version& read : phases[k].reads) {
        const Version v = meant(read, writers);
        if (v.of > 0 && !writers.of(v))
            throw std::logic_error(phases[k].name + " reads " + text(v) + ", which no phase writes");
        wait(before[k], writers.of(v), k);
        if (const auto next = writers.of({v.data, v.of + 1})) wait(before[*next], k, *next);
    }
    for (const Version& v : phases[k].writes) wait(before[k], writers.of({v.data, v.of - 1}), k);
}

}  // namespace

std::vector<std::vector<std::size_t>> predecessors(const std::vector<Phase>& phases) {
    const Writers writers(phases);
    std::vector<std::vector<std::size_t>> before(phases.size());
    for (std::size_t k = 0; k < phases.size(); ++k) add_edges(k, phases, writers, before);
    for (auto& list : before) {
        std::ranges::sort(list);
        list.erase(std::ranges::unique(list).begin(), list.end());
    }
    if (serial_order(before).size() < phases.size())
        throw std::logic_error("the phases of a step wait for each other");
    return before;
}

// Kahn's algorithm; shorter than the list when phases wait for each other.
std::vector<std::size_t> serial_order(const std::vector<std::vector<std::size_t>>& before) {
    std::vector<std::size_t> order;
    std::vector<bool> done(before.size(), false);
    const auto ready = [&](std::size_t k) {
        return !done[k] && std::ranges::all_of(before[k], [&](std::size_t b) { return done[b]; });
    };
    for (std::size_t k = 0; k < before.size();) {
        if (!ready(k)) {
            ++k;
            continue;
        }
        order.push_back(k), done[k] = true;
        k = 0;
    }
    return order;
}

}  // namespace sandgraph::graph
