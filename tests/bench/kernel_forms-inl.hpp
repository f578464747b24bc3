// Other formulations of the contact force loop, in the kernel's own parts; included once per instruction set.
#if defined(SANDGRAPH_KERNEL_FORMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SANDGRAPH_KERNEL_FORMS_INL
#undef SANDGRAPH_KERNEL_FORMS_INL
#else
#define SANDGRAPH_KERNEL_FORMS_INL
#endif

#include "dem/fast/forces-inl.hpp"
#include "tests/bench/grain_contacts.hpp"

HWY_BEFORE_NAMESPACE();
namespace sandgraph::dem::HWY_NAMESPACE {

// Differences of the records go through memory and are taken up lane by lane: the kernel until this bench.
struct StagedSource {
    alignas(64) double geometry[4 * kBlock], rotation[4 * kBlock];
    StagedSource(const Arrays& s, const ImageTable& images, int first, int count) {
        const D4 d;
        for (int c = 0; c < count; ++c) {
            const double *a = s.record + kRecord * std::size_t{s.i[first + c]},
                         *b = s.record + kRecord * std::size_t{s.j[first + c]},
                         *shift = images.shift + kRecord * std::size_t{s.image[first + c]};
            for (std::size_t k = 0; k < 4; k += hn::Lanes(d)) {
                const auto pair = hn::Sub(hn::Load(d, b + k), hn::Load(d, a + k));
                hn::Store(hn::Add(pair, hn::Load(d, shift + k)), d, geometry + 4 * c + k);
                hn::Store(
                    hn::MulAdd(hn::Load(d, kSign + 4 + k), hn::Load(d, a + 4 + k), hn::Load(d, b + 4 + k)), d,
                    rotation + 4 * c + k);
            }
        }
    }
    HWY_INLINE Lanes Load(int c) const {
        Lanes p;
        hn::LoadInterleaved4(D(), geometry + 4 * c, p.dx, p.dy, p.dvx, p.dvy);
        hn::LoadInterleaved4(D(), rotation + 4 * c, p.r_sum, p.rw_sum, p.dw, p.r_diff);
        return p;
    }
};

void StagedForces(FastState& s, const KernelConstants& k, double dt) {
    std::fill(s.force.begin(), s.force.end(), 0.0);
    const ImageTable images(s);
    const Arrays arrays(s);
    const LawLanes law(k, dt);
    alignas(64) double force[4 * kBlock];
    for (int first = 0; first < s.slots; first += kBlock) {
        const int count = std::min(kBlock, s.slots - first);
        const StagedSource source(arrays, images, first, count);
        ContactLaw<false>(source, arrays, law, first, count, force, nullptr);
        Scatter(arrays, first, count, force);
    }
}

// The law without the scatter: what the rest costs.
void LawOnly(FastState& s, const KernelConstants& k, double dt) {
    const ImageTable images(s);
    const Arrays arrays(s);
    const LawLanes law(k, dt);
    PairBuffers buffers;
    const auto pass = [&]<bool kWrapped>(int begin, int end) {
        for (int first = begin; first < end; first += kBlock) {
            const int count = std::min(kBlock, end - first);
            const PairSource<kWrapped> source(arrays, images, first, count, buffers);
            ContactLaw<false>(source, arrays, law, first, count, buffers.force, nullptr);
        }
    };
    pass.template operator()<false>(0, s.inner);
    pass.template operator()<true>(s.inner, s.slots);
}

// Two RVEs in turn, block by block: independent work to fill the waits with.
void TwoRves(FastState& s, FastState& t, const KernelConstants& k, double dt) {
    const LawLanes law(k, dt);
    PairBuffers buffers;
    FastState* const states[2] = {&s, &t};
    const ImageTable images[2] = {ImageTable(s), ImageTable(t)};
    const Arrays arrays[2] = {Arrays(s), Arrays(t)};
    for (FastState* state : states) std::fill(state->force.begin(), state->force.end(), 0.0);
    constexpr int kSmall = 16;
    for (int first = 0; first < std::max(s.slots, t.slots); first += kSmall)
        for (int rve = 0; rve < 2; ++rve) {
            const int count = std::min(kSmall, states[rve]->slots - first);
            if (count <= 0) continue;
            const PairSource<true> source(arrays[rve], images[rve], first, count, buffers);
            ContactLaw<false>(source, arrays[rve], law, first, count, buffers.force, nullptr);
            Scatter(arrays[rve], first, count, buffers.force);
        }
}

// The law on all pairs, forces kept by pair; then every grain adds up its own. No read-modify-write.
void ForceGather(FastState& s, const KernelConstants& k, double dt, GrainContacts& g) {
    const ImageTable images(s);
    const Arrays arrays(s);
    const LawLanes law(k, dt);
    PairBuffers buffers;
    for (int first = 0; first < s.slots; first += kBlock) {
        const int count = std::min(kBlock, s.slots - first);
        if (first + count <= s.inner)
            ContactLaw<false>(PairSource<false>(arrays, images, first, count, buffers), arrays, law, first,
                              count, g.pair_force.data() + 4 * first, nullptr);
        else
            ContactLaw<false>(PairSource<true>(arrays, images, first, count, buffers), arrays, law, first,
                              count, g.pair_force.data() + 4 * first, nullptr);
    }
    const D4 d;
    alignas(64) static constexpr double kOn[8] = {1, 1, 1, 1, -1, -1, 1, -1};
    const std::uint16_t* entry = g.entries.data();
    std::size_t place = 0;
    for (const GrainContacts::Class& group : g.classes)
        for (int n = 0; n < group.grains; ++n, entry += group.contacts, ++place)
            for (std::size_t part = 0; part < 4; part += hn::Lanes(d)) {
                auto sum = hn::Zero(d);
                for (int c = 0; c < group.contacts; ++c)
                    sum = hn::MulAdd(
                        ForceOf(&g.pair_force[32 * std::size_t(entry[c] / 16)], entry[c] / 2 % 8, part),
                        hn::Load(d, kOn + 4 * (entry[c] % 2) + part), sum);
                hn::Store(sum, d, &s.force[4 * std::size_t{g.order[place]} + part]);
            }
}

#if HWY_MAX_BYTES == 64
// Columns of eight records, `record(l)` where that of lane l lies.
template <class Record>
HWY_INLINE void RecordColumns(const Record& record, V* column) {
    V geometry[4], rotation[4];
    for (int k = 0; k < 4; ++k) {
        const double *a = record(JoinedRow(k)), *b = record(JoinedRow(k) + 2);
        geometry[k] = Join(a, b), rotation[k] = Join(a + 4, b + 4);
    }
    Columns(geometry, column), Columns(rotation, column + 4);
}

// Every lane is a grain that visits its own contacts: each pair is worked out twice, but nothing is
// scattered.
void GrainGather(FastState& s, const KernelConstants& k, double dt, GrainContacts& g) {
    const D d;
    const ImageTable images(s);
    const LawLanes law(k, dt);
    for (std::size_t first = 0, at = 0; first < g.lanes_order.size(); first += 8) {
        V own[8], sum[4] = {hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
        RecordColumns([&](int l) { return s.grain(g.lanes_order[first + l]); }, own);
        for (int c = 0; c < g.lanes_contacts[first / 8]; ++c, at += 8) {
            V other[8], shift[8];
            RecordColumns([&](int l) { return s.grain(g.partner[at + l]); }, other);
            RecordColumns(
                [&](int l) { return images.shift + kRecord * std::size_t{g.partner_image[at + l]}; }, shift);
            for (int k = 0; k < 4; ++k) other[k] = hn::Add(other[k], shift[k]);
            const Lanes p{hn::Sub(other[0], own[0]), hn::Sub(other[1], own[1]), hn::Sub(other[2], own[2]),
                          hn::Sub(other[3], own[3]), hn::Add(other[4], own[4]), hn::Add(other[5], own[5]),
                          hn::Sub(other[6], own[6]), hn::Sub(other[7], own[7])};
            const Normal n(p, law);
            const V ft = Tangential(p, n, law, &g.tangential[at]), m = Rolling(p, n, law, &g.moment[at]);
            const V half_ft = hn::Mul(hn::Set(d, 0.5), ft);
            sum[0] = hn::Sub(sum[0], hn::MulAdd(n.fn, n.nx, hn::Mul(ft, n.ny)));
            sum[1] = hn::Sub(sum[1], hn::NegMulAdd(ft, n.nx, hn::Mul(n.fn, n.ny)));
            sum[2] = hn::MulAdd(half_ft, n.dist, sum[2]);
            sum[3] = hn::Sub(sum[3], hn::MulAdd(half_ft, p.r_diff, m));
        }
        alignas(64) double out[32];
        hn::StoreInterleaved4(sum[0], sum[1], sum[2], sum[3], d, out);
        for (int l = 0; l < 8; ++l)
            std::copy(out + 4 * l, out + 4 * l + 4, &s.force[4 * g.lanes_order[first + l]]);
    }
}
#else
void GrainGather(FastState&, const KernelConstants&, double, GrainContacts&) {}
#endif

}  // namespace sandgraph::dem::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
