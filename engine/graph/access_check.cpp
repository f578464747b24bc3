#include "graph/access_check.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "base/hash.hpp"

namespace sandgraph::graph {
namespace {

template <class T>
void add(Hasher& hash, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    hash.add(std::as_bytes(std::span<const T>(&value, 1)));
}

template <class T>
void add(Hasher& hash, const std::vector<T>& values) {
    hash.add(std::as_bytes(std::span<const T>(values)));
}

void add(Hasher& hash, const std::vector<Mat2>& values) {
    for (const Mat2& m : values) hash.add(std::as_bytes(std::span<const double>(m.data(), 4)));
}

template <class... Parts>
std::uint64_t hash_of(const Parts&... parts) {
    Hasher hash;
    (add(hash, parts), ...);
    return hash.value();
}

// Everything that is archived, in one number.
class Digest final : public Archive {
  public:
    bool reading() const override { return false; }
    void field(std::string_view, std::vector<double>& values) override { add(hash_, values); }
    void field(std::string_view, std::vector<std::int64_t>& values) override { add(hash_, values); }
    void field(std::string_view, std::vector<std::uint8_t>& values) override { add(hash_, values); }
    std::uint64_t value() const { return hash_.value(); }

  private:
    Hasher hash_;
};

std::uint64_t contact_of(const GroundState& s) {
    Hasher hash;
    for (const Body& body : s.bodies) {
        add(hash, body.contact.slip), add(hash, body.contact.sunk), add(hash, body.contact.face);
        for (const Vec2& force : body.contact.reaction.on) add(hash, force.x()), add(hash, force.y());
        for (const mpm::ContactPoint& t : body.contact.points)
            add(hash, t.point), add(hash, t.penetration), add(hash, t.length);
    }
    return hash.value();
}

std::uint64_t bodies_of(GroundState& s) {
    Digest digest;
    for (Body& body : s.bodies) mpm::archive(digest, body.plate);
    return digest.value();
}

std::uint64_t law_of(GroundState& s) {
    Digest digest;
    s.law->archive(digest);
    return digest.value();
}

std::uint64_t grid_of(const mpm::Grid& g) {
    Hasher hash;
    for (const mpm::Field& f : g.fields)
        add(hash, f.nodes), add(hash, f.motion), add(hash, f.box.i0), add(hash, f.box.i1),
            add(hash, f.box.j0), add(hash, f.box.j1);
    for (const mpm::Enrichment& cut : g.cuts) add(hash, cut.level), add(hash, cut.low), add(hash, cut.high);
    return hash.value();
}

// What a law keeps for itself.
bool inside_law(Data data) {
    return data == Data::visits || data == Data::due || data == Data::answers || data == Data::packings ||
           data == Data::law;
}

bool declared(const Phase& phase, Data data) {
    return std::ranges::any_of(phase.writes, [&](const Version& v) {
        return v.data == data || (inside_law(data) && inside_law(v.data));
    });
}

}  // namespace

std::array<std::uint64_t, stress::data_count> fingerprints(GroundState& s) {
    std::array<std::uint64_t, stress::data_count> out{};
    const auto at = [&](Data data) -> std::uint64_t& { return out[static_cast<std::size_t>(data)]; };
    const mpm::Points& p = s.points;
    at(Data::points) = hash_of(p.x, p.y, p.vx, p.vy, p.mass, p.volume0, p.volume, p.F);
    at(Data::increments) = hash_of(p.F_inc);
    at(Data::stress) = hash_of(p.stress);
    at(Data::order) = hash_of(s.order.ids, s.order.first, s.order.near, s.order.is_near, s.order.stale);
    at(Data::grid) = grid_of(s.grid);
    at(Data::bodies) = bodies_of(s);
    at(Data::contact) = contact_of(s);
    at(Data::energy) = hash_of(s.stress_work, s.work_before, s.node_work.damping, s.node_work.gained);
    for (const Data data : {Data::visits, Data::due, Data::answers, Data::packings, Data::law})
        at(data) = data == Data::visits ? law_of(s) : at(Data::visits);
    return out;
}

void run_checked(const std::vector<Phase>& phases, GroundState& state) {
    auto before = fingerprints(state);
    for (const std::size_t k : serial_order(predecessors(phases))) {
        phases[k].run();
        const auto after = fingerprints(state);
        for (std::size_t d = 0; d < after.size(); ++d)
            if (const auto data = static_cast<Data>(d); after[d] != before[d] && !declared(phases[k], data))
                throw std::logic_error("the phase \"" + phases[k].name + "\" changes " +
                                       stress::name_of(data) + " and does not say so");
        before = after;
    }
}

}  // namespace sandgraph::graph
