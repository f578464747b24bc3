#pragma once
#include "graph/rve_pool.hpp"

namespace sandgraph::ranks {

// What a rank that does not own a packing knows of it.
struct KnownPacking {
    Mat2 stress = Mat2::Zero();  // as RvePool::stress
    double strain_per_step = 0, porosity = 0;
    bool floating = false;
    bool owning = false;  // it has been driven
};
KnownPacking known(const graph::RvePool& pool, std::size_t rve);

// The answer to one job as it travels: of a length that follows from the job alone, so that all ranks know
// the lengths of all messages beforehand. `caps`: updates may stop on their way (RveOptions::steps_max).
std::size_t record_bytes(const graph::RveJob& job, bool caps);
void put_record(const graph::RveJob& job, const graph::RveAnswer& answer, const KnownPacking& packing,
                bool caps, ByteWriter& out);
// Brings the job's path to where its packing stands, too.
void take_record(const graph::RveJob& job, bool caps, ByteReader& in, graph::RveAnswer& answer,
                 KnownPacking& packing);

}  // namespace sandgraph::ranks
