#include "ranks/answer_record.hpp"

#include "base/contracts.hpp"

namespace sandgraph::ranks {
namespace {

using graph::RveAnswer, graph::RveJob;

constexpr std::size_t kMatrix = 4 * sizeof(double);
constexpr std::size_t kPlain = 2 + sizeof(std::int32_t) + 4 * sizeof(double) + kMatrix;
constexpr std::size_t kNumbers = 12;  // of what a packing shows, beside two matrices and a count
constexpr std::size_t kSeen = 2 * kMatrix + sizeof(std::int32_t) + kNumbers * sizeof(double);
constexpr std::size_t kPlace = kMatrix + sizeof(std::uint32_t);

enum Flag : std::uint8_t { unfinished = 1, caught_up = 2, floating = 4, owning = 8 };

bool may_stop(const RveJob& job, bool caps) { return caps && job.may_wait; }

void put(ByteWriter& out, const Mat2& m) { out.put(std::span<const double>(m.data(), 4)); }
void take(ByteReader& in, Mat2& m) { in.take(std::span<double>(m.data(), 4)); }

// A new member does not compile until it travels, too.
template <class Observables, class Visit>
void each_part(Observables& seen, const Visit& visit) {
    auto& [stress, fabric, porosity, contacts, coordination, mechanical, anisotropy, sliding, normal,
           tangential, rolling, translation, turning, overlap, unbalanced] = seen;
    visit(stress), visit(fabric), visit(contacts);
    for (auto* number : {&porosity, &coordination, &mechanical, &anisotropy, &sliding, &normal, &tangential,
                         &rolling, &translation, &turning, &overlap, &unbalanced})
        visit(*number);
}

void put(ByteWriter& out, int count) { out.put(std::int32_t{count}); }
void put(ByteWriter& out, double number) { out.put(number); }
void take(ByteReader& in, int& count) { in.take(count); }
void take(ByteReader& in, double& number) { in.take(number); }

void put(ByteWriter& out, const dem::Observables& seen) {
    each_part(seen, [&](const auto& part) { put(out, part); });
}
void take(ByteReader& in, dem::Observables& seen) {
    each_part(seen, [&](auto& part) { take(in, part); });
}

std::uint8_t flags_of(const RveAnswer& a, const KnownPacking& p) {
    return static_cast<std::uint8_t>((a.report.unfinished ? unfinished : 0) | (a.caught_up ? caught_up : 0) |
                                     (p.floating ? floating : 0) | (p.owning ? owning : 0));
}

void take_flags(std::uint8_t flags, RveAnswer& a, KnownPacking& p) {
    a.report.unfinished = flags & unfinished, a.caught_up = flags & caught_up;
    p.floating = flags & floating, p.owning = flags & owning;
}

}  // namespace

KnownPacking known(const graph::RvePool& pool, std::size_t rve) {
    return {pool.stress(rve), pool.strain_per_step(rve), pool.porosity(rve), pool.floating(rve),
            pool.rve(rve).owns_packing()};
}

std::size_t record_bytes(const RveJob& job, bool caps) {
    return kPlain + (may_stop(job, caps) ? kMatrix : 0) + (job.path ? kPlace : 0) +
           (job.observed ? kSeen : 0);
}

void put_record(const RveJob& job, const RveAnswer& a, const KnownPacking& p, bool caps, ByteWriter& out) {
    SG_EXPECT(a.seen.has_value() == job.observed);
    out.put(a.report.status), out.put(flags_of(a, p));
    out.put(std::int32_t{a.report.dem_steps}), out.put(a.report.inertial_number);
    out.put(a.volume_ratio), out.put(p.strain_per_step), out.put(p.porosity);
    put(out, a.stress);
    if (may_stop(job, caps)) put(out, a.to_follow);
    if (job.path) put(out, job.path->place().driven), out.put(job.path->place().knots);
    if (job.observed) put(out, *a.seen);
}

void take_record(const RveJob& job, bool caps, ByteReader& in, RveAnswer& a, KnownPacking& p) {
    a = {};
    std::uint8_t flags = 0;
    in.take(a.report.status), in.take(flags), take_flags(flags, a, p);
    in.take(a.report.dem_steps), in.take(a.report.inertial_number);
    in.take(a.volume_ratio), in.take(p.strain_per_step), in.take(p.porosity);
    take(in, a.stress), p.stress = a.stress;
    if (may_stop(job, caps)) take(in, a.to_follow);
    if (job.path) {
        graph::StrainPath::Place place;
        take(in, place.driven), in.take(place.knots);
        job.path->follow(place);
    }
    if (job.observed) take(in, a.seen.emplace());
}

}  // namespace sandgraph::ranks
