#include "ranks/beginning.hpp"

#include "base/byte_stream.hpp"

namespace sandgraph::ranks {
namespace {

void put(ByteWriter& out, const std::string& text) {
    out.put(static_cast<std::uint64_t>(text.size())), out.put(std::span<const char>(text));
}

std::string text(ByteReader& in) {
    std::vector<char> read;
    in.take(read);
    return {read.begin(), read.end()};
}

}  // namespace

Bytes packed(const Beginning& run) {
    Bytes bytes;
    ByteWriter out(bytes);
    for (const std::string* word : {&run.request.scene, &run.request.mode, &run.folder, &run.scene_hash})
        put(out, *word);
    out.put(std::int32_t{run.threads}), out.put(run.resume), out.put(run.until);
    out.put(static_cast<std::uint64_t>(run.request.set.size()));
    for (const std::string& assignment : run.request.set) put(out, assignment);
    return bytes;
}

Beginning unpacked(ByteSpan bytes) {
    ByteReader in(bytes);
    Beginning run;
    for (std::string* word : {&run.request.scene, &run.request.mode, &run.folder, &run.scene_hash})
        *word = text(in);
    std::uint64_t overrides = 0;
    in.take(run.threads), in.take(run.resume), in.take(run.until), in.take(overrides);
    for (std::uint64_t k = 0; k < overrides; ++k) run.request.set.push_back(text(in));
    return run;
}

}  // namespace sandgraph::ranks
