#pragma once
#include <span>
#include <string>
#include <string_view>

namespace sandgraph {

// Restricted Damerau-Levenshtein distance: insertions, deletions, substitutions and swaps of neighbours, 1
// each.
int edit_distance(std::string_view a, std::string_view b);

// The known name nearest to `word`, the first of equals; empty if `known` is.
std::string nearest_name(std::string_view word, std::span<const std::string> known);

// `did you mean "name"?` where the nearest name is near enough to be a slip of the keys; else `otherwise`.
std::string did_you_mean(std::string_view word, std::span<const std::string> known,
                         const std::string& otherwise);

// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

// For XML and HTML, element or attribute in double quotes: & < > and " as entities.
std::string xml_escaped(std::string_view text);

}  // namespace sandgraph
