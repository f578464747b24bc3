#include "base/byte_stream.hpp"
#include "graph/rve_law.hpp"

namespace sandgraph::graph {

void confirm_packings(Archive& a, const std::vector<RowPacking>& rows) {
    std::vector<std::int64_t> hashes;
    for (const RowPacking& row : rows) hashes.push_back(dem::content_hash(*row.packing));
    std::vector<std::int64_t> read = hashes;
    a.field("initial_packings", read);
    require_state(read == hashes, "initial packings");
}

void RveLaw::archive(Archive& a) {
    confirm_packings(a, setup_.rows);
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
