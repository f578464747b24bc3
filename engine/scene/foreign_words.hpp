#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace sandgraph::scene {

// What to say of a key that users of other codes would try.
struct ForeignWord {
    std::string why;     // there is no such key
    std::string advice;  // what to write instead
};

inline constexpr std::string_view any_table = "*";

// Of a key of `table` ("": at the top, or a table itself), or of `any_table`. Case, '_', '-' and blanks do
// not count. None for a word that nobody is known to try there.
std::optional<ForeignWord> foreign_word(std::string_view table, std::string_view name);

}  // namespace sandgraph::scene
