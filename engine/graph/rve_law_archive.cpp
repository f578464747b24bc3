#include "base/byte_stream.hpp"
#include "graph/rve_law.hpp"

namespace sandgraph::graph {

void RveLaw::archive(Archive& a) {
    std::vector<std::uint8_t> bytes;
    if (!a.reading()) {
        ByteWriter out(bytes);
        out.put(counters_);
        out.put(change_), out.put(allowance_), out.put(waited_);
        for (std::size_t p = 0; p < rves_.size(); ++p) {
            out.put(std::span<const double>(collected_[p].data(), 4));
            rves_[p].save(out);
        }
    }
    a.field("rve", bytes);
    if (!a.reading()) return;
    ByteReader in(bytes);
    in.take(counters_);
    in.take(change_), in.take(allowance_), in.take(waited_);
    for (std::size_t p = 0; p < rves_.size(); ++p) {
        in.take(std::span<double>(collected_[p].data(), 4));
        rves_[p].load(in);
    }
}

}  // namespace sandgraph::graph
