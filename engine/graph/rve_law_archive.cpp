#include "base/byte_stream.hpp"
#include "graph/rve_law.hpp"

namespace sandgraph::graph {

void RveLaw::archive(Archive& a) {
    std::vector<std::uint8_t> bytes;
    if (!a.reading()) {
        ByteWriter out(bytes);
        out.put(counters_);
        visits_.save(out);
        for (const dem::Rve& r : rves_) r.save(out);
    }
    a.field("rve", bytes);
    if (!a.reading()) return;
    ByteReader in(bytes);
    in.take(counters_);
    visits_.load(in);
    for (dem::Rve& r : rves_) r.load(in);
    require_state(in.empty(), "lengths");
}

}  // namespace sandgraph::graph
