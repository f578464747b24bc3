#include "training/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/contracts.hpp"

namespace sandgraph::training {
namespace {

std::map<std::int64_t, double> by_history(std::span<const ErrorSample> samples) {
    std::map<std::int64_t, double> sum, count;
    for (const ErrorSample& s : samples)  // not a number counts as wholly wrong
        sum[s.history] += s.error < 1 ? s.error : 1, count[s.history] += 1;
    for (auto& [history, value] : sum) value /= count[history];
    return sum;
}

const char* word(const Comparison& c) {
    if (c.histories < 2) return "too few to tell";
    return c.better() ? "better" : c.worse() ? "worse" : "no different";
}

}  // namespace

Comparison compare(std::string data, std::span<const ErrorSample> before,
                   std::span<const ErrorSample> after) {
    const std::map<std::int64_t, double> old_errors = by_history(before), new_errors = by_history(after);
    SG_EXPECT(!old_errors.empty() && old_errors.size() == new_errors.size());
    const auto n = static_cast<double>(old_errors.size());
    Comparison out{std::move(data), old_errors.size()};
    for (const auto& [history, error] : old_errors) {
        out.before += error / n, out.after += new_errors.at(history) / n;
    }
    out.change = out.after - out.before;
    double squares = 0;
    for (const auto& [history, error] : old_errors)
        squares += std::pow(new_errors.at(history) - error - out.change, 2);
    out.interval = n > 1 ? 2 * std::sqrt(squares / (n - 1) / n) : std::numeric_limits<double>::infinity();
    return out;
}

std::string verdict(const Comparison& held_out, const Comparison& guard, const std::string& start) {
    const bool forgets = guard.histories > 0 && guard.worse();
    if (held_out.histories == 0) return fmt::format("nothing was held out: is it better than {}?", start);
    if (held_out.better() && forgets)
        return fmt::format("better than {} on these logs, but it has forgotten: worse on the shipped probes",
                           start);
    if (held_out.better())
        return fmt::format("better than {}{}", start,
                           guard.histories > 0
                               ? ", and nothing is forgotten"
                               : " on these logs; no shipped probes to tell what it has forgotten");
    return fmt::format("{} {}: keep that one", held_out.worse() || forgets ? "worse than" : "no better than",
                       start);
}

std::string comparison_text(const Comparison& c) {
    return fmt::format(
        "{:<32} {:4} histories: mean error {:.4f} -> {:.4f} of p, change {:+.4f} +- {:.4f}: {}\n", c.data,
        c.histories, c.before, c.after, c.change, c.interval, word(c));
}

}  // namespace sandgraph::training
