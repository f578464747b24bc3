#include "scene/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace sandgraph::scene {
namespace {

struct Kind {
    std::string_view name, command;
    std::vector<std::string_view> marks;  // names at the top of the file that no other kind has
};

// In the order of FileKind.
const std::array<Kind, 6>& kinds() {
    static const std::array<Kind, 6> all{{
        {"a scene",
         "sandgraph run {}",
         {"domain", "anchor", "ground", "continuum", "mpm", "output", "surrogate", "gate", "audit",
          "region"}},
        {"an element test", "sandgraph rve test {} --packing P.h5", {"kind", "segment", "segments"}},
        {"a packing recipe", "sandgraph rve prepare {} -o P.h5", {"pressure"}},
        {"a probe recipe", "sandgraph rve probe {} -o LOG.h5", {"packings", "paths"}},
        {"a training recipe", "sandgraph train {} -o MODEL.h5", {"data", "model", "training", "steps"}},
        {"a sweep", "sandgraph sweep {} -o DIR", {"scene", "axis", "rows", "samples", "combine"}},
    }};
    return all;
}

const toml::node* mark_of(const toml::table& table, const Kind& kind) {
    for (const std::string_view mark : kind.marks)
        if (const toml::node* node = table.get(mark)) return node;
    return nullptr;
}

}  // namespace

void require_kind(const toml::table& table, const std::string& file, FileKind wanted) {
    const Kind& right = kinds()[static_cast<std::size_t>(wanted)];
    if (mark_of(table, right)) return;
    for (const Kind& kind : kinds())
        if (const toml::node* mark = mark_of(table, kind))
            throw InputError({file, static_cast<int>(mark->source().begin.line)},
                             fmt::format("this is {}, not {}", kind.name, right.name),
                             "only such files have what stands here",
                             "give it to: " + fmt::format(fmt::runtime(kind.command), file));
}

}  // namespace sandgraph::scene
