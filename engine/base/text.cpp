#include "base/text.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "base/contracts.hpp"

namespace sandgraph {

int edit_distance(std::string_view a, std::string_view b) {
    std::vector<int> before_last, last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int change = last[j - 1] + (a[i - 1] != b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        before_last = std::exchange(last, row);
    }
    SG_ENSURE(last.back() >= 0 && last.back() <= static_cast<int>(std::max(a.size(), b.size())));
    return last.back();
}

std::string nearest_name(std::string_view word, std::span<const std::string> known) {
    const auto nearest = std::ranges::min_element(
        known, {}, [&](const std::string& name) { return edit_distance(word, name); });
    return nearest == known.end() ? std::string{} : *nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known,
                         const std::string& otherwise) {
    const std::string nearest = nearest_name(word, known);
    const auto longer = static_cast<int>(std::max(word.size(), nearest.size()));
    const bool slip = !nearest.empty() && 2 * edit_distance(word, nearest) <= longer;
    return slip ? "did you mean \"" + nearest + "\"?" : otherwise;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string xml_escaped(std::string_view text) {
    std::string out;
    for (const char c : text) switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    return out;
}

}  // namespace sandgraph
