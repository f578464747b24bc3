#include "training/error_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "base/contracts.hpp"

namespace sandgraph::training {
namespace {

struct Band {
    const char* name;
    double above;
};
constexpr std::array<Band, 4> strain_bands = {
    {{"strain < 0.1 %", 0}, {"strain 0.1-1 %", 1e-3}, {"strain 1-5 %", 1e-2}, {"strain > 5 %", 5e-2}}};
constexpr std::array<Band, 4> pressure_bands = {
    {{"p0 < 3 kPa", 0}, {"p0 3-20 kPa", 3e3}, {"p0 20-160 kPa", 20e3}, {"p0 > 160 kPa", 160e3}}};
constexpr std::array<Band, 3> density_bands = {
    {{"dense (n < 0.17)", 0}, {"medium (n 0.17-0.19)", 0.17}, {"loose (n > 0.19)", 0.19}}};

template <std::size_t N>
std::size_t band(const std::array<Band, N>& bands, double value) {
    std::size_t k = 0;
    while (k + 1 < N && value >= bands[k + 1].above) ++k;
    return k;
}

ErrorRow row_of(std::string regime, const std::vector<ErrorSample>& samples) {
    SG_EXPECT(!samples.empty());
    std::vector<double> errors;
    double p = 0, q = 0;
    for (const ErrorSample& s : samples) {
        errors.push_back(s.error);
        p += std::clamp(s.p, -1.0, 1.0), q += std::clamp(s.q, -1.0, 1.0);
    }
    std::ranges::sort(errors);
    const auto n = static_cast<double>(errors.size());
    const auto at = [&](double share) {
        return errors[std::min(errors.size() - 1, static_cast<std::size_t>(share * n))];
    };
    return {std::move(regime), errors.size(), at(0.5), at(0.95), errors.back(), p / n, q / n};
}

}  // namespace

std::vector<ErrorRow> error_rows(const HistorySet& set, std::span<const ErrorSample> samples) {
    std::map<std::pair<int, std::size_t>, std::pair<std::string, std::vector<ErrorSample>>> groups;
    const auto put = [&](int kind, std::size_t index, std::string name, const ErrorSample& sample) {
        auto& group = groups[{kind, index}];
        group.first = std::move(name);
        group.second.push_back(sample);
    };
    for (const ErrorSample& s : samples) {
        const History& history = set.histories[s.history];
        const io::HistoryPacking& start = set.start_of(history);
        const std::size_t strain = band(strain_bands, s.strain);
        const std::size_t density = band(density_bands, start.target_porosity);
        const std::size_t pressure = band(pressure_bands, start.traits.pressure);
        put(0, 0, "all", s);
        put(1, strain, strain_bands[strain].name, s);
        put(2, density, density_bands[density].name, s);
        put(3, pressure, pressure_bands[pressure].name, s);
        put(4, static_cast<std::size_t>(history.info.path),
            std::string("path ") + io::name(history.info.path), s);
    }
    std::vector<ErrorRow> rows;
    for (auto& [key, group] : groups) rows.push_back(row_of(group.first, group.second));
    return rows;
}

std::string error_text(std::span<const ErrorTable> tables) {
    std::string text;
    for (const ErrorTable& table : tables) {
        text += fmt::format("\n{} on {}\n{:26}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", table.of, table.data,
                            "error, share of p", "samples", "50 %", "95 %", "worst", "p bias", "q bias");
        for (const ErrorRow& r : table.rows)
            text += fmt::format("{:26}{:9}{:9.4f}{:9.4f}{:9.3f}{:9.4f}{:9.4f}\n", r.regime, r.samples,
                                r.median, r.high, r.worst, r.p_bias, r.q_bias);
    }
    return text;
}

std::string error_csv(std::span<const ErrorTable> tables) {
    std::string text = "of,data,regime,samples,p50,p95,worst,p_bias,q_bias\n";
    for (const ErrorTable& table : tables)
        for (const ErrorRow& r : table.rows)
            text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", table.of, table.data,
                                r.regime, r.samples, r.median, r.high, r.worst, r.p_bias, r.q_bias);
    return text;
}

}  // namespace sandgraph::training
